// The frame as the steps of one picture: what is drawn, one piece after the other, and what is cleared between.
//
// In: a Frame. Out: every Draw after vertex stage, assembly, clipping and facing.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "render/reference/piece.h"
#include "render/reference/shading.h"

namespace twinlight::reference {

// A step is named by one number: pieces from 0 up, clears from -1 down.
using StepId = std::int32_t;

struct Step {
    std::size_t first_piece = 0, end_piece = 0;  // of a Draw
    StepId clear = 0;                            // negative: a Clear
};

struct StagedFrame {
    std::vector<StagedDraw> draws;
    std::vector<Piece> pieces;
    std::vector<Clear> clears;  // clears[-1 - id]; the first is the black, deep picture that every frame starts from
    std::vector<Step> steps;

    const Clear& clear(StepId id) const { return clears[static_cast<std::size_t>(-1 - id)]; }
    const Piece& piece(StepId id) const { return pieces[static_cast<std::size_t>(id)]; }
    const Draw& draw_of(const Piece& piece) const { return *draws[piece.draw].draw; }
};

// The frame must outlive the result.
StagedFrame run_stages(const Frame& frame, const Options& options);

// One for each Draw.
std::vector<Shader> make_shaders(const StagedFrame& stages, const Options& options);

// Calls band(y0, y1) for bands of rows that together are [0, height), on all processors. What a band computes
// must depend on nothing that another band writes; then the result is the same for any number of threads.
void for_each_band(int height, const std::function<void(int y0, int y1)>& band);

}  // namespace twinlight::reference
