// How shaders draw a Frame.
#pragma once

#include <cstdint>

#include "render/effect/plan.h"

namespace twinlight::programmable {

// Which programs they draw with (programs.h).
enum class Tier : std::uint8_t {
    kUniform,  // a Draw's numbers are uniforms: the same program for all that differ in them alone
    kBaked,    // they are constants of a program of its own
    kAuto,     // of frame after frame: uniforms, and constants for what has stood still for a while
};

struct Options : PlanOptions {
    Tier tier = Tier::kUniform;
    // Lit per vertex in the order of operations of Mesa's fixed function, every sum in floats (precise.h). Nothing of the
    // lighting is left out then, whatever the budget.
    bool precise = false;
    // For an UploadedFrame: large meshes in patches (render/stages/elements.h).
    bool patches = true;
};

}  // namespace twinlight::programmable
