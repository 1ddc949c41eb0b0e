// Random scenes of what happens between vertices and pixels: primitives, textures, environments, fog, blending, tests,
// masks, clip planes, offsets, widths, in all the ways that commands have to say it.
#pragma once

#include "judge/fuzz/writer.h"

namespace twinlight::fuzz {

// A few batches in a perspective view. Every number is of moderate size.
CommandList fragment_state(const Seed& seed);

}  // namespace twinlight::fuzz
