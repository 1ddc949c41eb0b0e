// Rewrites a scene with other commands that must draw the same picture.
#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <span>

#include "judge/fuzz/random_states.h"
#include "scene/state/state.h"

namespace twinlight::fuzz {

namespace {

using Id = CommandId;

class Output {
  public:
    void add(Id id, std::vector<double> arguments = {}, std::shared_ptr<const Memory> memory = nullptr) {
        commands.push_back({id, std::move(arguments), {}, std::move(memory)});
    }
    std::vector<Command> commands;
};

// ---- Vertex arrays (2.8, 2.9) ----

template <class Value>
void append(Memory& memory, double value) {
    const auto converted = static_cast<Value>(value);
    const std::size_t at = memory.bytes.size();
    memory.bytes.resize(at + sizeof converted);
    std::memcpy(memory.bytes.data() + at, &converted, sizeof converted);
}

struct Attribute {
    std::string_view prefix;  // of the commands that set it
    Enum array;
    int size;
};
constexpr std::array<Attribute, 4> kAttributes = {{{"glVertex", kGL_VERTEX_ARRAY, 4},
                                                   {"glNormal", kGL_NORMAL_ARRAY, 3},
                                                   {"glColor", kGL_COLOR_ARRAY, 4},
                                                   {"glTexCoord", kGL_TEXTURE_COORD_ARRAY, 4}}};

double value_of(const Vertex& vertex, std::size_t attribute, int component) {
    switch (attribute) {
        case 0: return vertex.position_object[component];
        case 1: return vertex.normal_object[component];
        case 2: return vertex.color[component];
        default: return vertex.tex_coord[component];
    }
}

// The attributes that the commands between glBegin and glEnd set. None where there are other commands, or where a later
// vertex sets an attribute that the first vertex does not.
std::optional<std::array<bool, 4>> attributes_of(std::span<const Command> commands) {
    std::array<bool, 4> has{};
    bool has_vertex = false;
    for (const Command& command : commands) {
        const auto attribute = std::ranges::find_if(
            kAttributes, [&](const Attribute& row) { return command.name().starts_with(row.prefix); });
        if (attribute == kAttributes.end()) return std::nullopt;
        bool& here = has.at(static_cast<std::size_t>(attribute - kAttributes.begin()));
        if (has_vertex && !here) return std::nullopt;
        here = true;
        has_vertex = has[0];
    }
    return has_vertex ? std::optional(has) : std::nullopt;
}

class Arrays {
  public:
    Arrays(Output& output, Random& random, const Draw& draw, const std::array<bool, 4>& has)
        : output_(output), random_(random), draw_(draw), has_(has) {}

    void write() {
        interleaved_ = random_.chance(0.5);
        in_buffer_ = random_.chance(0.3);
        if (interleaved_) {
            auto memory = std::make_shared<Memory>(Memory{Kind::kFloat, {}});
            for (const Vertex& vertex : draw_.vertices) append_vertex(*memory, vertex);
            shared_ = std::move(memory);
            if (in_buffer_) buffer(kGL_ARRAY_BUFFER, 1, shared_);
        }
        for (std::size_t a = 0; a < has_.size(); ++a) {
            if (has_[a]) pointer(a);
        }
        draw();
        for (std::size_t a = 0; a < has_.size(); ++a) {
            if (has_[a]) output_.add(Id::glDisableClientState, {static_cast<double>(kAttributes.at(a).array)});
        }
        if (in_buffer_) output_.add(Id::glBindBuffer, {kGL_ARRAY_BUFFER, 0});
        set_current();
    }

  private:
    void append_vertex(Memory& memory, const Vertex& vertex) {
        for (std::size_t a = 0; a < has_.size(); ++a) {
            for (int i = 0; has_[a] && i < kAttributes.at(a).size; ++i) append<float>(memory, value_of(vertex, a, i));
        }
    }

    void buffer(double target, double name, const std::shared_ptr<const Memory>& memory) {
        output_.add(Id::glBindBuffer, {target, name});
        output_.add(Id::glBufferData, {target, static_cast<double>(memory->bytes.size()), 0, kGL_STATIC_DRAW}, memory);
    }

    void pointer(std::size_t a) {
        const Attribute& row = kAttributes.at(a);
        std::shared_ptr<const Memory> memory = shared_;
        double offset = 0, stride = 0, type = kGL_FLOAT;
        if (interleaved_) {
            for (std::size_t before = 0; before < has_.size(); ++before) {
                const double bytes = has_[before] ? 4.0 * kAttributes.at(before).size : 0;
                if (before < a) offset += bytes;
                stride += bytes;
            }
        } else {
            const bool is_double = random_.chance(0.3);
            if (is_double) type = kGL_DOUBLE;
            auto own = std::make_shared<Memory>(Memory{is_double ? Kind::kDouble : Kind::kFloat, {}});
            for (const Vertex& vertex : draw_.vertices) {
                for (int i = 0; i < row.size; ++i) {
                    const double value = value_of(vertex, a, i);
                    is_double ? append<double>(*own, value) : append<float>(*own, value);
                }
            }
            memory = std::move(own);
            if (in_buffer_) buffer(kGL_ARRAY_BUFFER, 2 + static_cast<double>(a), memory);
        }
        const std::shared_ptr<const Memory> given = in_buffer_ ? nullptr : memory;
        const double size = row.size;
        switch (a) {
            case 0: output_.add(Id::glVertexPointer, {size, type, stride, offset}, given); break;
            case 1: output_.add(Id::glNormalPointer, {type, stride, offset}, given); break;
            case 2: output_.add(Id::glColorPointer, {size, type, stride, offset}, given); break;
            default: output_.add(Id::glTexCoordPointer, {size, type, stride, offset}, given);
        }
        output_.add(Id::glEnableClientState, {static_cast<double>(row.array)});
    }

    void draw() {
        const double mode = draw_.mode, count = static_cast<double>(draw_.vertices.size());
        auto indices = std::make_shared<Memory>();
        for (double i = 0; i < count; ++i) append<std::uint16_t>(*indices, i);
        indices->kind = Kind::kUshort;
        switch (random_.below(4)) {
            case 0: return output_.add(Id::glDrawArrays, {mode, 0, count});
            case 1: return output_.add(Id::glDrawElements, {mode, count, kGL_UNSIGNED_SHORT, 0}, indices);
            case 2:
                return output_.add(Id::glDrawRangeElements, {mode, 0, count - 1, count, kGL_UNSIGNED_SHORT, 0},
                                   indices);
            default:
                output_.add(Id::glBegin, {mode});
                for (double i = 0; i < count; ++i) output_.add(Id::glArrayElement, {i});
                output_.add(Id::glEnd);
        }
    }

    // 2.8: after drawing from an array, the current value of its attribute is undefined.
    void set_current() {
        const Vertex& last = draw_.vertices.back();
        if (has_[1]) output_.add(Id::glNormal3d, {last.normal_object.x, last.normal_object.y, last.normal_object.z});
        if (has_[2]) output_.add(Id::glColor4d, {last.color.r, last.color.g, last.color.b, last.color.a});
        if (has_[3]) {
            output_.add(Id::glTexCoord4d, {last.tex_coord.x, last.tex_coord.y, last.tex_coord.z, last.tex_coord.w});
        }
    }

    Output& output_;
    Random& random_;
    const Draw& draw_;
    std::array<bool, 4> has_;
    bool interleaved_ = false, in_buffer_ = false;
    std::shared_ptr<const Memory> shared_;
};

std::vector<Command> with_arrays(const std::vector<Command>& commands, Random& random) {
    Output output;
    State state;
    std::size_t begin = 0;  // in the output
    for (const Command& command : commands) {
        state.apply(command);
        output.commands.push_back(command);
        if (command.id == Id::glBegin) begin = output.commands.size();
        if (command.id != Id::glEnd || !random.chance(0.7) || state.items().empty()) continue;
        const Draw* draw = std::get_if<Draw>(&state.items().back());
        const std::span<const Command> inside(output.commands.begin() + static_cast<std::ptrdiff_t>(begin),
                                              output.commands.end() - 1);
        const auto has = attributes_of(inside);
        if (!draw || !has || !draw->materials.empty() || !draw->indices.empty()) continue;
        output.commands.resize(begin - 1);
        Arrays(output, random, *draw, *has).write();
    }
    return output.commands;
}

// ---- Attribute stacks (6.1.14) and matrix stacks (2.11.2) ----

struct Saved {
    Enum mask;
    std::vector<Command> commands;  // change only state that the mask saves
};

const std::vector<Saved>& saved() {
    const auto command = [](Id id, std::vector<double> arguments) { return Command{id, std::move(arguments), {}}; };
    static const std::vector<Saved> list = {
        {kGL_LIGHTING_BIT,
         {command(Id::glLightfv, {kGL_LIGHT0, kGL_DIFFUSE, 1, 0, 0, 1}), command(Id::glDisable, {kGL_LIGHTING}),
          command(Id::glLightfv, {kGL_LIGHT1, kGL_POSITION, 1, 2, 3, 1}), command(Id::glShadeModel, {kGL_FLAT}),
          command(Id::glLightModeli, {kGL_LIGHT_MODEL_LOCAL_VIEWER, 1}), command(Id::glEnable, {kGL_LIGHT3})}},
        {kGL_ENABLE_BIT,
         {command(Id::glEnable, {kGL_FOG}), command(Id::glDisable, {kGL_LIGHTING}),
          command(Id::glEnable, {kGL_CULL_FACE}), command(Id::glEnable, {kGL_ALPHA_TEST}),
          command(Id::glEnable, {kGL_CLIP_PLANE0 + 3.0})}},
        {kGL_TRANSFORM_BIT, {command(Id::glMatrixMode, {kGL_TEXTURE}), command(Id::glEnable, {kGL_NORMALIZE})}},
        {kGL_VIEWPORT_BIT, {command(Id::glViewport, {3, 4, 20, 10}), command(Id::glDepthRange, {1, 0})}},
        {kGL_POLYGON_BIT,
         {command(Id::glFrontFace, {kGL_CW}), command(Id::glPolygonMode, {kGL_FRONT_AND_BACK, kGL_LINE}),
          command(Id::glCullFace, {kGL_FRONT}), command(Id::glPolygonOffset, {2, 3})}},
        {kGL_LINE_BIT | kGL_POINT_BIT,
         {command(Id::glLineWidth, {5}), command(Id::glPointSize, {7}),
          command(Id::glPointParameterf, {kGL_POINT_SIZE_MIN, 9})}},
        {kGL_FOG_BIT, {command(Id::glFogf, {kGL_FOG_DENSITY, 3}), command(Id::glFogfv, {kGL_FOG_COLOR, 1, 0, 0, 1})}},
        {kGL_STENCIL_BUFFER_BIT | kGL_ACCUM_BUFFER_BIT,
         {command(Id::glStencilFunc, {kGL_NEVER, 3, 7}), command(Id::glStencilOp, {kGL_INVERT, kGL_ZERO, kGL_INCR}),
          command(Id::glStencilMask, {9}), command(Id::glClearStencil, {5}),
          command(Id::glClearAccum, {1, -1, 0.5, 0})}},
        {kGL_DEPTH_BUFFER_BIT, {command(Id::glDepthFunc, {kGL_NEVER}), command(Id::glDepthMask, {0})}},
        {kGL_COLOR_BUFFER_BIT,
         {command(Id::glBlendFunc, {kGL_ZERO, kGL_ONE}), command(Id::glColorMask, {0, 1, 0, 1}),
          command(Id::glAlphaFunc, {kGL_NEVER, 0}), command(Id::glClearColor, {1, 1, 0, 1})}},
        {kGL_SCISSOR_BIT, {command(Id::glEnable, {kGL_SCISSOR_TEST}), command(Id::glScissor, {5, 5, 9, 9})}},
        {kGL_TEXTURE_BIT,
         {command(Id::glTexEnvi, {kGL_TEXTURE_ENV, kGL_TEXTURE_ENV_MODE, kGL_ADD}),
          command(Id::glTexParameteri, {kGL_TEXTURE_2D, kGL_TEXTURE_WRAP_S, kGL_CLAMP_TO_BORDER}),
          command(Id::glBindTexture, {kGL_TEXTURE_2D, 77})}},
    };
    return list;
}

void insert_stack(std::vector<Command>& commands, std::size_t place, Random& random) {
    std::vector<Command> inserted;
    if (random.chance(0.3)) {
        inserted = {{Id::glPushMatrix, {}, {}},
                    {Id::glTranslated, {random.uniform(-3, 3), 1, -2}, {}},
                    {Id::glScaled, {2, 3, random.uniform(0.5, 4)}, {}},
                    {Id::glPopMatrix, {}, {}}};
    } else {
        const Saved& row = saved()[static_cast<std::size_t>(random.below(static_cast<int>(saved().size())))];
        const Enum mask = random.chance(0.2) ? kGL_ALL_ATTRIB_BITS : row.mask;
        inserted.push_back({Id::glPushAttrib, {static_cast<double>(mask)}, {}});
        for (const Command& command : row.commands) {
            if (random.chance(0.7)) inserted.push_back(command);
        }
        inserted.push_back({Id::glPopAttrib, {}, {}});
    }
    commands.insert(commands.begin() + static_cast<std::ptrdiff_t>(place), inserted.begin(), inserted.end());
}

// ---- Display lists (5.4) ----

// Not commands that are executed immediately (5.4), nor those that return new names.
bool may_be_compiled(const Command& command) {
    if (command.sig().family != Family::kGl) return false;
    static constexpr std::string_view kNot[] = {"glGen",          "glDelete",        "glNewList",    "glEndList",
                                                "glEnableClient", "glDisableClient", "glPushClient", "glPopClient",
                                                "glPixelStore",   "glBindBuffer",    "glBufferData", "glFramebuffer",
                                                "glBindFrame",    "glRenderbuffer",  "glBindRender"};
    return std::ranges::none_of(kNot, [&](std::string_view name) { return command.name().starts_with(name); }) &&
           command.name().find("Pointer") == std::string_view::npos;
}

void wrap_in_list(std::vector<Command>& commands, std::size_t first, std::size_t end, double name, Random& random) {
    const bool at_once = random.chance(0.3);
    Output after;
    after.add(Id::glEndList);
    if (!at_once) after.add(Id::glCallList, {name});
    const auto place = [&](std::size_t i) { return commands.begin() + static_cast<std::ptrdiff_t>(i); };
    commands.insert(place(end), after.commands.begin(), after.commands.end());
    const double mode = at_once ? kGL_COMPILE_AND_EXECUTE : kGL_COMPILE;
    commands.insert(place(first), Command{Id::glNewList, {name, mode}, {}});
}

// The places between commands that are outside glBegin and glEnd and outside display lists.
std::vector<std::size_t> open_places(const std::vector<Command>& commands) {
    std::vector<std::size_t> places;
    int depth = 0;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (depth == 0) places.push_back(i);
        if (commands[i].id == Id::glBegin || commands[i].id == Id::glNewList) ++depth;
        if (commands[i].id == Id::glEnd || commands[i].id == Id::glEndList) --depth;
    }
    places.push_back(commands.size());
    return places;
}

void insert_list(std::vector<Command>& commands, double name, Random& random) {
    const std::vector<std::size_t> places = open_places(commands);
    const auto any_place = [&] {
        return places[static_cast<std::size_t>(random.below(static_cast<int>(places.size())))];
    };
    std::size_t first = any_place(), end = any_place();
    if (first > end) std::swap(first, end);
    const std::span<const Command> inside(commands.begin() + static_cast<std::ptrdiff_t>(first),
                                          commands.begin() + static_cast<std::ptrdiff_t>(end));
    if (first < end && std::ranges::all_of(inside, may_be_compiled)) wrap_in_list(commands, first, end, name, random);
}

}  // namespace

CommandList disguised(const CommandList& scene, Random& random) {
    CommandList result(scene.name, scene.commands);
    if (random.chance(0.4)) result.commands = with_arrays(result.commands, random);
    for (int i = random.chance(0.4) ? 1 + random.below(3) : 0; i > 0; --i) {
        const std::vector<std::size_t> places = open_places(result.commands);
        insert_stack(result.commands, places[static_cast<std::size_t>(random.below(static_cast<int>(places.size())))],
                     random);
    }
    // Several attempts, because some commands cannot be compiled.
    for (int i = random.chance(0.4) ? 4 : 0; i > 0; --i) insert_list(result.commands, i, random);
    return result;
}

}  // namespace twinlight::fuzz
