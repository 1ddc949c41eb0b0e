// Drawing from vertex arrays (2.8). arrays.h handles the arrays themselves.
#include <fmt/format.h>

#include "scene/state/state.h"

namespace twinlight {

void State::client_arrays(const Command& c) {
    if (const auto error = arrays_.apply(c)) return raise(*error);
    // State saves the pixel storage modes (6.1.14).
    if (c.id == CommandId::glPushClientAttrib) {
        saved_pixel_stores_.push_back((c.enumerant(0) & kGL_CLIENT_PIXEL_STORE_BIT) != 0 ? std::optional(pixel_store_)
                                                                                         : std::nullopt);
    } else if (c.id == CommandId::glPopClientAttrib) {
        if (saved_pixel_stores_.back()) pixel_store_ = *saved_pixel_stores_.back();
        saved_pixel_stores_.pop_back();
    } else if (c.id == CommandId::glEnableClientState) {
        const Enum array = c.enumerant(0);
        if (array == kGL_SECONDARY_COLOR_ARRAY || array == kGL_FOG_COORD_ARRAY)
            outside(fmt::format("{}({})", c.name(), enum_name(array)), c.place);
    }
}

std::optional<ArrayVertices> State::array_vertices(const Command& c) {
    show_shared_buffers();
    if (const auto error = arrays_.check(c)) {
        raise(*error);
        return std::nullopt;
    }
    ArrayVertices read = arrays_.read(c, options_.signed_rule);
    for (Vertex& v : read.vertices) sanitize(v);
    for (VertexColumn& column : read.columns)
        for (glm::dvec4& values : column.values) sanitize(values);
    return read;
}

namespace {

// Fills attributes that no array provides with the current values.
Vertex complete(Vertex vertex, const ArrayVertices& read, const Vertex& current) {
    if (!read.has_normal) vertex.normal_object = current.normal_object;
    if (!read.has_color) vertex.color = current.color;
    if (!read.has_tex_coord) vertex.tex_coord = current.tex_coord;
    if (!read.has_edge_flag) vertex.edge_flag = current.edge_flag;
    return vertex;
}

}  // namespace

// RULING: drawing leaves the current values unchanged; section 2.8 leaves this open.
void State::draw_arrays(const Command& c) {
    if (const auto read = array_vertices(c)) draw(c, *read);
}

void State::draw(const Command& c, const ArrayVertices& read) {
    if (!read.has_position || read.vertices.empty()) return;  // 2.8: no primitives are constructed
    const std::size_t bytes = bytes_of_draw() + vertex_bytes(read.mode, read.vertices.size(), read.indices.size());
    if (!has_room(c, bytes)) return;
    Draw draw = new_draw(read.mode, c.place);
    std::vector<Vertex> vertices;
    vertices.reserve(read.vertices.size());
    for (const Vertex& v : read.vertices) vertices.push_back(complete(v, read, a_.current));
    for (Vertex& v : vertices) v.material = 0;
    draw.vertices = std::move(vertices);
    draw.indices = read.indices;
    for (VertexColumn& column : draw.columns) {
        const auto found = std::ranges::find(read.columns, column.attribute, &VertexColumn::attribute);
        if (found != read.columns.end()) column.values = found->values;
    }
    fill_columns(draw, a_.current);
    show(std::move(draw));
}

// 2.8: calls glEdgeFlag, glTexCoord, glColor, glNormal and finally glVertex, for the arrays that are enabled.
void State::array_element(const Command& c) {
    if (const auto read = array_vertices(c)) send_element(c, *read);
}

void State::send_element(const Command& c, const ArrayVertices& element) {
    const Vertex values = complete(element.vertices.front(), element, a_.current);
    a_.current.normal_object = values.normal_object;
    a_.current.tex_coord = values.tex_coord;
    for (const VertexColumn& column : element.columns) a_.current.further(column.attribute) = column.values.front();
    a_.current.edge_flag = values.edge_flag;
    a_.current.color = values.color;
    if (element.has_color) track_color();
    if (!element.has_position || !open_ || !has_room(c, vertex_bytes(open_->mode, 1))) return;
    a_.current.position_object = values.position_object;
    open_->vertices.edit().push_back(a_.current);
    fill_columns(*open_, a_.current);
}

}  // namespace twinlight
