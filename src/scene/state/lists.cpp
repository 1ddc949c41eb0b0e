// Display lists: glNewList, glCallList and related commands (5.4).
#include "scene/state/lists.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/command/command_set.h"
#include "scene/command/memory.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// 5.4: commands that are executed immediately, even while a list is compiled: those on lists, client state and objects'
// names, and queries. GLU's functions for quadrics are not GL commands.
constexpr CommandSet kNeverCompiled = CommandSet::of({"new_list",
                                                      "end_list",
                                                      "gen_lists",
                                                      "delete_lists",
                                                      "pixel_store",
                                                      "flush",
                                                      "gen_textures",
                                                      "delete_textures",
                                                      "client_arrays",
                                                      "get_light",
                                                      "get_material",
                                                      "render_mode",
                                                      "hit_buffer",
                                                      "is_enabled",
                                                      "query_clip_plane",
                                                      "query_tex_env",
                                                      "query_tex_gen",
                                                      "query_tex_parameter",
                                                      "driver_only_query",
                                                      "new_quadric",
                                                      "delete_quadric",
                                                      "set_quadric",
                                                      "gen_framebuffers",
                                                      "delete_framebuffers",
                                                      "bind_framebuffer",
                                                      "gen_renderbuffers",
                                                      "delete_renderbuffers",
                                                      "bind_renderbuffer",
                                                      "renderbuffer_storage",
                                                      "framebuffer_texture",
                                                      "framebuffer_renderbuffer",
                                                      "generate_mipmap"});

// Commands that send vertices or their attributes.
constexpr CommandSet kSendsVertices = CommandSet::of(
    {"begin", "end", "vertex", "normal", "color", "tex_coord", "edge_flag", "material", "array_element", "draw_arrays",
     "rect", "shape", "mesh_file", "quadric_shape", "eval_coord", "eval_point", "eval_mesh"});

bool reads_pixels(const Command& c) {
    const auto names_pixels = [](const Parameter& parameter) {
        return parameter.name == "pixels" || parameter.name == "bitmap";
    };
    return std::ranges::any_of(c.sig().parameters, names_pixels);
}

}  // namespace

std::uint32_t list_name(std::span<const std::byte> bytes, Enum type) {
    if (const std::optional<Kind> kind = kind_of_type(type)) {
        const double value = load(bytes, *kind);
        if (std::isnan(value)) return 0;
        constexpr double kLargestFloat = 4294967040;  // below 2^32
        return static_cast<std::uint32_t>(
            static_cast<std::int64_t>(is_real(*kind) ? std::clamp(value, -2147483648.0, kLargestFloat) : value));
    }
    std::uint32_t name = 0;  // GL_2_BYTES, ...: the highest byte comes first
    for (const std::byte byte : bytes.first(static_cast<std::size_t>(list_name_bytes(type))))
        name = name << 8 | std::to_integer<std::uint32_t>(byte);
    return name;
}

int list_name_bytes(Enum type) {
    if (type >= kGL_2_BYTES && type <= kGL_4_BYTES) return 2 + static_cast<int>(type - kGL_2_BYTES);
    const std::optional<Kind> kind = type == kGL_DOUBLE ? std::nullopt : kind_of_type(type);
    return kind ? static_cast<int>(size_of(*kind)) : 0;
}

std::size_t ListedCommand::bytes() const {
    std::size_t bytes = sizeof *this + command.arguments.size() * sizeof(double);
    if (arrays) {
        bytes +=
            sizeof *arrays + arrays->vertices.size() * sizeof(Vertex) + arrays->indices.size() * sizeof(std::uint32_t);
    }
    if (pixel_store) bytes += sizeof *pixel_store;
    if (quadric) bytes += sizeof *quadric;
    return bytes + (error ? sizeof *error + error->message.size() : 0);
}

// Adds a command to the open list. Returns true if it must not be executed now; GL_COMPILE_AND_EXECUTE also executes
// it.
bool State::compile(const Command& c) {
    if (lists_.open_name == 0 || lists_.nesting > 0 || kNeverCompiled.contains(c.id)) return false;
    if (draws_quadric(c) && !can_send(c)) return true;  // GLU refuses it and calls no GL command
    ListedCommand listed{.command = c};
    std::size_t bytes = 0;  // in addition to those of the listed command
    if (draws_arrays(c.id)) {
        // The arrays are read now (5.4). Errors of the arguments are raised when the list is executed.
        auto error = arrays_.check(c);
        if (error && error->is_undefined) {
            raise(*error);
            return true;
        }
        if (error) {
            listed.error = std::make_shared<const GlError>(std::move(*error));
        } else {
            show_shared_buffers();
            ArrayVertices read = arrays_.read(c, options_.signed_rule);
            for (Vertex& v : read.vertices) sanitize(v);
            listed.arrays = std::make_shared<const ArrayVertices>(std::move(read));
        }
    } else if (c.memory || c.id == CommandId::glPolygonStipple) {
        listed.pixel_store = std::make_shared<const PixelStore>(pixel_store_);
    } else if (const BufferObject* buffer = arrays_.pixel_unpack_buffer(); buffer && reads_pixels(c)) {
        listed.pixel_store = std::make_shared<const PixelStore>(pixel_store_);
        listed.command.memory = std::make_shared<const Memory>(Memory{.bytes = buffer->bytes});
        bytes += buffer->bytes.size();
    }
    if (draws_quadric(c)) listed.quadric = std::make_shared<const Quadric>(*quadric(c));
    if (c.id == CommandId::glCallList || c.id == CommandId::glCallLists) bytes += compile_calls(c);
    lists_.open->sends_vertices |= kSendsVertices.contains(c.id);
    bytes += listed.bytes();
    if (bytes > kMaxListedBytes - lists_.bytes - lists_.open->bytes) {
        raise(kGL_OUT_OF_MEMORY, c, "all display lists together can have at most {} MiB", kMaxListedBytes >> 20);
        return true;
    }
    lists_.open->bytes += bytes;
    lists_.open->commands.push_back(std::move(listed));
    return lists_.open_mode == kGL_COMPILE;
}

// Notes which lists the open list calls. Returns the number of bytes that this takes.
std::size_t State::compile_calls(const Command& c) {
    std::vector<std::uint32_t> names;
    if (c.id == CommandId::glCallList) {
        names.push_back(c.enumerant(0));
    } else if (const int size = list_name_bytes(c.enumerant(1)); size > 0 && c.memory && has_time(c, c.number(0))) {
        const double offset = c.number(2), count = c.number(0);
        if (offset < 0 || offset + count * size > static_cast<double>(c.memory->bytes.size())) return 0;
        const std::byte* at = c.memory->bytes.data() + static_cast<std::size_t>(offset);
        for (double i = 0; i < count; ++i, at += size)
            names.push_back(list_name({at, static_cast<std::size_t>(size)}, c.enumerant(1)));
        if (std::ranges::find(names, 0U) != names.end())
            note_unsupported("glCallLists with the name 0 in a display list", c.place, MissingFrom::kFixedFunction);
    }
    std::vector<std::uint32_t>& calls = lists_.open->calls;
    for (std::uint32_t name : names) {
        if (name != 0 && !lists_.named.contains(name)) lists_.called_before_made.insert(name);
        if (name != 0) calls.push_back(name);
    }
    constexpr std::size_t kBytesOfName = 64;  // in a set
    return names.size() * kBytesOfName;
}

// At the glEndList of a list that sends vertices, Mesa 22.3 walks through all lists that it calls, directly or
// indirectly, without a limit. This takes the same walk first and raises GL_OUT_OF_MEMORY if Mesa's would not end in
// time.
bool State::walk_calls(const Command& c, const DisplayList& list) {
    struct Level {
        std::shared_ptr<const DisplayList> held;
        const DisplayList* list = nullptr;
        std::size_t next = 0;
    };
    if (list.calls.empty() || !list.sends_vertices) return true;
    std::vector<Level> levels{{nullptr, &list}};
    while (!levels.empty()) {
        Level& level = levels.back();
        if (level.next == level.list->calls.size()) {
            levels.pop_back();
            continue;
        }
        const auto found = lists_.named.find(level.list->calls[level.next++]);
        if (found == lists_.named.end()) continue;
        if (!has_time(c, 1 + static_cast<double>(found->second->commands.size()))) return false;
        if (levels.size() >= kMaxListDepth) {
            raise(kGL_OUT_OF_MEMORY, c,
                  "this list sends vertices and calls lists that are nested more than {} deep, or in a circle",
                  kMaxListDepth);
            return false;
        }
        levels.push_back({found->second, found->second.get()});
    }
    return true;
}

void State::gen_lists(const Command& c) {
    // The new lists are empty. No command can distinguish an empty list from a missing one, so nothing is stored.
    if (c.number(0) < 0)
        raise(kGL_INVALID_VALUE, c, "glGenLists is given the count {}; it must be 0 or more", c.number(0));
}

void State::new_list(const Command& c) {
    const std::uint32_t name = c.enumerant(0);
    if (name == 0) return raise(kGL_INVALID_VALUE, c, "glNewList is given the name 0; names start at 1");
    if (!known(c, c.enumerant(1), {kGL_COMPILE, kGL_COMPILE_AND_EXECUTE})) return;
    if (lists_.named.size() >= kMaxLists && !lists_.named.contains(name))
        return raise(kGL_OUT_OF_MEMORY, c, "a scene can have at most {} display lists", kMaxLists);
    if (lists_.open_name != 0) {
        return raise(kGL_INVALID_OPERATION, c, "glNewList inside another glNewList; the one at {} has no glEndList yet",
                     lists_.opened.str());
    }
    elsewhere_.erase({SharedObject::Kind::kList, name});
    lists_.open_name = name;
    lists_.open_mode = c.enumerant(1);
    lists_.opened = c.place;
    lists_.open = std::make_shared<DisplayList>();
}

void State::end_list(const Command& c) {
    if (lists_.open_name == 0) return raise(kGL_INVALID_OPERATION, c, "glEndList without a glNewList");
    if (!walk_calls(c, *lists_.open)) return;
    std::shared_ptr<const DisplayList>& list = lists_.named[lists_.open_name];
    lists_.bytes += lists_.open->bytes - (list ? list->bytes : 0);
    list = std::move(lists_.open);
    lists_.open_name = 0;
}

void State::delete_lists(const Command& c) {
    if (c.number(1) < 0)
        return raise(kGL_INVALID_VALUE, c, "glDeleteLists is given the range {}; it must be 0 or more", c.number(1));
    const double first = c.number(0), end = first + c.number(1);
    auto it = lists_.named.lower_bound(c.enumerant(0));
    while (it != lists_.named.end() && it->first < end) {
        lists_.bytes -= it->second->bytes;
        it = lists_.named.erase(it);
    }
}

void State::list_base(const Command& c) { a_.list_base = c.enumerant(0); }

void State::call_list(const Command& c) { execute_list(c, c.enumerant(0)); }

void State::call_lists(const Command& c) {
    const double count = c.number(0);
    const Enum type = c.enumerant(1);
    const int size = list_name_bytes(type);
    if (size == 0) {
        return raise(kGL_INVALID_ENUM, c, "glCallLists is given the type {}; expected GL_UNSIGNED_BYTE, GL_INT, ...",
                     enum_name(type));
    }
    if (count < 0) return raise(kGL_INVALID_VALUE, c, "glCallLists is given the count {}; it must be 0 or more", count);
    if (count == 0 || !c.memory) return;
    const double offset = c.number(2), bytes = static_cast<double>(c.memory->bytes.size());
    if (offset < 0 || offset + count * size > bytes) {
        return raise(kGL_INVALID_OPERATION, c, "glCallLists reads {} names of {} bytes, but its array has {} bytes",
                     count, size, std::max(0.0, bytes - offset));
    }
    const std::byte* names = c.memory->bytes.data() + static_cast<std::size_t>(offset);
    const std::uint32_t base = a_.list_base;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count) && !exhausted_; ++i) {
        execute_list(
            c, base + list_name({names + i * static_cast<std::size_t>(size), static_cast<std::size_t>(size)}, type));
    }
}

// A name without a list does nothing (5.4), and neither does a list that is nested too deep, such as one that calls
// itself.
void State::execute_list(const Command& c, std::uint32_t name) {
    show_shared(SharedObject::Kind::kList, name);
    const auto found = lists_.named.find(name);
    if (!has_time(c, 1) || found == lists_.named.end() || lists_.nesting >= kMaxListNesting) return;
    const std::shared_ptr<const DisplayList> list = found->second;  // held: it may be replaced while it runs
    const auto outer =
        std::exchange(lists_.call, std::make_shared<const ListCall>(ListCall{name, c.place, modelview(), lists_.call}));
    ++lists_.nesting;
    for (const ListedCommand& listed : list->commands) {
        if (exhausted_ || !has_time(c, 1 + static_cast<double>(listed.elements()))) break;
        lists_.quadric = listed.quadric.get();
        if (watch_list_) watch_list_(listed.command, false);
        execute_listed(listed);
        if (watch_list_) watch_list_(listed.command, true);
    }
    lists_.quadric = nullptr;
    --lists_.nesting;
    lists_.call = outer;
}

void State::execute_listed(const ListedCommand& listed) {
    if (listed.error) {
        raise(*listed.error);
    } else if (listed.arrays && listed.command.id == CommandId::glArrayElement) {
        send_element(listed.command, *listed.arrays);
    } else if (listed.arrays && open_) {
        raise_inside(listed.command);
    } else if (listed.arrays) {
        if (use_framebuffers(listed.command)) draw(listed.command, *listed.arrays);
    } else if (listed.pixel_store) {
        const PixelStore now = std::exchange(pixel_store_, *listed.pixel_store);
        carry_out(listed.command);
        pixel_store_ = now;
    } else {
        carry_out(listed.command);
    }
}

}  // namespace twinlight
