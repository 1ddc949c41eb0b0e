// Light that is lost between the vertices of a surface: there, a picture that lights every pixel is much brighter.
#pragma once

#include <cstdint>
#include <vector>

#include "judge/lint/watch.h"

namespace twinlight::lint {

struct LostLight {
    enum class Part : std::uint8_t { kCone, kHighlight, kLamp };

    const Draw* draw = nullptr;
    int light = 0;
    Part part = Part::kLamp;
    // What the light adds in the colour channel that loses most: at most to a vertex of the surface, and between the vertices.
    double brightest_vertex = 0, between = 0;
};

// For each surface and light. `least`: how much darker than by itself the picture must show some place.
std::vector<LostLight> lost_lights(const Frame& frame, double least = 0.25);

}  // namespace twinlight::lint
