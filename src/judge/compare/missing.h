// What the commands that only the fixed function draws change in its picture.
//
// The fixed function draws the scene once more without them. Where its two pictures are equal, the missing commands
// cannot be why another picture differs.
#pragma once

#include <memory>
#include <vector>

#include "base/image/image.h"
#include "scene/command/command.h"
#include "scene/frame/frame.h"
#include "scene/frame/scene.h"

namespace twinlight::compare {

// The recording without the commands that `missing` names and that only the fixed function draws; null if there are
// none, or if one cannot be left out by its name, or if the other renderers do more than ignore it.
std::shared_ptr<const Recording> without_missing(std::shared_ptr<const Recording> recording,
                                                 const std::vector<Unsupported>& missing);

// For the fixed function: other commands in the scene's window.
Scene with_commands(const Scene& scene, std::shared_ptr<const Recording> recording);

// The pixels in which the two pictures differ, in whole codes. Both have one size.
PixelMask changed_pixels(const Image& with, const Image& without);

}  // namespace twinlight::compare
