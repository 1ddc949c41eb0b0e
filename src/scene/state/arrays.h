// VertexArrays: GL's client state (2.8, 2.9): array pointers, buffer objects and the stack of glPushClientAttrib. It
// reads the vertices for State, and checks for the fixed renderer that the driver reads no memory beyond an array's
// end.
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

// The limit on the size of all buffer objects together; more is GL_OUT_OF_MEMORY.
inline constexpr std::size_t kMaxBufferBytes = std::size_t{1} << 28;
// The limit on the vertices of one draw.
inline constexpr double kMaxDrawVertices = 1 << 22;

struct BufferObject {
    std::vector<std::byte> bytes;
    Enum usage = kGL_STATIC_DRAW;
    bool mapped = false;
};

// The pointer to an array and its layout (2.8; tables 6.6 to 6.9).
struct ArrayPointer {
    bool enabled = false;
    int size = 4;  // values per element
    Enum type = kGL_FLOAT;
    int stride = 0;
    std::uint32_t buffer = 0;                // the buffer object that was bound when the pointer was set; 0: none
    std::shared_ptr<const Memory> memory{};  // without a buffer: the client's memory; null for a null pointer
    double offset = 0;                       // in bytes, into the buffer or the memory
};

// The state that glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT) saves.
struct ClientArrays {
    ArrayPointer vertex, normal{.size = 3}, color, edge_flag{.size = 1, .type = kGL_UNSIGNED_BYTE};
    std::array<ArrayPointer, kMaxTextureUnits> tex_coord;
    // Whether the arrays that only the driver supports are enabled: color indexes, secondary colours, fog coordinates.
    std::array<bool, 3> driver_only{};
    std::size_t active_unit = 0;  // glClientActiveTexture
    std::uint32_t array_buffer = 0, element_buffer = 0;
};

// The vertices of a glDrawArrays, glDrawElements or glArrayElement, read from the enabled arrays. A missing attribute
// (its bool is false) gets the current value when the vertices are drawn.
struct ArrayVertices {
    Enum mode = kGL_POINTS;
    std::vector<Vertex> vertices{};
    std::vector<std::uint32_t> indices{};  // empty: 0, 1, 2, ...
    std::vector<VertexColumn> columns{};   // the texture coordinates of the units above 0 that have an array
    bool has_position = false, has_normal = false, has_color = false, has_tex_coord = false, has_edge_flag = false;
};

class VertexArrays {
  public:
    // Executes a command on arrays or buffers, but not one that draws. Returns its error, if any.
    std::optional<GlError> apply(const Command& command);

    // The error of a command that draws from arrays: it is illegal, or reads beyond the end of memory or a buffer.
    std::optional<GlError> check(const Command& draw) const;
    // The vertices that the command reads; check() must have succeeded. Equal indices share one vertex.
    ArrayVertices read(const Command& draw, SignedRule rule) const;

    // The smallest and the largest index of glDrawElements or glDrawRangeElements; check() must have succeeded.
    std::pair<double, double> index_range(const Command& draw) const;

    const ClientArrays& client() const { return client_; }
    // The buffer objects of the enabled arrays, and that of indices.
    std::vector<std::uint32_t> buffers_read() const;
    const BufferObject* buffer(std::uint32_t name) const;  // null if there is no such object
    // The buffer object that texture images are read from (3.6.1); null: they are read from client memory.
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
    BufferObject* bound(const Command& c,
                        Result& error);  // for the target; sets `error` and returns null if none is bound
    bool* enabled(Enum array);           // null if `array` is not an array
    void point(ArrayPointer& array, int size, Enum type, int stride, const Command& c, double offset) const;

    // The bytes of an array's buffer or memory; nullopt if it has none.
    std::optional<std::span<const std::byte>> bytes(const ArrayPointer& array) const;
    std::optional<std::span<const std::byte>> index_bytes(const Command& draw) const;
    std::vector<std::uint32_t> elements(const Command& draw) const;
    Result check_elements(const Command& draw) const;
    // The error if an enabled array does not contain all elements from `smallest` to `largest`.
    Result check_memory(const Command& draw, std::uint64_t smallest, std::uint64_t largest) const;
    void read_element(std::uint64_t index, SignedRule rule, ArrayVertices& read) const;  // appends it

    struct Saved {
        ClientArrays client;
        Enum mask = 0;
    };

    ClientArrays client_;
    std::vector<Saved> stack_;
    std::uint32_t pixel_pack_ = 0, pixel_unpack_ = 0;
    std::map<std::uint32_t, std::shared_ptr<BufferObject>> buffers_;  // null: generated but not yet bound
    std::size_t buffer_bytes_ = 0;
};

// The error of a command whose first argument is not a valid texture unit (3.8.16).
std::optional<GlError> wrong_texture_unit(const Command& command);

// Whether a command draws from arrays: glDrawArrays, glDrawElements, glDrawRangeElements, glArrayElement.
bool draws_arrays(CommandId id);

}  // namespace twinlight
