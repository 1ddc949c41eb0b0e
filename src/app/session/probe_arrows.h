// The vectors of the lighting equation at a probed point, as arrows for the pictures and the world.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/image/rectangle.h"

namespace twinlight::explain {
struct Derivation;
}

namespace twinlight::session {

struct ProbeArrow {
    enum class Kind : std::uint8_t { kNormal, kViewer, kLight, kHighlight };
    Kind kind = Kind::kNormal;
    std::string name;  // "n", "V", "L0", "h0", or "r0" for a reflected ray
    glm::dvec3 dir_eye{0};
};
struct ProbeArrows {
    int revision = -1;  // of the session's scene
    glm::dvec3 place_eye{0};
    std::vector<ProbeArrow> arrows{};
    glm::dmat4 clip_from_eye{1};
    Rectangle viewport{};  // of the picture that is `height` pixels high, from its lower left corner
    int height = 0;
    double length = 1;  // of the arrows: about kArrowPixels in the picture

    glm::dvec3 tip_eye(const ProbeArrow& arrow) const { return place_eye + length * arrow.dir_eye; }
    // In pixels of the picture from its top left; empty for a point behind the eye.
    std::optional<glm::dvec2> place_of(const glm::dvec3& point_eye) const;
};
inline constexpr double kArrowPixels = 80;

// `light`: only of this one; empty: of all that are on, without the highlights if there are several.
ProbeArrows arrows_of(const explain::Derivation& at, std::optional<int> light, int revision);

}  // namespace twinlight::session
