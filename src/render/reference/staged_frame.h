// The frame as a sequence of steps: pieces to draw, one after the other, and clears and accumulations between them.
//
// In: a Frame. Out: every Draw after the vertex stage, assembly, clipping and facing.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "render/reference/geometry/coverage.h"
#include "render/reference/geometry/piece.h"
#include "render/reference/shading.h"

namespace twinlight::reference {

// The number of a piece or clear: pieces count from 0 up, clears from -1 down.
using StepId = std::int32_t;

struct Step {
    std::size_t first_piece = 0, end_piece = 0;  // the pieces of a Draw
    StepId clear = 0;                            // negative if the step is a Clear
    const Accumulate* accumulate = nullptr;      // if the step is one
};

struct StagedFrame {
    std::vector<StagedDraw> draws;
    std::vector<Piece> pieces;
    std::vector<PixelRows> rows;  // of each piece
    std::vector<Clear> clears;    // clear `id` is clears[-1 - id]; the first clears to black and depth 1
    std::vector<Step> steps;
    double border = kSnap;  // Options::border
    const CopyRanges* ranges = nullptr;
    // Of each Draw, whether a vertex's colour is undefined (undefined_colors.h). Empty: of none.
    std::vector<std::vector<char>> undefined{};

    const Clear& clear(StepId id) const { return clears[static_cast<std::size_t>(-1 - id)]; }
    const Piece& piece(StepId id) const { return pieces[static_cast<std::size_t>(id)]; }
    const Draw& draw_of(const Piece& piece) const { return *draws[piece.draw].draw; }
    bool is_undefined(const Piece& piece) const;
};

// The frame must outlive the result, and so must `ranges`: what other renderers may have copied from their pictures, for the allowed
// difference.
StagedFrame run_stages(const Frame& frame, const Options& options, const CopyRanges* ranges = nullptr);

// Makes one Shader per Draw.
std::vector<Shader> make_shaders(const StagedFrame& stages, const Options& options);
// The same, but only for colours, not for Shader::points(). Deletes the vertices of Draws that are lit then: a frame may
// have millions.
std::vector<Shader> make_color_shaders(StagedFrame& stages, const Options& options);

// Calls band(y0, y1) for bands of rows that cover [0, height), on all processors. A band must not depend on anything
// that another band writes; then the result is the same for any number of threads.
void for_each_band(int height, const std::function<void(int y0, int y1)>& band);

}  // namespace twinlight::reference
