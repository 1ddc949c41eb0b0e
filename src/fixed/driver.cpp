// Driver: the names of objects, and what a driver may read.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "context/gl.h"
#include "fixed/execute.h"
#include "fixed/fixed.h"
#include "state/lists.h"
#include "state/pixels.h"

namespace twinlight::fixed {

namespace {

void generate_names(ObjectType type, GLsizei n, GLuint* names) {
    if (type == ObjectType::kTexture) {
        glGenTextures(n, names);
    } else {
        glGenBuffers(n, names);
    }
}

void delete_names(ObjectType type, const std::set<std::uint32_t>& names) {
    const std::vector<GLuint> list(names.begin(), names.end());
    if (type == ObjectType::kTexture) {
        glDeleteTextures(static_cast<GLsizei>(list.size()), list.data());
    } else {
        glDeleteBuffers(static_cast<GLsizei>(list.size()), list.data());
    }
}

PixelStore unpacking() {
    const auto get = [](GLenum name) {
        GLint value = 0;
        glGetIntegerv(name, &value);
        return value;
    };
    PixelStore store;
    store.unpack_row_length = get(GL_UNPACK_ROW_LENGTH);
    store.unpack_skip_rows = get(GL_UNPACK_SKIP_ROWS);
    store.unpack_skip_pixels = get(GL_UNPACK_SKIP_PIXELS);
    store.unpack_alignment = std::max(1, get(GL_UNPACK_ALIGNMENT));
    return store;
}

// How many bytes a driver reads of the pixels; nothing for formats and types of which that is not known. It reads none of
// sizes below 0, which it refuses.
std::optional<std::size_t> bytes_read_of(const PixelSource& source) {
    if (source.width <= 0 || source.height <= 0) return 0;
    const bool is_index = source.format == kGL_COLOR_INDEX || source.format == kGL_STENCIL_INDEX;
    if (source.type == kGL_BITMAP && is_index) return bitmap_bytes(source.width, source.height, unpacking());
    if (const auto bytes = pixel_bytes_elsewhere(source.format, source.type)) {
        // As many as of one colour component.
        PixelSource same = source;
        same.format = kGL_LUMINANCE;
        return bytes_read(same, unpacking());
    }
    if (pixel_bytes(source.format, source.type)) return bytes_read(source, unpacking());
    const bool is_format = components_of(source.format) || pixel_bytes_elsewhere(source.format, kGL_UNSIGNED_BYTE);
    const bool is_type =
        pixel_bytes(kGL_RGB, source.type) || pixel_bytes(kGL_RGBA, source.type) || source.type == kGL_BITMAP;
    return is_format && is_type ? std::optional<std::size_t>(0) : std::nullopt;  // they do not go together: refused
}

// The size, the format and the type of the pixels that a command reads.
std::optional<PixelSource> pixels_of(const Command& c) {
    PixelSource source;
    const std::vector<Parameter>& parameters = c.sig().parameters;
    bool has_format = false;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].name == "width") source.width = static_cast<int>(c.number(i));
        if (parameters[i].name == "height") source.height = static_cast<int>(c.number(i));
        if (parameters[i].name == "format") source.format = c.enumerant(i);
        if (parameters[i].name == "type") source.type = c.enumerant(i);
        has_format |= parameters[i].name == "format";
    }
    return has_format ? std::optional(source) : std::nullopt;
}

}  // namespace

Driver::Driver(int width, int height) { initial_.emplace(width, height); }

Driver::~Driver() {
    if (selects_) {  // the buffers go with this
        glRenderMode(GL_RENDER);
        glSelectBuffer(0, nullptr);
        glFeedbackBuffer(0, GL_2D, nullptr);
    }
    initial_.reset();  // what is bound is not deleted at once
    for (const auto& [type, names] : names_) delete_names(type, names.all);
    for (std::uint32_t list : lists_) glDeleteLists(list, 1);
}

std::uint32_t Driver::name_of(ObjectType type, std::uint32_t name) const {
    if (type == ObjectType::kList || name == 0) return name;
    const auto names = names_.find(type);
    if (names == names_.end()) return 0;
    const auto found = names->second.driver_from_scene.find(name);
    return found == names->second.driver_from_scene.end() ? 0 : found->second;
}

// A name that stands for no other of the scene's: a driver may give one again that was deleted, but the scene's display
// lists may still hold it. 0 where the driver gives none (between glBegin and glEnd).
std::uint32_t Driver::new_name(ObjectType type) {
    GLuint name = 0;
    do {
        name = 0;
        generate_names(type, 1, &name);
    } while (name != 0 && !names_[type].all.insert(name).second);
    return name;
}

// glGenTextures, glGenBuffers: a name of the driver's for each of the scene's.
void Driver::generate(const Command& command) {
    const ObjectType type = *named_objects(command.sig().parameters[1]);
    if (command.number(0) <= 0) return executor_.execute(command);  // the driver's error
    for (double name : command.array()) {
        std::uint32_t& given = names_[type].driver_from_scene[static_cast<std::uint32_t>(name)];
        if (given == 0) given = new_name(type);
    }
}

namespace {

// How many values of a hit's or a feedback's buffer there are: what comes after them is cut off, as GL does, and a
// scene cannot use any.
constexpr GLsizei kMostHitValues = 1 << 16;

constexpr bool is_query(std::string_view effect) { return effect == "elsewhere_query"; }

// Queries whose answers' lengths State does not know: they change nothing, and are not sent.
constexpr bool kIsQuery[] = {
#define GL_COMMAND(name, effect, ...) is_query(#effect),
#define SHAPE_COMMAND(name, effect, ...) false,
#define QUADRIC_COMMAND(name, effect, ...) false,
#define PRAGMA_COMMAND(name, effect, ...) false,
#include "command/commands.def"
#undef GL_COMMAND
#undef SHAPE_COMMAND
#undef QUADRIC_COMMAND
#undef PRAGMA_COMMAND
};

}  // namespace

// The driver writes into buffers of our own: they stay while it may.
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
    if (kIsQuery[static_cast<std::size_t>(command.id)]) return;
    if (command.id == CommandId::pragma_texture) return execute(texture_command(command));
    if (!may_see(command)) return;
    if (command.memory) memories_.insert(command.memory);
    switch (command.id) {
        case CommandId::glGenTextures:
        case CommandId::glGenBuffers: return generate(command);
        case CommandId::glSelectBuffer: return selection_buffer(static_cast<GLsizei>(command.number(0)));
        case CommandId::glFeedbackBuffer:
            return feedback_buffer(static_cast<GLsizei>(command.number(0)), command.enumerant(1));
        case CommandId::glRenderMode: selects_ = true; break;
        case CommandId::glNewList: lists_.insert(command.enumerant(0)); break;
        case CommandId::glGenLists: {
            // 5.4: the scene's own names make lists as well. What the driver finds is not used.
            const auto range = static_cast<GLsizei>(command.number(0));
            if (const GLuint found = glGenLists(range)) glDeleteLists(found, range);
            return;
        }
        default: break;
    }
    executor_.execute(translated(command));
}

// The command with the driver's names.
Command Driver::translated(const Command& command) {
    Command result = command;
    const std::vector<Parameter>& parameters = command.sig().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto type = named_objects(parameters[i]);
        if (!type || *type == ObjectType::kList) continue;
        const std::size_t first = command.first(i), end = first + command.count(i);
        for (std::size_t n = first; n < end; ++n) {
            const auto name = static_cast<std::uint32_t>(command.number(n));
            std::uint32_t driver_name = name_of(*type, name);
            // 3.8.12, 2.9: binding a name that was never generated makes an object.
            if (driver_name == 0 && name != 0 && parameters[i].extent == Extent::kValue) {
                driver_name = names_[*type].driver_from_scene[name] = new_name(*type);
            }
            result.arguments[n] = driver_name;
        }
    }
    return result;
}

namespace {

// Arrays that no pointer command of the table leads anywhere, and what a driver may take for glEnableClientState.
bool enables_unknown_array(const Command& c) {
    const Enum array = c.sig().parameters.empty() ? 0 : c.enumerant(0);
    if (c.id == CommandId::glEnableClientState) {
        return array == GL_INDEX_ARRAY || array == GL_SECONDARY_COLOR_ARRAY || array == GL_FOG_COORD_ARRAY;
    }
    return c.id == CommandId::glEnable && ((array >= GL_VERTEX_ARRAY && array <= GL_EDGE_FLAG_ARRAY) ||
                                           array == GL_SECONDARY_COLOR_ARRAY || array == GL_FOG_COORD_ARRAY);
}

}  // namespace

// Whether the driver finds what the command reads. State refuses commands of which it does not, so that no scene gets
// here with one.
bool Driver::may_see(const Command& c) {
    const auto error = draws_arrays(c.id) ? arrays_.check(c) : arrays_.apply(c);
    if ((error && error->is_undefined) || enables_unknown_array(c)) return false;
    if (c.id == CommandId::glPolygonStipple) {
        constexpr int kSide = 32;
        return !arrays_.pixel_unpack_buffer() && bitmap_bytes(kSide, kSide, unpacking()) <= c.array().size();
    }
    const std::vector<Parameter>& parameters = c.sig().parameters;
    const auto pointer = std::find_if(parameters.begin(), parameters.end(),
                                      [](const Parameter& p) { return p.extent == Extent::kPointer; });
    if (pointer == parameters.end() || pointer->name == "pointer" || pointer->name == "indices") return true;
    if (c.sig().name.starts_with("glBuffer")) return true;

    const double offset = c.number(c.first(static_cast<std::size_t>(pointer - parameters.begin())));
    double needed = 0;
    if (c.id == CommandId::glCallLists) {
        needed = c.number(0) * list_name_bytes(c.enumerant(1));
    } else if (c.id == CommandId::glBitmap) {
        if (arrays_.pixel_unpack_buffer()) return true;  // the driver knows its size itself
        needed = static_cast<double>(
            bitmap_bytes(static_cast<int>(c.number(0)), static_cast<int>(c.number(1)), unpacking()));
        if (!c.memory) return needed == 0 && offset == 0;
    } else if (const auto source = pixels_of(c)) {
        if (arrays_.pixel_unpack_buffer()) return true;
        const auto read = bytes_read_of(*source);
        if (!read) return !c.memory && offset == 0;
        needed = static_cast<double>(*read);
    } else {
        throw std::logic_error(fmt::format("no rule says how much {} reads", c.name()));
    }
    if (!c.memory) return offset == 0;
    return offset + needed <= static_cast<double>(c.memory->bytes.size());
}

}  // namespace twinlight::fixed
