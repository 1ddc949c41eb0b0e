// From a Draw's lighting state to the structs of the lighting equation.
//
// In: LightingState (GL's words, 2.14.2). Out: what equation.h takes, prepared once a Draw; then the two
// colours of any point of a surface.
#pragma once

#include <vector>

#include "lighting/equation.h"
#include "state/frame.h"

namespace twinlight::reference {

using Vec = Vec3<double>;

struct Colors {
    glm::dvec4 primary{0};
    glm::dvec4 secondary{0, 0, 0, 1};
    glm::dvec4 magnitude{0};  // the sum of the magnitudes of primary's terms
};

enum class Face : std::uint8_t { kFront, kBack };

class DrawLighting {
  public:
    // Without `lecture_variants` the lighting is GL's own.
    DrawLighting(const LightingState& state, bool lecture_variants);

    // The colours, unclamped, of the point of a surface that has this eye position, normal and current
    // colour. The back face is lit with its own material and the normal reversed (2.14.1).
    Colors colors(const glm::dvec4& position_eye, const glm::dvec3& normal_eye, const glm::dvec4& color,
                  Face face) const;

    bool enabled() const { return enabled_; }
    // Whether the back face has colours of its own; GL uses the front's where it has not.
    bool two_side() const { return enabled_ && two_side_; }

  private:
    lighting::Material<double> material(Face face, const glm::dvec4& color) const;

    bool enabled_ = false;
    bool two_side_ = false;
    lighting::Model<double> model_;
    std::vector<lighting::Light<double>> lights_;  // the enabled ones
    Material front_, back_;
    ColorMaterial color_material_;
};

// Every component to [0,1] (2.14.6).
glm::dvec4 clamped(const glm::dvec4& color);

}  // namespace twinlight::reference
