// Martin Newell's tea set of 1975 as bicubic Bezier patches, in the form that freeglut 3.4 draws (its
// src/fg_teapot_data.h). The parts are scaled to fit each other, rotated and mirrored copies of patches are omitted,
// the teapot has a bottom, and the end of the spoon is closed.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace twinlight {

// z is up. A patch has 4 rows of 4 control points.
struct BezierPatches {
    std::span<const glm::dvec3> points;
    std::span<const std::array<std::uint8_t, 16>> patches;  // indices into points
};

// 6 patches of a quarter: rim, body, body, lid, lid, bottom; 4 of one half: handle, spout.
extern const BezierPatches kTeapotPatches;
// 6 patches of a quarter, including the saucer; 1 of one half: the handle.
extern const BezierPatches kTeacupPatches;
// All patches.
extern const BezierPatches kTeaspoonPatches;

}  // namespace twinlight
