// What is seen in each pixel: the per-fragment stage (4.1: pixel ownership, depth test) without colours.
//
// In: a Frame. Out: for every pixel the piece, or the Clear, that was written last. GL here has no blending,
// so the colours can wait until it is known whose they are.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "reference/coverage.h"
#include "reference/piece.h"

namespace twinlight::reference {

// A Draw after its vertex stage.
struct StagedDraw {
    const Draw* draw = nullptr;
    std::vector<StageVertex> vertices;
};

// The frame as the steps of one picture. A step is named by one number: pieces from 0 up, clears from -1 down.
using StepId = std::int32_t;

struct Step {
    std::size_t first_piece = 0, end_piece = 0;  // of a Draw
    StepId clear = 0;                            // negative: a Clear
};

struct Stages {
    std::vector<StagedDraw> draws;
    std::vector<Piece> pieces;
    std::vector<Clear> clears;  // clears[-1 - id]; the first is the black, deep picture that every frame starts from
    std::vector<std::size_t> pieces_before_clear;  // how many pieces were drawn before it
    std::vector<Step> steps;

    const Clear& clear(StepId id) const { return clears[static_cast<std::size_t>(-1 - id)]; }
    const Piece& piece(StepId id) const { return pieces[static_cast<std::size_t>(id)]; }
    const Draw& draw_of(const Piece& piece) const { return *draws[piece.draw].draw; }
};

// Runs vertex stage, assembly, clipping and facing. The frame must outlive the result.
Stages run_stages(const Frame& frame, QuadCut cut);

// The pixels of whole rows of the window, from row y0 (y up).
struct VisibleRows {
    int width = 0, y0 = 0, y1 = 0;
    std::vector<StepId> step;  // of the colour
    std::vector<double> depth;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

VisibleRows visible_rows(const Stages& stages, int width, int y0, int y1);

// Table 4.1 of 4.1.5: whether a fragment of depth `incoming` passes against what is stored.
bool depth_passes(Enum depth_func, double incoming, double stored);

// Calls band(y0, y1) for bands of rows that together are [0, height), on all processors. What a band computes
// must depend on nothing that another band writes; then the result is the same for any number of threads.
void for_each_band(int height, const std::function<void(int y0, int y1)>& band);

}  // namespace twinlight::reference
