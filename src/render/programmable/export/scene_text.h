// The text of scene.c: frames as calls. Meshes and display lists have names, state is set where it changes, and frames that differ only in
// numbers and meshes are one function.
#pragma once

#include <string>

#include "render/programmable/export/scene_steps.h"

namespace twinlight::programmable {

struct SceneParts {
    std::string layouts, meshes, lists, frames;  // definitions
    std::string load;                            // statements, before the first frame
    std::string table;                           // the rows of scene_frames
};

// The numbers in which frames differ go to `data`.
SceneParts scene_parts(const SceneSteps& steps, ExportWords& data);

}  // namespace twinlight::programmable
