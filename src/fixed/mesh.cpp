#include "fixed/mesh.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "context/gl.h"
#include "stages/buffers.h"

namespace twinlight::fixed {
namespace {

template <class Property>
bool all_share(const Draw& draw, Property Vertex::*property) {
    return std::ranges::all_of(draw.vertices,
                               [&](const Vertex& v) { return v.*property == draw.vertices.front().*property; });
}

}  // namespace

Mesh::Mesh(const Draw& draw, const MeshContents& contents, const RenderOptions& options) : elements_(draw, options) {
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

    std::vector<float> values;
    std::vector<GLboolean> edge_flags;
    values.reserve(draw.vertices.size() * stride_ / sizeof(float));
    for_each_vertex(draw, elements_.vertices(), [&](const Vertex& vertex) {
        const auto put = [&](const auto& v, const Attribute& attribute) {
            for (int n = 0; n < attribute.size; ++n) values.push_back(static_cast<float>(v[n]));
        };
        put(vertex.position_object, position_);
        put(vertex.normal_object, normal_);
        put(vertex.color, color_);
        put(vertex.tex_coord, tex_coord_);
        edge_flags.push_back(vertex.edge_flag);
    });
    vertices_ = filled_buffer(GL_ARRAY_BUFFER, values);
    if (needs_edge_flags(draw)) edge_flags_ = filled_buffer(GL_ARRAY_BUFFER, edge_flags);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

Mesh::~Mesh() {
    for (const GLuint name : {vertices_, edge_flags_})
        if (name != 0) glDeleteBuffers(1, &name);
}

void Mesh::draw() const {
    if (vertices_ == 0) return;
    const auto stride = static_cast<GLsizei>(stride_);
    const glm::vec4 color(shared_.color), tex_coord(shared_.tex_coord);
    glColor4fv(&color[0]);
    glTexCoord4fv(&tex_coord[0]);
    glEdgeFlag(shared_.edge_flag);

    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(position_.size, GL_FLOAT, stride, buffer_offset(position_.offset));
    if (normal_.size != 0) {
        glEnableClientState(GL_NORMAL_ARRAY);
        glNormalPointer(GL_FLOAT, stride, buffer_offset(normal_.offset));
    }
    if (color_.size != 0) {
        glEnableClientState(GL_COLOR_ARRAY);
        glColorPointer(color_.size, GL_FLOAT, stride, buffer_offset(color_.offset));
    }
    if (tex_coord_.size != 0) {
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(tex_coord_.size, GL_FLOAT, stride, buffer_offset(tex_coord_.offset));
    }
    if (edge_flags_ != 0) {
        glBindBuffer(GL_ARRAY_BUFFER, edge_flags_);
        glEnableClientState(GL_EDGE_FLAG_ARRAY);
        glEdgeFlagPointer(0, nullptr);
    }
    elements_.draw();
    for (const GLenum array :
         {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_EDGE_FLAG_ARRAY})
        glDisableClientState(array);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
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

void draw_with_materials(const Draw& draw, const FaceEffects& front, const FaceEffects& back) {
    std::uint32_t current = std::numeric_limits<std::uint32_t>::max();
    glBegin(draw.mode);
    for (std::size_t i = 0; i < draw.count(); ++i) {
        const Vertex& vertex = draw.vertices[draw.index(i)];
        if (vertex.material != current) {
            current = vertex.material;
            const Materials& materials = draw.materials.at(current);
            send_material(GL_FRONT, materials.front, front);
            send_material(GL_BACK, materials.back, back);
        }
        glEdgeFlag(vertex.edge_flag);
        glNormal3fv(&glm::vec3(vertex.normal_object)[0]);
        glColor4fv(&glm::vec4(vertex.color)[0]);
        glTexCoord4fv(&glm::vec4(vertex.tex_coord)[0]);
        glVertex4fv(&glm::vec4(vertex.position_object)[0]);
    }
    glEnd();
}

}  // namespace twinlight::fixed
