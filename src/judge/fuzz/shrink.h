// Reduces a failing scene to a small one that still fails: delta debugging over commands (Zeller and Hildebrandt,
// "Simplifying and isolating failure-inducing input", 2002), then simpler values.
#pragma once

#include <functional>

#include "scene/command/command.h"

namespace twinlight::fuzz {

// Whether a scene still fails in the same way.
using StillFails = std::function<bool(const CommandList&)>;

// `scene` must fail. Calls `still_fails` at most `questions` times.
CommandList shrink(CommandList scene, const StillFails& still_fails, int questions = 3000);

}  // namespace twinlight::fuzz
