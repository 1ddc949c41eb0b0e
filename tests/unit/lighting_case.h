// One surface and one light, for the tests of the lighting equation.
#pragma once

#include <vector>

#include "lighting/breakdown.h"
#include "lighting/light_setup.h"

namespace twinlight::lighting {

using D = Vec3<double>;

// Some tens of roundings on values near 1.
inline constexpr double kArithmetic = 32 * std::numeric_limits<double>::epsilon();

// A white diffuse surface at the origin that faces +z, and one white directional light along +z: the diffuse
// term is 1, all else 0. A test changes the part that it is about.
struct Case {
    Model<double> model;
    Material<double> material{.diffuse = {1, 1, 1}, .diffuse_alpha = 0.5};
    SurfacePoint<double> surface{{0, 0, 0}, {0, 0, 1}};
    std::vector<Light<double>> lights{Light<double>{.diffuse = {1, 1, 1}}};

    Light<double>& light() { return lights[0]; }
    void place_light(D position, double w = 1) { place(light(), position, w); }
    void aim_spot(D direction, double cutoff_deg) { aim(light(), direction, cutoff_deg); }
    // Only the specular term, white.
    void only_specular(double shininess) {
        material = {.specular = {1, 1, 1}, .shininess = shininess};
        light().specular = {1, 1, 1};
    }
    MeasuredLit<double> lit() const { return measured_light<double>(model, material, surface, lights); }
    LightTerms<double> terms() const {
        std::vector<LightTerms<double>> breakdown(lights.size());
        measured_light<double>(model, material, surface, lights, breakdown.data());
        return breakdown[0];
    }
    double red() const { return lit().primary.x; }
};

}  // namespace twinlight::lighting
