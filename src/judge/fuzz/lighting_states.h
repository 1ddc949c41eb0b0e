// Random lighting states as commands: everything that the equation of 2.14.1 reads, in all the ways that commands have to
// say it.
#pragma once

#include "judge/fuzz/writer.h"

namespace twinlight::fuzz {

// A scene of one primitive with three vertices, which stand in different corners of the view: random lights, materials,
// light model, colour material, matrices, normals and colours. Values of moderate size, no coordinate at 0, but where
// the scene is about a departure.
CommandList lighting_state(const Seed& seed);

}  // namespace twinlight::fuzz
