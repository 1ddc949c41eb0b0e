#include "stages/elements.h"

#include <span>

#include "context/gl.h"

namespace twinlight {
namespace {

// Smaller meshes are hardly worth it.
constexpr std::size_t kFewIndices = 2 * kPatchIndices;

// Of the triangles at a pixel the nearest shows, whichever comes first. (Where two have the same depth there, to the last
// bit, the first or the last shows.)
bool is_order_free(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const bool nearest = raster.depth_test && raster.depth_mask &&
                         (raster.depth_func == kGL_LESS || raster.depth_func == kGL_LEQUAL ||
                          raster.depth_func == kGL_GREATER || raster.depth_func == kGL_GEQUAL);
    const bool filled = raster.polygon_mode_front == kGL_FILL && raster.polygon_mode_back == kGL_FILL;
    return draw.mode == kGL_TRIANGLES && nearest && filled && !draw.fragment.blend;
}

const void* buffer_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }  // NOLINT: GL's offset

template <class Index>
GLuint filled_buffer(const std::vector<Index>& indices) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(Index)), indices.data(),
                 GL_STATIC_DRAW);
    return name;
}

}  // namespace

Elements::Elements(const Draw& draw, const RenderOptions& options)
    : mode_(draw.mode), count_(static_cast<int>(draw.count())) {
    if (draw.indices.empty()) return;
    // What is no whole triangle is not drawn (2.6.1).
    const std::size_t whole = draw.indices.size() / 3 * 3;
    if (options.patches && whole >= kFewIndices && is_order_free(draw))
        patched_ = patched(std::span(draw.indices).first(whole), draw.vertices.size());
    indices_ = patched_.patches.empty() ? filled_buffer(draw.indices) : filled_buffer(patched_.indices);
    patched_.indices = {};
}

Elements::~Elements() { glDeleteBuffers(1, &indices_); }

void Elements::draw() const {
    if (indices_ == 0) return glDrawArrays(mode_, 0, count_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    if (patched_.patches.empty()) return glDrawElements(mode_, count_, GL_UNSIGNED_INT, nullptr);
    for (const PatchedTriangles::Patch& patch : patched_.patches)
        glDrawRangeElementsBaseVertex(mode_, 0, patch.vertex_count - 1, static_cast<GLsizei>(patch.index_count),
                                      GL_UNSIGNED_SHORT, buffer_offset(patch.first_index * sizeof(std::uint16_t)),
                                      static_cast<GLint>(patch.first_vertex));
}

}  // namespace twinlight
