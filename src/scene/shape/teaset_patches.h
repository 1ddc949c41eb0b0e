// Martin Newell's tea set of 1975 as bicubic Bezier patches, in the form that freeglut 3.4 draws (its src/fg_teapot_data.h):
// scaled to one another, each patch that is a turned or mirrored copy of another left out, a bottom added to the teapot, and the
// end of the spoon closed.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace twinlight {

// Heights are z. A patch is 4 rows of 4 control points.
struct BezierPatches {
    std::span<const glm::dvec3> points;
    std::span<const std::array<std::uint8_t, 16>> patches;  // indices into points
};

extern const BezierPatches
    kTeapotPatches;  // 6 of a quarter turn: rim, body, body, lid, lid, bottom; 4 of one half: handle, spout
extern const BezierPatches kTeacupPatches;    // 6 of a quarter turn, the saucer among them; 1 of one half: the handle
extern const BezierPatches kTeaspoonPatches;  // whole

}  // namespace twinlight
