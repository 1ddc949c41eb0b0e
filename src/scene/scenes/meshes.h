// Loads the meshes for #pragma twinlight mesh(...).
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "scene/command/text.h"
#include "scene/scenes/beside.h"

namespace twinlight {

// Returns a loader for the OBJ files in the folder of `scene`, with the MTL files and pictures that they name there.
MeshLoader meshes_beside(const std::filesystem::path& scene);

// Returns a loader for the OBJ files that this finds, with the MTL files and pictures that they name.
MeshLoader meshes_in(FileFinder find);
// A mesh of kSceneAssets. Throws std::runtime_error if there is none of this name.
std::shared_ptr<const Mesh> meshes_built_in(const std::string& name);

}  // namespace twinlight
