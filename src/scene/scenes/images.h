// Loads the pictures for #pragma twinlight texture(...).
#pragma once

#include <cstddef>
#include <filesystem>

#include "scene/command/text.h"
#include "scene/scenes/beside.h"

namespace twinlight {

// Limits on a picture. Pictures are untrusted, like scenes.
inline constexpr std::size_t kMaxImageFileBytes = 32u << 20;
inline constexpr int kMaxImageSide = 2048;

// Returns a loader for the PNGs in the folder of `scene`. It refuses names that contain a folder, and links to other
// folders. A picture of the built-in scenes need not be in the folder, so that a changed copy of such a scene can be drawn.
ImageLoader images_beside(const std::filesystem::path& scene);

// Returns a loader for the PNGs that this finds.
ImageLoader images_in(FileFinder find);
// A picture of kSceneAssets, for scenes without a folder. Throws std::runtime_error if there is none of this name.
ImageFile images_built_in(const std::string& name);

}  // namespace twinlight
