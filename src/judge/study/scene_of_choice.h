// The scene with finer or coarser meshes, or enlarged.
#pragma once

#include "scene/command/command.h"
#include "scene/frame/frame.h"

namespace twinlight::study {

// The arguments of a shape's command that hold its slices around the axis, and its stacks, loops or sides across it.
struct SliceArguments {
    std::size_t around = 0, across = 0;  // indices into Command::arguments; 0: none
};
SliceArguments slice_arguments(const Command& command);

// The scene with every round shape (of freeglut, GLU and the pragma `shape`) drawn in `slices` slices or rings, and
// half as many stacks, loops or sides, at least three. GLU itself allows at most 239.
CommandList with_slices(const CommandList& scene, int slices);

// Whether the scene has such a shape.
bool has_slices(const CommandList& scene);

// The same picture, `samples` times as wide and as high.
Frame enlarged(const Frame& frame, int samples);

}  // namespace twinlight::study
