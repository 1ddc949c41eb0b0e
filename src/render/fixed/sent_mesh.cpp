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

GLenum array_of(VertexAttribute attribute) {
    switch (attribute) {
        case VertexAttribute::kPosition: return GL_VERTEX_ARRAY;
        case VertexAttribute::kNormal: return GL_NORMAL_ARRAY;
        case VertexAttribute::kColor: return GL_COLOR_ARRAY;
        case VertexAttribute::kSecondaryColor: return GL_SECONDARY_COLOR_ARRAY;
        case VertexAttribute::kFogCoord: return GL_FOG_COORD_ARRAY;
        default: return GL_TEXTURE_COORD_ARRAY;
    }
}

// For commands on the array of texture coordinates.
void choose_unit(VertexAttribute attribute) {
    if (const auto unit = texture_unit_of(attribute)) glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(*unit));
}

void set_pointer(VertexAttribute attribute, GLint size, GLsizei stride, const void* values) {
    switch (attribute) {
        case VertexAttribute::kPosition: return glVertexPointer(size, GL_FLOAT, stride, values);
        case VertexAttribute::kNormal: return glNormalPointer(GL_FLOAT, stride, values);
        case VertexAttribute::kColor: return glColorPointer(size, GL_FLOAT, stride, values);
        case VertexAttribute::kSecondaryColor: return glSecondaryColorPointer(size, GL_FLOAT, stride, values);
        case VertexAttribute::kFogCoord: return glFogCoordPointer(GL_FLOAT, stride, values);
        default: return glTexCoordPointer(size, GL_FLOAT, stride, values);
    }
}

// Between glBegin and glEnd.
void send(VertexAttribute attribute, GLint size, const float* values) {
    switch (attribute) {
        case VertexAttribute::kPosition: return size == 3 ? glVertex3fv(values) : glVertex4fv(values);
        case VertexAttribute::kNormal: return glNormal3fv(values);
        case VertexAttribute::kColor: return glColor4fv(values);
        case VertexAttribute::kSecondaryColor: return glSecondaryColor3fv(values);
        case VertexAttribute::kFogCoord: return glFogCoordfv(values);
        default: return glMultiTexCoord4fv(GL_TEXTURE0 + static_cast<GLenum>(*texture_unit_of(attribute)), values);
    }
}

}  // namespace

SentMesh::SentMesh(const Draw& draw, const MeshContents& contents, const ReplayOptions& options)
    : sending_(options.sending), mode_(draw.mode) {
    if (draw.vertices.empty()) return;
    shared_ = draw.vertices.front();
    const bool w_is_1 =
        std::ranges::all_of(draw.vertices, [](const Vertex& vertex) { return vertex.position_object.w == 1; });
    const auto add = [&](VertexAttribute attribute, int size) {
        sent_.push_back({attribute, size, stride_});
        stride_ += static_cast<std::size_t>(size) * sizeof(float);
    };
    if (contents.normal) add(VertexAttribute::kNormal, 3);
    if (contents.color && !all_share(draw, &Vertex::color)) add(VertexAttribute::kColor, 4);
    if (contents.tex_coord && !all_share(draw, &Vertex::tex_coord)) add(VertexAttribute::kTexCoord0, 4);
    for (const VertexColumn& column : draw.columns)
        if (contents.further_tex_coords || !texture_unit_of(column.attribute))
            add(column.attribute, row_of(column.attribute).size);
    add(VertexAttribute::kPosition, w_is_1 ? 3 : 4);

    const bool in_buffers = sending_ == Sending::kBuffers;
    if (in_buffers) elements_.emplace(draw, options.patches);
    const bool has_flags = needs_edge_flags(draw);
    values_.reserve(draw.vertices.size() * stride_ / sizeof(float));
    for_each_vertex(draw, in_buffers ? elements_->vertices() : std::vector<std::uint32_t>{}, [&](const Vertex& vertex) {
        const auto put = [&](const auto& v, int size) {
            for (int n = 0; n < size; ++n) values_.push_back(static_cast<float>(v[n]));
        };
        for (const Sent& sent : sent_) {
            switch (sent.attribute) {
                case VertexAttribute::kPosition: put(vertex.position_object, sent.size); break;
                case VertexAttribute::kNormal: put(vertex.normal_object, sent.size); break;
                case VertexAttribute::kColor: put(vertex.color, sent.size); break;
                case VertexAttribute::kTexCoord0: put(vertex.tex_coord, sent.size); break;
                default:
                    put((*draw.column(sent.attribute))[static_cast<std::size_t>(&vertex - draw.vertices.data())],
                        sent.size);
            }
        }
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
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    for (const Sent& sent : sent_) {
        choose_unit(sent.attribute);
        glEnableClientState(array_of(sent.attribute));
        set_pointer(sent.attribute, sent.size, stride, elements_ ? buffer_offset(sent.offset) : memory + sent.offset);
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
    for (const Sent& sent : sent_) {
        choose_unit(sent.attribute);
        glDisableClientState(array_of(sent.attribute));
    }
    glClientActiveTexture(GL_TEXTURE0);
    glDisableClientState(GL_EDGE_FLAG_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void SentMesh::draw_immediately() const {
    const std::size_t stride = stride_ / sizeof(float);
    glBegin(mode_);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        const std::size_t index = indices_.empty() ? i : indices_[i];
        const float* vertex = values_.data() + index * stride;
        if (!flags_.empty()) glEdgeFlag(flags_[index]);
        for (const Sent& sent : sent_) send(sent.attribute, sent.size, vertex + sent.offset / sizeof(float));
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
    for (const VertexColumn& column : draw.columns)
        send(column.attribute, row_of(column.attribute).size, &glm::vec4(column.values[index])[0]);
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
