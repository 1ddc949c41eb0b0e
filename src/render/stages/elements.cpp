#include "render/stages/elements.h"

#include <algorithm>
#include <span>

#include "render/context/gl.h"
#include "render/stages/buffers.h"

namespace twinlight {
namespace {

// Patches are hardly worth it for smaller meshes.
constexpr std::size_t kFewIndices = 2 * kPatchIndices;

// Whether the order of triangles does not matter: at each pixel the nearest is visible. (Two with the same depth to the
// last bit are the exception.)
bool is_order_free(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const bool nearest = raster.depth_test && raster.depth_mask &&
                         (raster.depth_func == kGL_LESS || raster.depth_func == kGL_LEQUAL ||
                          raster.depth_func == kGL_GREATER || raster.depth_func == kGL_GEQUAL);
    return draw.mode == kGL_TRIANGLES && nearest && !draw.draws_borders() && !draw.fragment.blend;
}

}  // namespace

bool needs_edge_flags(const Draw& draw) {
    const bool has_edges = draw.mode == kGL_TRIANGLES || draw.mode == kGL_QUADS || draw.mode == kGL_POLYGON;
    return has_edges && draw.draws_borders() && !std::ranges::all_of(draw.vertices, &Vertex::edge_flag);
}

Elements::Elements(const Draw& draw, bool patches) : mode_(draw.mode), count_(static_cast<int>(draw.count())) {
    if (draw.indices.empty()) return;
    // Incomplete triangles are not drawn (2.6.1).
    const std::size_t whole = draw.indices.size() / 3 * 3;
    if (patches && whole >= kFewIndices && is_order_free(draw))
        patched_ = patched(std::span(draw.indices).first(whole), draw.vertices.size());
    const auto fill = [&](const auto& indices) {
        indices_ = filled_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
        bytes_ = indices.size() * sizeof(indices[0]);
    };
    if (patched_.patches.empty())
        fill(draw.indices);
    else
        fill(patched_.indices);
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
