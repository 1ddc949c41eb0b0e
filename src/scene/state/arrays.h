// VertexArrays: the client's side of GL (2.8, 2.9): array pointers, buffer objects, glPushClientAttrib's stack; and the
// vertices that they come to. State draws with it; the fixed renderer asks it whether a driver may read what it is told to.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scene/state/attributes.h"
#include "scene/state/gl_error.h"

namespace twinlight {

// What all buffer objects may hold together; more is GL_OUT_OF_MEMORY.
inline constexpr std::size_t kMaxBufferBytes = std::size_t{1} << 28;
// The vertices of one draw.
inline constexpr double kMaxDrawVertices = 1 << 22;

struct BufferObject {
    std::vector<std::byte> bytes;
    Enum usage = kGL_STATIC_DRAW;
    bool mapped = false;
};

// One array: where its elements are (2.8; tables 6.6 to 6.9).
struct ArrayPointer {
    bool enabled = false;
    int size = 4;  // values an element
    Enum type = kGL_FLOAT;
    int stride = 0;
    std::uint32_t buffer = 0;                // the buffer object that was bound at glXxxPointer
    std::shared_ptr<const Memory> memory{};  // else the client's memory; null for a null pointer
    double offset = 0;                       // in bytes, into the one or the other
};

// What glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT) saves.
struct ClientArrays {
    ArrayPointer vertex, normal{.size = 3}, color, edge_flag{.size = 1, .type = kGL_UNSIGNED_BYTE};
    std::array<ArrayPointer, kMaxTextureUnits> tex_coord;
    // Arrays of what Twinlight does not follow (color indexes, secondary colours, fog coordinates): whether they are on.
    std::array<bool, 3> driver_only{};
    std::size_t active_unit = 0;  // glClientActiveTexture's
    std::uint32_t array_buffer = 0, element_buffer = 0;
};

// The vertices of a glDrawArrays, glDrawElements or glArrayElement, read from the arrays that were enabled. What the
// others have (a bool below is false) comes from the current values when they are drawn.
struct ArrayVertices {
    Enum mode = kGL_POINTS;
    std::vector<Vertex> vertices{};
    std::vector<std::uint32_t> indices{};  // empty: 0, 1, 2, ...
    bool has_position = false, has_normal = false, has_color = false, has_tex_coord = false, has_edge_flag = false;
};

class VertexArrays {
  public:
    // The commands on arrays and buffers, but for those that draw; what is raised, if they are refused.
    std::optional<GlError> apply(const Command& command);

    // Whether a command that draws from arrays is legal, and reads nothing but what the memory and the buffers hold.
    std::optional<GlError> check(const Command& draw) const;
    // What it reads; check() was passed. Elements of the same index are one vertex.
    ArrayVertices read(const Command& draw, SignedRule rule) const;

    // The smallest and the largest index of glDrawElements or glDrawRangeElements; check() was passed.
    std::pair<double, double> index_range(const Command& draw) const;

    const ClientArrays& client() const { return client_; }
    const BufferObject* buffer(std::uint32_t name) const;  // null for a name without an object
    // The buffer that texture images are read from, where one is bound (3.6.1); null: the client's memory.
    const BufferObject* pixel_unpack_buffer() const { return pixel_unpack_ == 0 ? nullptr : buffer(pixel_unpack_); }
    std::uint32_t pixel_unpack_name() const { return pixel_unpack_; }
    std::uint32_t pixel_pack_name() const { return pixel_pack_; }
    std::size_t stack_depth() const { return stack_.size(); }

  private:
    using Result = std::optional<GlError>;

    using Change = Result(const Command&);
    Change enable, set_pointer, interleaved, active_texture, push, pop;
    Change generate, remove, bind, data, sub_data, map, unmap;

    std::uint32_t* binding(Enum target);
    BufferObject* bound(const Command& c, Result& error);  // of the target; null, and the error, where none is bound
    bool* enabled(Enum array);                             // null for what is no array
    void point(ArrayPointer& array, int size, Enum type, int stride, const Command& c, double offset) const;

    // The bytes that an array lies in; nothing where it leads nowhere.
    std::optional<std::span<const std::byte>> bytes(const ArrayPointer& array) const;
    std::optional<std::span<const std::byte>> index_bytes(const Command& draw) const;
    std::vector<std::uint32_t> elements(const Command& draw) const;
    Result check_elements(const Command& draw) const;
    // Whether the enabled arrays hold the elements from `smallest` to `largest`.
    Result check_memory(const Command& draw, std::uint64_t smallest, std::uint64_t largest) const;
    void read_element(std::uint64_t index, SignedRule rule, Vertex& vertex) const;

    struct Saved {
        ClientArrays client;
        Enum mask = 0;
    };

    ClientArrays client_;
    std::vector<Saved> stack_;
    std::uint32_t pixel_pack_ = 0, pixel_unpack_ = 0;
    std::map<std::uint32_t, std::shared_ptr<BufferObject>> buffers_;  // null: generated, not bound yet
    std::size_t buffer_bytes_ = 0;
};

// The error of a command whose first argument should be a texture unit (3.8.16), and is none.
std::optional<GlError> wrong_texture_unit(const Command& command);

// Whether a command draws from arrays: glDrawArrays, glDrawElements, glDrawRangeElements, glArrayElement.
bool draws_arrays(CommandId id);

}  // namespace twinlight
