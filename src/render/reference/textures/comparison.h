// Comparisons of GL (4.1.4 to 4.1.6): of depths, alpha, stencil values and depth textures (3.8.14).
#pragma once

#include <cstdint>

#include "render/reference/textures/interval.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

// r of 3.5.5: the smallest difference between two depths in the 24-bit depth buffer of Twinlight's contexts.
inline constexpr double kDepthStep = 1.0 / (1 << 24);

// kOpen: correct implementations may differ; only intervals give it. In this order, so that the minimum of several
// outcomes is their combined outcome.
enum class Outcome : std::uint8_t { kFails, kOpen, kPasses };
inline Outcome outcome_of(bool passes) { return passes ? Outcome::kPasses : Outcome::kFails; }

// GL_NEVER to GL_ALWAYS.
bool compares(Enum func, double incoming, double stored);

// 4.1.6. `difference`: the fragment's depth minus the stored one.
Outcome depth_outcome(Enum depth_func, const Interval& difference);

}  // namespace twinlight::reference
