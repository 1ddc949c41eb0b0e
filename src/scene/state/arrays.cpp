// The commands that set vertex arrays (2.8), and the client attribute stack (6.1.14).
#include "scene/state/arrays.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace twinlight {

namespace {

// The types and sizes that each pointer command takes (table 2.4).
struct Allowed {
    int smallest, largest;  // size
    std::vector<Enum> types;
};

Allowed allowed_for(CommandId id) {
    switch (id) {
        case CommandId::glNormalPointer: return {3, 3, {kGL_BYTE, kGL_SHORT, kGL_INT, kGL_FLOAT, kGL_DOUBLE}};
        case CommandId::glColorPointer:
            return {3,
                    4,
                    {kGL_BYTE, kGL_UNSIGNED_BYTE, kGL_SHORT, kGL_UNSIGNED_SHORT, kGL_INT, kGL_UNSIGNED_INT, kGL_FLOAT,
                     kGL_DOUBLE}};
        case CommandId::glTexCoordPointer: return {1, 4, {kGL_SHORT, kGL_INT, kGL_FLOAT, kGL_DOUBLE}};
        case CommandId::glEdgeFlagPointer: return {1, 1, {kGL_UNSIGNED_BYTE}};
        default: return {2, 4, {kGL_SHORT, kGL_INT, kGL_FLOAT, kGL_DOUBLE}};
    }
}

// Table 2.5: the formats of glInterleavedArrays, from GL_V2F on. A size of 0 means that there is no such array. Offsets
// are in floats; four bytes of colour (c) count as one float.
struct Interleaved {
    int tex_coord, color, vertex;
    bool bytes_of_color, normal;
    int color_at, normal_at, vertex_at, stride;
};

constexpr Interleaved kInterleaved[] = {
    {0, 0, 2, false, false, 0, 0, 0, 2},   // V2F
    {0, 0, 3, false, false, 0, 0, 0, 3},   // V3F
    {0, 4, 2, true, false, 0, 0, 1, 3},    // C4UB_V2F
    {0, 4, 3, true, false, 0, 0, 1, 4},    // C4UB_V3F
    {0, 3, 3, false, false, 0, 0, 3, 6},   // C3F_V3F
    {0, 0, 3, false, true, 0, 0, 3, 6},    // N3F_V3F
    {0, 4, 3, false, true, 0, 4, 7, 10},   // C4F_N3F_V3F
    {2, 0, 3, false, false, 0, 0, 2, 5},   // T2F_V3F
    {4, 0, 4, false, false, 0, 0, 4, 8},   // T4F_V4F
    {2, 4, 3, true, false, 2, 0, 3, 6},    // T2F_C4UB_V3F
    {2, 3, 3, false, false, 2, 0, 5, 8},   // T2F_C3F_V3F
    {2, 0, 3, false, true, 0, 2, 5, 8},    // T2F_N3F_V3F
    {2, 4, 3, false, true, 2, 6, 9, 12},   // T2F_C4F_N3F_V3F
    {4, 4, 4, false, true, 4, 8, 11, 15},  // T4F_C4F_N3F_V4F
};

}  // namespace

bool draws_arrays(CommandId id) {
    return id == CommandId::glDrawArrays || id == CommandId::glDrawElements || id == CommandId::glDrawRangeElements ||
           id == CommandId::glArrayElement;
}

std::optional<GlError> VertexArrays::apply(const Command& c) {
    switch (c.id) {
        case CommandId::glEnableClientState:
        case CommandId::glDisableClientState: return enable(c);
        case CommandId::glVertexPointer:
        case CommandId::glNormalPointer:
        case CommandId::glColorPointer:
        case CommandId::glTexCoordPointer:
        case CommandId::glEdgeFlagPointer: return set_pointer(c);
        case CommandId::glInterleavedArrays: return interleaved(c);
        case CommandId::glClientActiveTexture: return active_texture(c);
        case CommandId::glPushClientAttrib: return push(c);
        case CommandId::glPopClientAttrib: return pop(c);
        case CommandId::glGenBuffers: return generate(c);
        case CommandId::glDeleteBuffers: return remove(c);
        case CommandId::glBindBuffer: return bind(c);
        case CommandId::glBufferData: return data(c);
        case CommandId::glBufferSubData: return sub_data(c);
        case CommandId::glMapBuffer: return map(c);
        case CommandId::glUnmapBuffer: return unmap(c);
        default: return std::nullopt;
    }
}

bool* VertexArrays::enabled(Enum array) {
    switch (array) {
        case kGL_VERTEX_ARRAY: return &client_.vertex.enabled;
        case kGL_NORMAL_ARRAY: return &client_.normal.enabled;
        case kGL_COLOR_ARRAY: return &client_.color.enabled;
        case kGL_EDGE_FLAG_ARRAY: return &client_.edge_flag.enabled;
        case kGL_TEXTURE_COORD_ARRAY: return &client_.tex_coord[client_.active_unit].enabled;
        case kGL_INDEX_ARRAY: return client_.driver_only.data();
        case kGL_SECONDARY_COLOR_ARRAY: return &client_.driver_only[1];
        case kGL_FOG_COORD_ARRAY: return &client_.driver_only[2];
        default: return nullptr;
    }
}

std::optional<GlError> VertexArrays::enable(const Command& c) {
    bool* on = enabled(c.enumerant(0));
    if (!on) {
        return refused(kGL_INVALID_ENUM, c,
                       "{} is given {}; expected GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, "
                       "GL_TEXTURE_COORD_ARRAY or GL_EDGE_FLAG_ARRAY",
                       c.name(), enum_name(c.enumerant(0)));
    }
    *on = c.id == CommandId::glEnableClientState;
    return std::nullopt;
}

void VertexArrays::point(ArrayPointer& array, int size, Enum type, int stride, const Command& c, double offset) const {
    array.size = size;
    array.type = type;
    array.stride = stride;
    array.buffer = client_.array_buffer;
    array.memory = c.memory;
    array.offset = offset;
}

// glVertexPointer(size, type, stride, pointer); normals have no size, edge flags neither size nor type.
std::optional<GlError> VertexArrays::set_pointer(const Command& c) {
    const Allowed allowed = allowed_for(c.id);
    const bool has_size = allowed.smallest != allowed.largest, has_type = allowed.types.size() > 1;
    std::size_t next = 0;
    const double size = has_size ? c.number(next++) : allowed.smallest;
    const Enum type = has_type ? c.enumerant(next++) : allowed.types[0];
    const double stride = c.number(next++), offset = c.number(next);
    if (stride < 0)
        return refused(kGL_INVALID_VALUE, c, "the stride of {} is {}; it must be 0 or more", c.name(), stride);
    if (std::find(allowed.types.begin(), allowed.types.end(), type) == allowed.types.end()) {
        std::vector<std::string> names;
        for (Enum one : allowed.types) names.push_back(enum_name(one));
        return refused(kGL_INVALID_ENUM, c, "{} is given the type {}; expected {}", c.name(), enum_name(type),
                       fmt::join(names, ", "));
    }
    if (size < allowed.smallest || size > allowed.largest) {
        return refused(kGL_INVALID_VALUE, c, "{} is given the size {}; it must be in [{}, {}]", c.name(), size,
                       allowed.smallest, allowed.largest);
    }
    ArrayPointer& array = c.id == CommandId::glNormalPointer     ? client_.normal
                          : c.id == CommandId::glColorPointer    ? client_.color
                          : c.id == CommandId::glTexCoordPointer ? client_.tex_coord[client_.active_unit]
                          : c.id == CommandId::glEdgeFlagPointer ? client_.edge_flag
                                                                 : client_.vertex;
    point(array, static_cast<int>(size), type, static_cast<int>(stride), c, offset);
    return std::nullopt;
}

std::optional<GlError> VertexArrays::interleaved(const Command& c) {
    const Enum format = c.enumerant(0);
    const double stride = c.number(1), offset = c.number(2);
    if (stride < 0)
        return refused(kGL_INVALID_VALUE, c, "the stride of {} is {}; it must be 0 or more", c.name(), stride);
    if (format < kGL_V2F || format > kGL_T4F_C4F_N3F_V4F) {
        return refused(kGL_INVALID_ENUM, c, "{} is given the format {}; expected GL_V2F to GL_T4F_C4F_N3F_V4F",
                       c.name(), enum_name(format));
    }
    const Interleaved& row = kInterleaved[format - kGL_V2F];
    const int step = stride > 0 ? static_cast<int>(stride) : row.stride * 4;
    const auto place = [&](ArrayPointer& array, int size, Enum type, int at) {
        array.enabled = size > 0;
        if (size > 0) point(array, size, type, step, c, offset + at * 4);
    };
    client_.edge_flag.enabled = false;
    client_.driver_only = {};
    place(client_.tex_coord[client_.active_unit], row.tex_coord, kGL_FLOAT, 0);
    place(client_.color, row.color, row.bytes_of_color ? kGL_UNSIGNED_BYTE : kGL_FLOAT, row.color_at);
    place(client_.normal, row.normal ? 3 : 0, kGL_FLOAT, row.normal_at);
    place(client_.vertex, row.vertex, kGL_FLOAT, row.vertex_at);
    return std::nullopt;
}

std::optional<GlError> wrong_texture_unit(const Command& c) {
    if (c.enumerant(0) - kGL_TEXTURE0 < kMaxTextureUnits) return std::nullopt;
    return refused(kGL_INVALID_ENUM, c, "{} is given {}; expected GL_TEXTURE0 to GL_TEXTURE{}", c.name(),
                   enum_name(c.enumerant(0)), kMaxTextureUnits - 1);
}

std::optional<GlError> VertexArrays::active_texture(const Command& c) {
    auto error = wrong_texture_unit(c);
    if (!error) client_.active_unit = c.enumerant(0) - kGL_TEXTURE0;
    return error;
}

// ---- The client attribute stack; State handles GL_CLIENT_PIXEL_STORE_BIT ----

std::optional<GlError> VertexArrays::push(const Command& c) {
    if (stack_.size() >= kClientAttributeStackDepth) {
        return refused(kGL_STACK_OVERFLOW, c,
                       "the client attribute stack is full ({} levels); a glPopClientAttrib is missing",
                       kClientAttributeStackDepth);
    }
    stack_.push_back({client_, c.enumerant(0)});
    return std::nullopt;
}

std::optional<GlError> VertexArrays::pop(const Command& c) {
    if (stack_.empty()) return refused(kGL_STACK_UNDERFLOW, c, "glPopClientAttrib without a glPushClientAttrib");
    if ((stack_.back().mask & kGL_CLIENT_VERTEX_ARRAY_BIT) != 0) client_ = std::move(stack_.back().client);
    stack_.pop_back();
    return std::nullopt;
}

}  // namespace twinlight
