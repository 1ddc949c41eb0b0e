// Driver: object names and execution. driver_reads.cpp decides which commands may be sent.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "render/context/gl.h"
#include "render/fixed/execute.h"
#include "render/fixed/fixed.h"
#include "render/fixed/freed_views.h"
#include "scene/command/command_set.h"
#include "scene/shape/written_out.h"
#include "scene/state/pixel_unpacking.h"

namespace twinlight::fixed {

namespace {

void generate_names(ObjectType type, GLsizei n, GLuint* names) {
    switch (type) {
        case ObjectType::kTexture: return glGenTextures(n, names);
        case ObjectType::kBuffer: return glGenBuffers(n, names);
        case ObjectType::kFramebuffer: return glGenFramebuffers(n, names);
        case ObjectType::kRenderbuffer: return glGenRenderbuffers(n, names);
        case ObjectType::kList: return;
    }
}

void delete_names(ObjectType type, const std::set<std::uint32_t>& names) {
    const std::vector<GLuint> list(names.begin(), names.end());
    const auto count = static_cast<GLsizei>(list.size());
    switch (type) {
        case ObjectType::kTexture: return glDeleteTextures(count, list.data());
        case ObjectType::kBuffer: return glDeleteBuffers(count, list.data());
        case ObjectType::kFramebuffer: return glDeleteFramebuffers(count, list.data());
        case ObjectType::kRenderbuffer: return glDeleteRenderbuffers(count, list.data());
        case ObjectType::kList: return;
    }
}

}  // namespace

Driver::Driver(int width, int height) : window_(draw_framebuffer()), width_(width), height_(height) {
    initial_.emplace(width, height);
}

Driver::~Driver() {
    if (selects_) {  // their buffers are freed with this object
        glRenderMode(GL_RENDER);
        glSelectBuffer(0, nullptr);
        glFeedbackBuffer(0, GL_2D, nullptr);
    }
    initial_.reset();  // a bound object would not be deleted at once
    if (draws_bitmaps_) {
        // Mesa keeps using a bitmap's textures, even deleted ones, until it draws vertices. This one is clipped.
        glBegin(GL_POINTS);
        glVertex4f(0, 0, 2, 1);
        glEnd();
        glFlush();
    }
    for (const auto& [type, names] : names_) delete_names(type, names.all);
    for (std::uint32_t list : lists_) glDeleteLists(list, 1);
}

std::uint32_t Driver::name_of(ObjectType type, std::uint32_t name) const {
    if (type == ObjectType::kFramebuffer && name == 0) return window_;
    if (type == ObjectType::kList || name == 0) return name;
    const auto names = names_.find(type);
    if (names == names_.end()) return 0;
    const auto found = names->second.driver_from_scene.find(name);
    return found == names->second.driver_from_scene.end() ? 0 : found->second;
}

// A name that is not used for another object of the scene: drivers reuse deleted names, but the scene's display lists
// may still contain them. 0 if the driver gives none (between glBegin and glEnd).
std::uint32_t Driver::new_name(ObjectType type) {
    GLuint name = 0;
    do {
        name = 0;
        generate_names(type, 1, &name);
    } while (name != 0 && !names_[type].all.insert(name).second);
    return name;
}

// glGenTextures, glGenBuffers, ...: gets a driver's name for each of the scene's names.
void Driver::generate(const Command& command) {
    const ObjectType type = *named_objects(command.sig().parameters[1]);
    if (command.number(0) <= 0) return executor_.execute(command);  // the driver's error
    for (double name : command.array()) {
        std::uint32_t& given = names_[type].driver_from_scene[static_cast<std::uint32_t>(name)];
        if (given == 0) given = new_name(type);
    }
}

namespace {

// The largest selection or feedback buffer. GL cuts off what does not fit, and a scene cannot use the values.
constexpr GLsizei kMostHitValues = 1 << 16;

// Queries with an answer of unknown length: they change nothing and are not sent.
constexpr CommandSet kQueries = CommandSet::of({"driver_only_query"});

}  // namespace

// The driver writes into our own buffers, which live as long as it may write.
void Driver::selection_buffer(GLsizei size) {
    selects_ = true;
    selection_.resize(kMostHitValues);
    glSelectBuffer(std::min(size, kMostHitValues), selection_.data());
}

void Driver::feedback_buffer(GLsizei size, GLenum type) {
    selects_ = true;
    feedback_.resize(kMostHitValues);
    glFeedbackBuffer(std::min(size, kMostHitValues), type, feedback_.data());
}

void Driver::execute(const Command& command) {
    if (kQueries.contains(command.id)) return;
    if (const auto written_out = gl_command_of(command)) return execute(*written_out);
    if (command.id == CommandId::pragma_mesh) {
        for (const Command& part : mesh_commands(command)) execute(part);
        return;
    }
    if (!may_send(command)) return;
    if ((command.id == CommandId::glAccum || command.id == CommandId::glClear) && accumulate(command)) return;
    switch (command.id) {
        case CommandId::glGenTextures:
        case CommandId::glGenFramebuffers:
        case CommandId::glGenRenderbuffers:
        case CommandId::glGenBuffers: return generate(command);
        case CommandId::glSelectBuffer: return selection_buffer(static_cast<GLsizei>(command.number(0)));
        case CommandId::glFeedbackBuffer:
            return feedback_buffer(static_cast<GLsizei>(command.number(0)), command.enumerant(1));
        case CommandId::glRenderMode: selects_ = true; break;
        case CommandId::glNewList:
            lists_.insert(command.enumerant(0));
            emptied_lists_.erase(command.enumerant(0));
            break;
        case CommandId::glDeleteLists: return delete_lists(command);
        case CommandId::glGenLists:
            // 5.4: the scene may use its own names for lists, so the driver's answer is not needed.
            if (command.number(0) > 0) return;
            break;
        default: break;
    }
    const bool scales_volume = command.id == CommandId::gluBuild3DMipmaps;
    // GLU (9.0.2) writes an image that it scales with the padding of GL_PACK_ALIGNMENT, into memory that has none.
    if (scales_volume) glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    if (scales_volume) glPixelStorei(GL_PACK_ALIGNMENT, 1);
    {
        std::optional<KeepsViews> views;
        if (command.id == CommandId::glBitmap && answers()) views.emplace(KeepsViews::Drawn::kBitmap);
        if (command.id == CommandId::glDrawPixels && answers()) views.emplace(KeepsViews::Drawn::kPixels);
        executor_.execute(translated(command));
    }
    if (scales_volume) glPopClientAttrib();
    end_bitmaps(command);
    if (command.id == CommandId::glEndList) empty_lists();
    arrays_may_differ_ |= command.sig().family == Family::kShape;  // shapes are sent by arrays
}

// Mesa (22.3) keeps bitmaps to draw several at once, and crashes if a textured one waits. So none may wait.
void Driver::end_bitmaps(const Command& command) {
    const bool is_bitmap = command.id == CommandId::glBitmap || command.id == CommandId::glDrawPixels ||
                           command.id == CommandId::glCopyPixels;
    draws_bitmaps_ |= is_bitmap;
    const bool may_draw = is_bitmap || command.id == CommandId::glCallList || command.id == CommandId::glCallLists;
    if (draws_bitmaps_ && may_draw && answers()) glFlush();
}

namespace {

GLint answer_of(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

// What glClear or glAccum would do in the driver's state.
template <class Item>
Item with_scissor(Item item) {
    item.scissor.enabled = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
    std::array<GLint, 4> box{};
    glGetIntegerv(GL_SCISSOR_BOX, box.data());
    item.scissor.box = {box[0], box[1], box[2], box[3]};
    return item;
}

}  // namespace

// Carries out glAccum, and glClear's part of it, if the driver's framebuffer has no accumulation buffer: framebuffer
// objects have none. Returns whether the command is done. In a display list nothing is accumulated.
bool Driver::accumulate(const Command& command) {
    const bool clears = command.id == CommandId::glClear;
    if (clears && (command.enumerant(0) & GL_ACCUM_BUFFER_BIT) == 0) return false;
    if (!answers() || is_compiling() || answer_of(GL_ACCUM_RED_BITS) > 0) return false;
    if (static_cast<GLenum>(answer_of(GL_RENDER_MODE)) != GL_RENDER) return false;
    if (answer_of(GL_DRAW_FRAMEBUFFER_BINDING) != static_cast<GLint>(window_)) return false;
    if (!accumulated_) accumulated_.emplace(width_, height_);
    if (clears) {
        Clear clear = with_scissor(Clear{.accumulation = true});
        std::array<GLfloat, 4> color{};
        glGetFloatv(GL_ACCUM_CLEAR_VALUE, color.data());
        clear.clear_accumulation = {color[0], color[1], color[2], color[3]};
        accumulated_->clear(clear);
        return false;  // it may clear other buffers too
    }
    const Enum op = command.enumerant(0);
    const bool is_known = op == GL_ACCUM || op == GL_LOAD || op == GL_ADD || op == GL_MULT || op == GL_RETURN;
    const auto has_room = [](GLenum depth, GLenum most) { return answer_of(depth) < answer_of(most); };
    if (!is_known || !has_room(GL_ATTRIB_STACK_DEPTH, GL_MAX_ATTRIB_STACK_DEPTH) ||
        !has_room(GL_CLIENT_ATTRIB_STACK_DEPTH, GL_MAX_CLIENT_ATTRIB_STACK_DEPTH))
        return false;
    Accumulate item = with_scissor(Accumulate{.op = op, .value = command.number(1)});
    std::array<GLboolean, 4> mask{};
    glGetBooleanv(GL_COLOR_WRITEMASK, mask.data());
    const bool draws_color = answer_of(GL_DRAW_BUFFER) != GL_NONE;
    for (std::size_t i = 0; i < mask.size(); ++i) item.color_mask[i] = draws_color && mask[i] == GL_TRUE;
    accumulated_->apply(item);
    return true;
}

// A driver may look for every name of the range, and there may be 2^31. So it gets only those that exist.
void Driver::delete_lists(const Command& command) {
    const double range = command.number(1), first = command.number(0);
    if (range < 0 || !answers()) return executor_.execute(command);  // the driver's error
    auto list = lists_.lower_bound(command.enumerant(0));
    while (list != lists_.end() && *list < first + range) {
        if (kept_lists_.contains(*list)) {
            emptied_lists_.insert(*list++);
            continue;
        }
        glDeleteLists(*list, 1);
        list = lists_.erase(list);
    }
    empty_lists();
}

void Driver::make_empty_lists(const std::vector<std::uint32_t>& names) {
    for (auto* lists : {&lists_, &kept_lists_, &emptied_lists_}) lists->insert(names.begin(), names.end());
    empty_lists();
}

void Driver::empty_lists() {
    if (emptied_lists_.empty() || is_compiling()) return;
    for (std::uint32_t list : std::exchange(emptied_lists_, {})) {
        glNewList(list, GL_COMPILE);
        glEndList();
    }
}

// The command with the driver's names instead of the scene's.
Command Driver::translated(const Command& command) {
    Command result = command;
    const std::vector<Parameter>& parameters = command.sig().parameters;
    if (command.id == CommandId::glDrawRangeElements) {
        // A driver may read all elements of the range, but an array may end earlier.
        const auto range = arrays_.index_range(command);
        result.arguments[1] = range.first;
        result.arguments[2] = range.second;
    }
    // Mesa looks for the image of this level beyond the end of its list of images. The last level has none either: a
    // texture large enough for one is beyond the budget of memory.
    const bool is_base_level = owner_of(command.id) == Owner::kTexture && command.arguments.size() == 3 &&
                               command.enumerant(1) == kGL_TEXTURE_BASE_LEVEL;
    if (is_base_level) result.arguments[2] = std::min<double>(command.number(2), kMaxTextureLevels - 1);
    // llvmpipe 22.3 crashes where it filters a texture of one dimension like that.
    const bool is_anisotropy_of_1d = owner_of(command.id) == Owner::kTexture && command.arguments.size() == 3 &&
                                     command.enumerant(0) == kGL_TEXTURE_1D &&
                                     command.enumerant(1) == kGL_TEXTURE_MAX_ANISOTROPY_EXT;
    if (is_anisotropy_of_1d) result.arguments[2] = std::min(command.number(2), 1.0);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].name == "internalformat" || parameters[i].name == "internalFormat") {
            double& format = result.arguments[command.first(i)];
            format = without_compression(format);
        }
        const auto type = named_objects(parameters[i]);
        if (!type || *type == ObjectType::kList) continue;
        const std::size_t first = command.first(i), end = first + command.count(i);
        for (std::size_t n = first; n < end; ++n) {
            const auto name = static_cast<std::uint32_t>(command.number(n));
            // OpenGL 3.0, section 4.4.1: glDeleteFramebuffers ignores 0, so 0 must not become the window's name.
            const bool is_binding = parameters[i].extent == Extent::kValue;
            std::uint32_t driver_name = name == 0 && !is_binding ? 0 : name_of(*type, name);
            // 3.8.12, 2.9: binding a name that was never generated creates an object.
            if (driver_name == 0 && name != 0 && is_binding) {
                driver_name = names_[*type].driver_from_scene[name] = new_name(*type);
            }
            result.arguments[n] = driver_name;
        }
    }
    return result;
}

}  // namespace twinlight::fixed
