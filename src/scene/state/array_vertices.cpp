// Reads the vertices of glDrawArrays, glDrawElements and glArrayElement (2.8) from the arrays.

#include <algorithm>
#include <unordered_map>

#include "scene/command/memory.h"
#include "scene/state/arrays.h"

namespace twinlight {

namespace {

Kind kind_of(Enum type) { return *kind_of_type(type); }  // the type must be valid

std::uint64_t element_bytes(const ArrayPointer& array) {
    return static_cast<std::uint64_t>(array.size) * size_of(kind_of(array.type));
}

std::uint64_t step(const ArrayPointer& array) {
    return array.stride > 0 ? static_cast<std::uint64_t>(array.stride) : element_bytes(array);
}

// The arguments of the three commands that draw.
struct Drawing {
    explicit Drawing(const Command& c) : mode(c.enumerant(0)) {
        if (c.id == CommandId::glDrawArrays) {
            first = c.number(1);
            count = c.number(2);
            return;
        }
        const std::size_t range = c.id == CommandId::glDrawRangeElements ? 2 : 0;
        count = c.number(range + 1);
        type = c.enumerant(range + 2);
        offset = c.number(range + 3);
    }
    Enum mode;
    double first = 0, count = 0, offset = 0;
    Enum type = 0;  // type of the indices; 0: no indices
};

struct Named {
    const char* name;
    const ArrayPointer* array;
};

std::vector<Named> enabled_arrays(const ClientArrays& client) {
    std::vector<Named> all{{"glVertexPointer", &client.vertex},
                           {"glNormalPointer", &client.normal},
                           {"glColorPointer", &client.color},
                           {"glEdgeFlagPointer", &client.edge_flag}};
    for (const ArrayPointer& unit : client.tex_coord) all.push_back({"glTexCoordPointer", &unit});
    std::erase_if(all, [](const Named& one) { return !one.array->enabled; });
    return all;
}

}  // namespace

std::optional<std::span<const std::byte>> VertexArrays::bytes(const ArrayPointer& array) const {
    if (array.buffer != 0) {
        const BufferObject* object = buffer(array.buffer);
        if (!object || array.memory) return std::nullopt;  // the address of an array is not an offset
        return object->bytes;
    }
    if (!array.memory) return std::nullopt;
    return array.memory->bytes;
}

std::optional<std::span<const std::byte>> VertexArrays::index_bytes(const Command& draw) const {
    if (client_.element_buffer != 0) {
        const BufferObject* object = buffer(client_.element_buffer);
        if (!object || draw.memory) return std::nullopt;
        return object->bytes;
    }
    if (!draw.memory) return std::nullopt;
    return draw.memory->bytes;
}

std::optional<GlError> VertexArrays::check_memory(const Command& draw, std::uint64_t smallest,
                                                  std::uint64_t largest) const {
    for (const Named& one : enabled_arrays(client_)) {
        const ArrayPointer& array = *one.array;
        const auto available = bytes(array);
        if (!available) {
            return undefined(kGL_INVALID_OPERATION, draw, "{} cannot read its array: {} was given {}", draw.name(),
                             one.name,
                             array.buffer != 0 ? tr("an array while a buffer object is bound; give an offset")
                                               : tr("NULL, or its buffer object was deleted"));
        }
        // Doubles do not overflow here (strides are below 2^31, indices below 2^32, offsets below 2^53), and they hold
        // the sizes of all possible arrays exactly.
        const auto stride = static_cast<double>(step(array)), size = static_cast<double>(available->size());
        const double needed = static_cast<double>(largest) * stride + static_cast<double>(element_bytes(array));
        if (array.offset + static_cast<double>(smallest) * stride >= 0 && array.offset + needed <= size) continue;
        return undefined(kGL_INVALID_OPERATION, draw,
                         "{} reads element {} of the array given to {}, which needs {} bytes, but there are {}; check "
                         "the count, the indices and the stride",
                         draw.name(), largest, one.name, needed, size - array.offset);
    }
    return std::nullopt;
}

std::optional<GlError> VertexArrays::check_elements(const Command& draw) const {
    const Drawing d(draw);
    if (d.type != kGL_UNSIGNED_BYTE && d.type != kGL_UNSIGNED_SHORT && d.type != kGL_UNSIGNED_INT) {
        return refused(kGL_INVALID_ENUM, draw,
                       "{} is given the type {}; expected GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or GL_UNSIGNED_INT",
                       draw.name(), enum_name(d.type));
    }
    const auto available = index_bytes(draw);
    const double needed = d.count * static_cast<double>(size_of(kind_of(d.type)));
    if (d.count > 0 && (!available || d.offset < 0 || d.offset + needed > static_cast<double>(available->size()))) {
        return undefined(kGL_INVALID_OPERATION, draw,
                         "{} reads {} bytes of indices, but there are {}; check the count and the type", draw.name(),
                         needed, available ? std::max(0.0, static_cast<double>(available->size()) - d.offset) : 0.0);
    }
    return std::nullopt;
}

std::optional<GlError> VertexArrays::check(const Command& draw) const {
    for (const Named& one : enabled_arrays(client_)) {
        const BufferObject* object = one.array->buffer == 0 ? nullptr : buffer(one.array->buffer);
        if (object && object->mapped) {
            return refused(kGL_INVALID_OPERATION, draw, "{} reads a mapped buffer; call glUnmapBuffer first",
                           draw.name());
        }
    }
    if (draw.id == CommandId::glArrayElement) {
        if (draw.number(0) < 0)
            return undefined(kGL_INVALID_VALUE, draw, "glArrayElement is given the index {}; it must be 0 or more",
                             draw.number(0));
        const auto index = static_cast<std::uint64_t>(draw.number(0));
        return check_memory(draw, index, index);
    }
    if (draw.id == CommandId::glDrawRangeElements && draw.number(2) < draw.number(1)) {
        return refused(kGL_INVALID_VALUE, draw, "the range of {} ends at {}, before its start {}", draw.name(),
                       draw.number(2), draw.number(1));
    }
    const Drawing d(draw);
    if (d.count < 0)
        return refused(kGL_INVALID_VALUE, draw, "the count of {} is {}; it must be 0 or more", draw.name(), d.count);
    if (d.mode > kGL_POLYGON) {
        return refused(kGL_INVALID_ENUM, draw, "{} is given {}; expected a primitive type, GL_POINTS to GL_POLYGON",
                       draw.name(), enum_name(d.mode));
    }
    if (d.count > kMaxDrawVertices) {
        return undefined(kGL_OUT_OF_MEMORY, draw, "{} draws {} vertices; the limit is {}", draw.name(), d.count,
                         kMaxDrawVertices);
    }
    if (draw.id == CommandId::glDrawArrays) {
        if (d.first < 0)
            return undefined(kGL_INVALID_VALUE, draw, "{} starts at element {}; it must be 0 or more", draw.name(),
                             d.first);
        if (d.count == 0) return std::nullopt;
        const auto first = static_cast<std::uint64_t>(d.first), count = static_cast<std::uint64_t>(d.count);
        return check_memory(draw, first, first + count - 1);
    }
    if (auto error = check_elements(draw)) return error;
    if (d.count == 0) return std::nullopt;
    const auto [smallest, largest] = index_range(draw);
    return check_memory(draw, static_cast<std::uint64_t>(smallest), static_cast<std::uint64_t>(largest));
}

std::vector<std::uint32_t> VertexArrays::buffers_read() const {
    std::vector<std::uint32_t> names;
    const auto add = [&](const ArrayPointer& array) {
        if (array.enabled && array.buffer != 0) names.push_back(array.buffer);
    };
    for (const ArrayPointer* array : {&client_.vertex, &client_.normal, &client_.color, &client_.edge_flag})
        add(*array);
    for (const ArrayPointer& array : client_.tex_coord) add(array);
    if (client_.element_buffer != 0) names.push_back(client_.element_buffer);
    return names;
}

std::pair<double, double> VertexArrays::index_range(const Command& draw) const {
    const std::vector<std::uint32_t> indices = elements(draw);
    if (indices.empty()) return {0, 0};
    const auto [smallest, largest] = std::minmax_element(indices.begin(), indices.end());
    return {*smallest, *largest};
}

std::vector<std::uint32_t> VertexArrays::elements(const Command& draw) const {
    const Drawing d(draw);
    const auto count = static_cast<std::size_t>(d.count);
    std::vector<std::uint32_t> indices(count);
    if (count == 0) return indices;
    const Kind kind = kind_of(d.type);
    const std::span<const std::byte> available = *index_bytes(draw);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = static_cast<std::size_t>(d.offset) + i * size_of(kind);
        indices[i] = static_cast<std::uint32_t>(load(available.subspan(at), kind));
    }
    return indices;
}

void VertexArrays::read_element(std::uint64_t index, SignedRule rule, ArrayVertices& read) const {
    Vertex& vertex = read.vertices.emplace_back();
    const auto values = [&](const ArrayPointer& array, auto& target, bool is_normalised) {
        if (!array.enabled) return;
        const Kind kind = kind_of(array.type);
        const auto at = static_cast<std::size_t>(static_cast<std::int64_t>(array.offset) +
                                                 static_cast<std::int64_t>(index * step(array)));
        const std::span<const std::byte> from = bytes(array)->subspan(at);
        for (int i = 0; i < array.size; ++i) {
            const double value = load(from.subspan(static_cast<std::size_t>(i) * size_of(kind)), kind);
            target[i] = is_normalised ? real_from(value, kind, rule) : value;
        }
    };
    values(client_.vertex, vertex.position_object, false);
    values(client_.normal, vertex.normal_object, true);
    values(client_.color, vertex.color, true);
    values(client_.tex_coord[0], vertex.tex_coord, false);
    for (VertexColumn& column : read.columns)
        values(client_.tex_coord[*texture_unit_of(column.attribute)], column.values.emplace_back(0, 0, 0, 1), false);
    std::array<double, 1> flag{1};
    values(client_.edge_flag, flag, false);
    vertex.edge_flag = flag[0] != 0;
}

ArrayVertices VertexArrays::read(const Command& draw, SignedRule rule) const {
    ArrayVertices read{.has_position = client_.vertex.enabled,
                       .has_normal = client_.normal.enabled,
                       .has_color = client_.color.enabled,
                       .has_tex_coord = client_.tex_coord[0].enabled,
                       .has_edge_flag = client_.edge_flag.enabled};
    for (std::size_t unit = 1; unit < client_.tex_coord.size(); ++unit)
        if (client_.tex_coord[unit].enabled) read.columns.push_back({tex_coord_attribute(unit)});
    const auto add = [&](std::uint64_t index) { read_element(index, rule, read); };
    if (draw.id == CommandId::glArrayElement) {
        add(static_cast<std::uint64_t>(draw.number(0)));
        return read;
    }
    const Drawing d(draw);
    read.mode = d.mode;
    if (draw.id == CommandId::glDrawArrays) {
        const auto first = static_cast<std::uint64_t>(d.first), count = static_cast<std::uint64_t>(d.count);
        read.vertices.reserve(count);
        for (std::uint64_t i = 0; i < count; ++i) add(first + i);
        return read;
    }
    std::unordered_map<std::uint32_t, std::uint32_t> places;
    for (std::uint32_t index : elements(draw)) {
        const auto [place, is_new] = places.try_emplace(index, static_cast<std::uint32_t>(read.vertices.size()));
        if (is_new) add(index);
        read.indices.push_back(place->second);
    }
    return read;
}

}  // namespace twinlight
