// The same scene with finer or coarser meshes.
#pragma once

#include "scene/command/command.h"

namespace twinlight::study {

// Every round shape of the scene (of freeglut, GLU and the pragma `shape`) sent in `slices` slices, or rings, and half as many
// stacks, loops or sides; three at least. GLU itself takes 239 at most.
CommandList with_slices(const CommandList& scene, int slices);

// Whether there is such a shape.
bool has_slices(const CommandList& scene);

}  // namespace twinlight::study
