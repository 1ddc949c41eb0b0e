#include "render/programmable/uploaded_mesh.h"

#include <vector>

#include "render/context/gl.h"
#include "render/programmable/numbers/draw_values.h"
#include "render/stages/buffers.h"

namespace twinlight::programmable {

MeshForm mesh_form(const Draw& draw, const EffectSet& effects, const glm::dvec3& origin_object) {
    return {.attributes = attributes(effects),
            .unit_normals = makes_normals_unit(effects),
            .borders = draw.draws_borders(),
            .origin_object = origin_object};
}

UploadedMesh::UploadedMesh(const Draw& draw, const EffectSet& effects, bool patches, const glm::dvec3& origin_object)
    : elements_(draw, patches) {
    upload(draw, effects, origin_object);
    // Edge flags bypass the shaders: GL has no shader attribute for them.
    if (needs_edge_flags(draw)) {
        std::vector<GLboolean> flags;
        for_each_vertex(draw, elements_.vertices(), [&](const Vertex& vertex) { flags.push_back(vertex.edge_flag); });
        edge_flags_ = filled_buffer(GL_ARRAY_BUFFER, flags);
        bytes_ += flags.size();
        glEnableClientState(GL_EDGE_FLAG_ARRAY);
        glEdgeFlagPointer(0, nullptr);
    }
}

UploadedMesh::UploadedMesh(const JoinedDraws& draws, const EffectSet& effects, const glm::dvec3& origin_object)
    : elements_(draws.draw, draws.parts) {
    upload(draws.draw, effects, origin_object);
}

void UploadedMesh::upload(const Draw& draw, const EffectSet& effects, const glm::dvec3& origin_object) {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    const std::vector<float> values = vertex_array(draw, effects, elements_.vertices(), origin_object);
    vertices_ = filled_buffer(GL_ARRAY_BUFFER, values);
    bytes_ = values.size() * sizeof(float);
    const std::vector<Attribute> list = attributes(effects);
    std::size_t floats = 0;
    for (const Attribute& attribute : list) floats += static_cast<std::size_t>(attribute.size);
    std::size_t offset = 0;
    GLuint index = 0;
    for (const Attribute& attribute : list) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index++, attribute.size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(floats * sizeof(float)),
                              buffer_offset(offset * sizeof(float)));
        offset += static_cast<std::size_t>(attribute.size);
    }
}

UploadedMesh::~UploadedMesh() {
    for (const GLuint buffer : {vertices_, edge_flags_}) glDeleteBuffers(1, &buffer);
    glDeleteVertexArrays(1, &array_);
}

void UploadedMesh::draw(std::size_t range) const {
    glBindVertexArray(array_);
    elements_.draw(range);
}

}  // namespace twinlight::programmable
