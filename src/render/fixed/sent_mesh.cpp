#include "render/fixed/sent_mesh.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "render/context/gl.h"
#include "render/stages/buffers.h"

namespace twinlight::fixed {
namespace {

template <class Property>
bool all_share(const Draw& draw, Property Vertex::*property) {
    return std::ranges::all_of(draw.vertices,
                               [&](const Vertex& v) { return v.*property == draw.vertices.front().*property; });
}

}  // namespace

SentMesh::SentMesh(const Draw& draw, const MeshContents& contents, const ReplayOptions& options)
    : sending_(options.sending), mode_(draw.mode) {
    if (draw.vertices.empty()) return;
    shared_ = draw.vertices.front();
    const bool w_is_1 =
        std::ranges::all_of(draw.vertices, [](const Vertex& vertex) { return vertex.position_object.w == 1; });
    const auto add = [&](Attribute& attribute, int size) {
        attribute = {size, stride_};
        stride_ += static_cast<std::size_t>(size) * sizeof(float);
    };
    add(position_, w_is_1 ? 3 : 4);
    if (contents.normal) add(normal_, 3);
    if (contents.color && !all_share(draw, &Vertex::color)) add(color_, 4);
    if (contents.tex_coord && !all_share(draw, &Vertex::tex_coord)) add(tex_coord_, 4);
    for (const FurtherUnit& further : draw.further_units)
        if (contents.further_tex_coords)
            add(further_tex_coords_.emplace_back(GL_TEXTURE0 + static_cast<GLenum>(further.number), Attribute{}).second,
                4);
    if (!draw.secondary_colors.empty()) add(secondary_color_, 3);
    if (!draw.fog_coords.empty()) add(fog_coord_, 1);

    const bool in_buffers = sending_ == Sending::kBuffers;
    if (in_buffers) elements_.emplace(draw, options.patches);
    const bool has_flags = needs_edge_flags(draw);
    values_.reserve(draw.vertices.size() * stride_ / sizeof(float));
    for_each_vertex(draw, in_buffers ? elements_->vertices() : std::vector<std::uint32_t>{}, [&](const Vertex& vertex) {
        const auto put = [&](const auto& v, const Attribute& attribute) {
            for (int n = 0; n < attribute.size; ++n) values_.push_back(static_cast<float>(v[n]));
        };
        put(vertex.position_object, position_);
        put(vertex.normal_object, normal_);
        put(vertex.color, color_);
        put(vertex.tex_coord, tex_coord_);
        for (const auto& [unit, attribute] : further_tex_coords_)
            put(draw.tex_coord(unit - GL_TEXTURE0, static_cast<std::size_t>(&vertex - draw.vertices.data())),
                attribute);
        const auto number = static_cast<std::size_t>(&vertex - draw.vertices.data());
        if (secondary_color_.size != 0) put(draw.secondary_colors[number], secondary_color_);
        if (fog_coord_.size != 0) values_.push_back(static_cast<float>(draw.fog_coords[number]));
        if (has_flags) flags_.push_back(vertex.edge_flag ? 1 : 0);
    });
    if (in_buffers) {
        vertices_ = filled_buffer(GL_ARRAY_BUFFER, values_);
        if (!flags_.empty()) edge_flags_ = filled_buffer(GL_ARRAY_BUFFER, flags_);
        values_ = {};
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        return;
    }
    const bool cuts = cuts_quadrilaterals(draw);
    if (cuts) mode_ = kGL_TRIANGLES;
    indices_ = cuts ? SharedVector(cut_indices(draw)) : draw.indices;
    count_ = static_cast<int>(cuts ? indices_.size() : draw.count());
    if (count_ == 0) stride_ = 0;
    if (sending_ == Sending::kDisplayList) {
        list_ = glGenLists(1);
        glNewList(list_, GL_COMPILE);
        draw_immediately();
        glEndList();
    }
}

SentMesh::~SentMesh() {
    for (const GLuint name : {vertices_, edge_flags_})
        if (name != 0) glDeleteBuffers(1, &name);
    if (list_ != 0) glDeleteLists(list_, 1);
}

void SentMesh::draw() const {
    if (stride_ == 0) return;
    const glm::vec4 color(shared_.color), tex_coord(shared_.tex_coord);
    glColor4fv(&color[0]);
    glTexCoord4fv(&tex_coord[0]);
    glEdgeFlag(shared_.edge_flag);
    switch (sending_) {
        case Sending::kBuffers:
        case Sending::kClientArrays: return draw_arrays();
        case Sending::kImmediate: return draw_immediately();
        case Sending::kDisplayList: return glCallList(list_);
    }
}

void SentMesh::draw_arrays() const {
    const auto stride = static_cast<GLsizei>(stride_);
    // The array's address, or its offset into the bound buffer.
    const auto* memory = reinterpret_cast<const char*>(values_.data());
    const auto at = [&](const Attribute& attribute) {
        return elements_ ? buffer_offset(attribute.offset) : memory + attribute.offset;
    };
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(position_.size, GL_FLOAT, stride, at(position_));
    if (normal_.size != 0) {
        glEnableClientState(GL_NORMAL_ARRAY);
        glNormalPointer(GL_FLOAT, stride, at(normal_));
    }
    if (color_.size != 0) {
        glEnableClientState(GL_COLOR_ARRAY);
        glColorPointer(color_.size, GL_FLOAT, stride, at(color_));
    }
    if (tex_coord_.size != 0) {
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(tex_coord_.size, GL_FLOAT, stride, at(tex_coord_));
    }
    for (const auto& [unit, attribute] : further_tex_coords_) {
        glClientActiveTexture(unit);
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(attribute.size, GL_FLOAT, stride, at(attribute));
    }
    if (secondary_color_.size != 0) {
        glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
        glSecondaryColorPointer(secondary_color_.size, GL_FLOAT, stride, at(secondary_color_));
    }
    if (fog_coord_.size != 0) {
        glEnableClientState(GL_FOG_COORD_ARRAY);
        glFogCoordPointer(GL_FLOAT, stride, at(fog_coord_));
    }
    if (edge_flags_ != 0 || !flags_.empty()) {
        glBindBuffer(GL_ARRAY_BUFFER, edge_flags_);
        glEnableClientState(GL_EDGE_FLAG_ARRAY);
        glEdgeFlagPointer(0, elements_ ? nullptr : flags_.data());
    }
    if (elements_)
        elements_->draw();
    else if (indices_.empty())
        glDrawArrays(mode_, 0, count_);
    else
        glDrawElements(mode_, count_, GL_UNSIGNED_INT, indices_.data());
    for (const auto& [unit, attribute] : further_tex_coords_) {
        glClientActiveTexture(unit);
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    }
    if (!further_tex_coords_.empty()) glClientActiveTexture(GL_TEXTURE0);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY,
                               GL_EDGE_FLAG_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY})
        glDisableClientState(array);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void SentMesh::draw_immediately() const {
    const std::size_t stride = stride_ / sizeof(float);
    glBegin(mode_);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        const std::size_t index = indices_.empty() ? i : indices_[i];
        const float* vertex = values_.data() + index * stride;
        const auto at = [&](const Attribute& attribute) { return vertex + attribute.offset / sizeof(float); };
        if (!flags_.empty()) glEdgeFlag(flags_[index]);
        if (normal_.size != 0) glNormal3fv(at(normal_));
        if (color_.size != 0) glColor4fv(at(color_));
        if (tex_coord_.size != 0) glTexCoord4fv(at(tex_coord_));
        for (const auto& [unit, attribute] : further_tex_coords_) glMultiTexCoord4fv(unit, at(attribute));
        if (secondary_color_.size != 0) glSecondaryColor3fv(at(secondary_color_));
        if (fog_coord_.size != 0) glFogCoordfv(at(fog_coord_));
        if (position_.size == 3)
            glVertex3fv(at(position_));
        else
            glVertex4fv(at(position_));
    }
    glEnd();
}

// ---- With materials ----

namespace {

void send_material(GLenum face, const Material& material, const FaceEffects& varying) {
    const auto send = [&](bool varies, GLenum name, const glm::dvec4& value) {
        if (varies) glMaterialfv(face, name, &glm::vec4(value)[0]);
    };
    send(varying.varies_emission, GL_EMISSION, material.emission);
    send(varying.varies_ambient, GL_AMBIENT, material.ambient);
    send(varying.varies_diffuse, GL_DIFFUSE, material.diffuse);
    send(varying.varies_specular, GL_SPECULAR, material.specular);
    if (varying.varies_shininess) glMaterialf(face, GL_SHININESS, static_cast<float>(material.shininess));
}

}  // namespace

void send_values(const Draw& draw, std::size_t index) {
    const Vertex& vertex = draw.vertices[index];
    glEdgeFlag(vertex.edge_flag);
    glNormal3fv(&glm::vec3(vertex.normal_object)[0]);
    glColor4fv(&glm::vec4(vertex.color)[0]);
    glTexCoord4fv(&glm::vec4(vertex.tex_coord)[0]);
    for (const FurtherUnit& further : draw.further_units)
        glMultiTexCoord4fv(GL_TEXTURE0 + static_cast<GLenum>(further.number), &glm::vec4(further.tex_coords[index])[0]);
    if (!draw.secondary_colors.empty()) glSecondaryColor3dv(&draw.secondary_colors[index][0]);
    if (!draw.fog_coords.empty()) glFogCoordd(draw.fog_coords[index]);
}

void draw_with_materials(const Draw& draw, const FaceEffects& front, const FaceEffects& back) {
    std::uint32_t current = std::numeric_limits<std::uint32_t>::max();
    glBegin(draw.mode);
    for (std::size_t i = 0; i < draw.count(); ++i) {
        const std::uint32_t index = draw.index(i);
        const Vertex& vertex = draw.vertices[index];
        if (vertex.material != current) {
            current = vertex.material;
            const Materials& materials = draw.materials.at(current);
            send_material(GL_FRONT, materials.front, front);
            send_material(GL_BACK, materials.back, back);
        }
        send_values(draw, index);
        glVertex4fv(&glm::vec4(vertex.position_object)[0]);
    }
    glEnd();
}

}  // namespace twinlight::fixed
