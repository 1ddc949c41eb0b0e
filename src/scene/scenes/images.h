// The pictures that #pragma twinlight texture(...) reads.
#pragma once

#include <cstddef>
#include <filesystem>

#include "scene/command/text.h"

namespace twinlight {

// Limits on a picture, which is untrusted as its scene is.
inline constexpr std::size_t kMaxImageFileBytes = 32u << 20;
inline constexpr int kMaxImageSide = 2048;

// Reads PNGs that lie in the scene's own folder, and no others: a name with a folder in it, and a link that leads out of
// the folder, are refused.
ImageLoader images_beside(const std::filesystem::path& scene);

}  // namespace twinlight
