// The options of the programmable renderer.
#pragma once

#include <cstdint>

#include "render/effect/plan.h"

namespace twinlight::programmable {

// How a program gets its numbers (kept_programs.h).
enum class Tier : std::uint8_t {
    kUniform,  // as uniforms: Draws that differ only in numbers share a program
    kBaked,    // as constants: each Draw has its own program
    kAuto,     // for many frames: uniforms, then constants for numbers that have not changed for a while
};

struct Options : PlanOptions {
    Tier tier = Tier::kUniform;
    // Lights per vertex, with every sum in floats and in the order of Mesa's fixed function (precise.h). Then no part
    // of the lighting is left out, whatever the budget.
    bool precise = false;
    // For an UploadedFrame: draws large meshes in patches (render/stages/elements.h).
    bool patches = true;
};

}  // namespace twinlight::programmable
