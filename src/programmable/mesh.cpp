#include "programmable/mesh.h"

#include <algorithm>
#include <vector>

#include "context/gl.h"
#include "programmable/attributes.h"
#include "programmable/draw_values.h"

namespace twinlight::programmable {
namespace {

// 2.6.2: edge flags count where polygons are drawn as their edges or corners, and only of these.
bool needs_edge_flags(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const bool has_edges = draw.mode == kGL_TRIANGLES || draw.mode == kGL_QUADS || draw.mode == kGL_POLYGON;
    const bool filled = raster.polygon_mode_front == kGL_FILL && raster.polygon_mode_back == kGL_FILL;
    return has_edges && !filled && !std::ranges::all_of(draw.vertices, &Vertex::edge_flag);
}

const void* buffer_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }  // NOLINT: GL's offset

template <class Value>
GLuint filled_buffer(const std::vector<Value>& values) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(),
                 GL_STATIC_DRAW);
    return buffer;
}

}  // namespace

Mesh::Mesh(const Draw& draw, const EffectSet& effects, const RenderOptions& options) : elements_(draw, options) {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    vertices_ = filled_buffer(vertex_array(draw, effects, elements_.vertices()));
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
    // They pass every program by: GL has no attribute of shaders for them.
    if (needs_edge_flags(draw)) {
        std::vector<GLboolean> flags;
        for_each_vertex(draw, elements_.vertices(), [&](const Vertex& vertex) { flags.push_back(vertex.edge_flag); });
        edge_flags_ = filled_buffer(flags);
        glEnableClientState(GL_EDGE_FLAG_ARRAY);
        glEdgeFlagPointer(0, nullptr);
    }
}

Mesh::~Mesh() {
    for (const GLuint buffer : {vertices_, edge_flags_}) glDeleteBuffers(1, &buffer);
    glDeleteVertexArrays(1, &array_);
}

void Mesh::draw() const {
    glBindVertexArray(array_);
    elements_.draw();
}

}  // namespace twinlight::programmable
