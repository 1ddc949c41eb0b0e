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

bool cuts_quadrilaterals(const Draw& draw) { return draw.in_list && draw.mode == kGL_QUADS && !draw.draws_borders(); }

namespace {

// Appends the triangles of quadrilaterals whose corners are at(0), at(1), ... The last corner stays the provoking vertex.
template <class At>
void cut(std::size_t corners, const At& at, std::vector<std::uint32_t>& indices) {
    for (std::size_t i = 0; i + 3 < corners; i += 4)
        for (const std::size_t corner : {0, 1, 3, 1, 2, 3}) indices.push_back(at(i + corner));
}

// The vertices of all parts in their order, with quadrilaterals cut where the part asks for that; changes those parts.
std::vector<std::uint32_t> cut_indices(const Draw& draw, std::vector<ElementsPart>& parts) {
    std::vector<std::uint32_t> indices;
    std::size_t first = 0;
    for (ElementsPart& part : parts) {
        const std::size_t count = draw.indices.empty() ? part.vertices : part.indices, start = indices.size();
        const auto at = [&](std::size_t i) { return draw.index(first + i); };
        if (part.cuts_quads) {
            cut(count, at, indices);
            part.mode = kGL_TRIANGLES;
        } else {
            for (std::size_t i = 0; i < count; ++i) indices.push_back(at(i));
        }
        part.indices = indices.size() - start;
        first += count;
    }
    return indices;
}

}  // namespace

std::vector<std::uint32_t> cut_indices(const Draw& draw) {
    std::vector<std::uint32_t> indices;
    cut(
        draw.count(), [&](std::size_t i) { return draw.index(i); }, indices);
    return indices;
}

bool needs_edge_flags(const Draw& draw) {
    const bool has_edges = draw.mode == kGL_TRIANGLES || draw.mode == kGL_QUADS || draw.mode == kGL_POLYGON;
    return has_edges && draw.draws_borders() && !std::ranges::all_of(draw.vertices, &Vertex::edge_flag);
}

Elements::Elements(const Draw& draw, bool patches) : mode_(draw.mode), count_(static_cast<int>(draw.count())) {
    if (cuts_quadrilaterals(draw)) {
        const std::vector<std::uint32_t> indices = cut_indices(draw);
        mode_ = kGL_TRIANGLES;
        count_ = static_cast<int>(indices.size());
        indices_ = filled_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
        bytes_ = indices.size() * sizeof(std::uint32_t);
        return;
    }
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

Elements::Elements(const Draw& draw, const std::vector<ElementsPart>& given)
    : mode_(draw.mode), count_(static_cast<int>(draw.count())) {
    std::vector<ElementsPart> parts = given;
    const bool cuts = std::ranges::any_of(parts, &ElementsPart::cuts_quads);
    const SharedVector<std::uint32_t> indices = cuts ? SharedVector(cut_indices(draw, parts)) : draw.indices;
    const bool has_indices = cuts || !indices.empty();
    // The vertices of a primitive, in modes whose primitives do not share any; 0 in others.
    const auto vertices_of_primitive = [](Enum mode) -> std::size_t {
        switch (mode) {
            case kGL_POINTS: return 1;
            case kGL_LINES: return 2;
            case kGL_TRIANGLES: return 3;
            case kGL_QUADS: return 4;
            default: return 0;
        }
    };
    std::size_t first = 0;
    bool may_continue = false;  // whether the next part's primitives may follow in the same array
    for (const ElementsPart& part : parts) {
        const std::size_t count = has_indices ? part.indices : part.vertices;
        const bool is_new_range = ranges_.empty() || part.begins_range;
        if (is_new_range) ranges_.push_back(runs_.size());
        const bool is_new_run = is_new_range || runs_.back().mode != part.mode;
        if (is_new_run) runs_.push_back({part.mode, {}, {}, {}});
        Run& run = runs_.back();
        if (!is_new_run && may_continue) {
            run.counts.back() += static_cast<int>(count);
        } else {
            run.firsts.push_back(static_cast<int>(first));
            run.counts.push_back(static_cast<int>(count));
            if (has_indices) run.offsets.push_back(buffer_offset(first * sizeof(std::uint32_t)));
        }
        const std::size_t size = vertices_of_primitive(part.mode);
        may_continue = size > 0 && count % size == 0;  // incomplete primitives are not drawn (2.6.1)
        first += count;
    }
    if (!has_indices) return;
    indices_ = filled_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    bytes_ = indices.size() * sizeof(indices[0]);
}

Elements::~Elements() { glDeleteBuffers(1, &indices_); }

void Elements::draw_runs(std::size_t range) const {
    if (indices_ != 0) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    const std::size_t end = range + 1 < ranges_.size() ? ranges_[range + 1] : runs_.size();
    for (std::size_t i = ranges_[range]; i < end; ++i) {
        const Run& run = runs_[i];
        const auto count = static_cast<GLsizei>(run.counts.size());
        if (indices_ != 0)
            glMultiDrawElements(run.mode, run.counts.data(), GL_UNSIGNED_INT, run.offsets.data(), count);
        else if (count == 1)
            glDrawArrays(run.mode, run.firsts.front(), run.counts.front());
        else
            glMultiDrawArrays(run.mode, run.firsts.data(), run.counts.data(), count);
    }
}

void Elements::draw(std::size_t range) const {
    if (!runs_.empty()) return draw_runs(range);
    if (indices_ == 0) return glDrawArrays(mode_, 0, count_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    if (patched_.patches.empty()) return glDrawElements(mode_, count_, GL_UNSIGNED_INT, nullptr);
    for (const PatchedTriangles::Patch& patch : patched_.patches)
        glDrawRangeElementsBaseVertex(mode_, 0, patch.vertex_count - 1, static_cast<GLsizei>(patch.index_count),
                                      GL_UNSIGNED_SHORT, buffer_offset(patch.first_index * sizeof(std::uint16_t)),
                                      static_cast<GLint>(patch.first_vertex));
}

}  // namespace twinlight
