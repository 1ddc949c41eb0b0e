#include "render/reference/staged_frame.h"

#include <algorithm>
#include <span>

#include "base/threads/threads.h"
#include "render/reference/vertices/tex_gen.h"
#include "scene/frame/picture_memory.h"

namespace twinlight::reference {

namespace {

// At least the number of primitives that the Draw is assembled to.
std::size_t most_primitives(const Draw& draw) {
    switch (draw.mode) {
        case kGL_LINES: return draw.count() / 2;
        case kGL_TRIANGLES: return draw.count() / 3;
        case kGL_QUADS: return draw.count() / 2;
        default: return draw.count();
    }
}

// Its pieces, where clipping adds none: a triangle that is drawn as lines or points has three.
std::size_t most_pieces(const Draw& draw) {
    const bool fills = !draw.draws_polygons_as(kGL_LINE) && !draw.draws_polygons_as(kGL_POINT);
    return most_primitives(draw) * (fills ? 1 : 3);
}

// The vertices that the pieces of a Draw name.
std::vector<bool> needed_by(std::span<const Piece> pieces, std::size_t vertices) {
    std::vector<bool> needed(vertices);
    if (vertices == 0) return needed;
    for (const Piece& piece : pieces) {
        for (const std::uint32_t vertex : piece.primitive.vertices) needed[vertex] = true;
        needed[piece.primitive.provoking] = true;
    }
    return needed;
}

// The texture coordinates of a further unit at the kept vertices, as StageVertex has them for unit 0.
std::vector<glm::dvec4> tex_coords_of(const Draw& draw, const FurtherUnit& further, const StagedVertices& vertices) {
    std::vector<glm::dvec4> result;
    result.reserve(vertices.kept().size());
    for (const StageVertex& staged : vertices.kept()) {
        const std::size_t number = vertices.number(result.size());
        result.push_back(further.unit.texture_matrix * generated_tex_coord(further.unit, draw.vertices[number],
                                                                           draw.tex_coord(further.number, number),
                                                                           staged.position_eye, staged.normal_eye));
    }
    return result;
}

}  // namespace

StagedFrame run_stages(const Frame& frame, const Options& options, const CopyRanges* ranges) {
    StagedFrame stages;
    stages.border = options.border;
    stages.ranges = ranges;
    // A vector that grows as it is filled needs up to three times as much memory. Small triangles become few pieces.
    std::size_t pieces = 0;
    for (const Draw* draw : frame.draws()) pieces += most_pieces(*draw);
    constexpr std::size_t kOfPixel = 4;
    stages.pieces.reserve(std::min<std::size_t>(pieces, kOfPixel * pixels_of(frame.width, frame.height)));
    const Draw* last = nullptr;
    const auto add_clear = [&](const Clear& clear) {
        stages.clears.push_back(clear);
        stages.steps.push_back({.clear = -static_cast<StepId>(stages.clears.size())});
    };
    add_clear({.color = true, .depth = true});
    for (const auto& item : frame.items) {
        if (const Clear* clear = std::get_if<Clear>(&item)) {
            add_clear(*clear);
            continue;
        }
        if (const Accumulate* accumulate = std::get_if<Accumulate>(&item)) {
            stages.steps.push_back({.accumulate = accumulate});
            continue;
        }
        if (!std::holds_alternative<Draw>(item)) continue;  // a copy: see copied_pixels.h
        const Draw& draw = std::get<Draw>(item);
        StagedDraw& staged = stages.draws.emplace_back();
        staged.draw = &draw;
        const std::size_t first = stages.pieces.size();
        const auto index = static_cast<std::uint32_t>(stages.draws.size() - 1);
        if (options.shading != Shading::kExact || !draw.has_exact_surfaces())
            add_pieces(draw, index, vertex_positions(draw), options, stages.pieces, ranges);
        else if (!last || !are_one_shape(*last, draw))  // drawing the first part draws the whole shape
            add_surface_pieces(draw, index, stages.pieces);
        last = &draw;
        staged.vertices =
            StagedVertices(draw, needed_by(std::span(stages.pieces).subspan(first), draw.vertices.size()));
        for (const FurtherUnit& further : draw.further_units)
            staged.further_tex_coords.push_back(tex_coords_of(draw, further, staged.vertices));
        stages.steps.push_back({.first_piece = first, .end_piece = stages.pieces.size()});
    }
    stages.rows.reserve(stages.pieces.size());
    for (const Piece& piece : stages.pieces) stages.rows.push_back(rows_of(piece, stages.border));
    return stages;
}

std::vector<Shader> make_shaders(const StagedFrame& stages, const Options& options) {
    std::vector<Shader> shaders;
    shaders.reserve(stages.draws.size());
    for (const StagedDraw& staged : stages.draws) shaders.emplace_back(staged, options, stages.ranges);
    return shaders;
}

std::vector<Shader> make_color_shaders(StagedFrame& stages, const Options& options) {
    std::vector<Shader> shaders;
    shaders.reserve(stages.draws.size());
    for (StagedDraw& staged : stages.draws) {
        shaders.emplace_back(staged, options, stages.ranges);
        if (!shaders.back().needs_vertices()) staged.vertices.clear();
    }
    return shaders;
}

void for_each_band(int height, const std::function<void(int y0, int y1)>& band) {
    constexpr int kRowsPerBand = 16;
    const int bands = (height + kRowsPerBand - 1) / kRowsPerBand;
    for_each_on_threads(bands, [&](int i) { band(i * kRowsPerBand, std::min(height, (i + 1) * kRowsPerBand)); });
}

}  // namespace twinlight::reference
