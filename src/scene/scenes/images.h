// Loads the pictures for #pragma twinlight texture(...).
#pragma once

#include <cstddef>
#include <filesystem>

#include "scene/command/text.h"

namespace twinlight {

// Limits on a picture. Pictures are untrusted, like scenes.
inline constexpr std::size_t kMaxImageFileBytes = 32u << 20;
inline constexpr int kMaxImageSide = 2048;

// Returns a loader for the PNGs in the folder of `scene`. It refuses names that contain a folder, and links to other
// folders.
ImageLoader images_beside(const std::filesystem::path& scene);

// A picture of kSceneAssets. Throws std::runtime_error if there is none of this name.
ImageFile images_built_in(const std::string& name);

}  // namespace twinlight
