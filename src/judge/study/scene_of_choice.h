// The scene as a choice draws it: with finer or coarser meshes, or larger.
#pragma once

#include "scene/command/command.h"
#include "scene/state/frame.h"

namespace twinlight::study {

// Every round shape of the scene (of freeglut, GLU and the pragma `shape`) sent in `slices` slices, or rings, and half as many
// stacks, loops or sides; three at least. GLU itself takes 239 at most.
CommandList with_slices(const CommandList& scene, int slices);

// Whether there is such a shape.
bool has_slices(const CommandList& scene);

// The same picture, `samples` times as wide and as high.
Frame enlarged(const Frame& frame, int samples);

}  // namespace twinlight::study
