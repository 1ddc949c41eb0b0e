// Which known bugs make the fixed function's picture differ: proved by drawing the scene without them (rewrites.h).
#pragma once

#include <functional>
#include <vector>

#include "base/image/image.h"
#include "judge/compare/departures.h"
#include "scene/frame/scene.h"

namespace twinlight::compare {

// How a rewritten scene is drawn and judged.
struct Trial {
    std::function<Image(const Scene&)> draw_fixed;
    // Whether this picture of the fixed function is right, as far as bugs of its own are concerned.
    std::function<bool(const Image&)> is_right;
    // Whether the reference draws these commands as those of the scene.
    std::function<bool(const Frame&)> is_same;
    const Image& fixed;          // of the scene
    const PixelMask& differing;  // where it is wrong
};

struct Causes {
    // Without these the fixed function is right. Empty if no rewrite makes it so.
    std::vector<const Departure*> proved{};
    // Without these its picture is as wrong as with them.
    std::vector<const Departure*> innocent{};

    bool is_innocent(const Departure& departure) const;
};

// `known`: the known bugs that may show in the scene. Tries the rewrite of each, then all of them together, and leaves out those that are not needed.
Causes find_causes(const Scene& scene, const std::vector<const Departure*>& known, const Trial& trial);

}  // namespace twinlight::compare
