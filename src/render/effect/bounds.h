// How much a light can add to a Draw at most: an upper bound of the equation (2.14.1) over all that the Draw may light.
//
// Positions lie in a sphere; so do those that phong shading interpolates between them. Normals lie in a cone; of those that
// are interpolated and made unit that holds where the cone's half angle is below 90 degrees, for then it is convex. From
// there on it is geometry of cones: the directions from a sphere to a light outside of it lie in a cone of half angle
// asin(radius / distance), and two directions of two cones are at least as far apart as their axes less both half angles.
//
// Every bound holds in exact arithmetic and for the reference in double precision: spheres and cones are wider by more than
// rounding can take from them, products larger. It says nothing of what float arithmetic does to the lights that are in.
#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "render/effect/color_products.h"
#include "render/effect/vertex_facts.h"
#include "scene/state/frame.h"

namespace twinlight {

// All directions within half_angle of the axis. At pi or more: any direction.
struct Cone {
    glm::dvec3 axis_dir{0, 0, 1};
    double half_angle = 0;  // in radians
};

// Where a Draw lies in eye coordinates.
struct DrawBounds {
    bool has_sphere = false;  // if not, positions may be anywhere
    glm::dvec3 center_eye{0};
    double radius_eye = 0;

    Cone normals_eye;
    double longest_normal_eye = 1;
    // How far normals may be from length 1 without GL_NORMALIZE, once they are multiplied by one number for all.
    double unequal_normals = 0;
    double normal_scale = 1;  // that number is 1 / normal_scale
    bool unit_normals = false;

    Cone to_viewer_eye;  // VPe, with a local viewer; else (0, 0, 1)
    bool reflection = false;
    bool has_zero_normal = false;
};

// `lighting` is the state in force (Plan::lighting); `phong`: whether every fragment is lit.
DrawBounds draw_bounds(const Draw& draw, const VertexFacts& vertices, const LightingState& lighting, bool phong);

// The largest att_i over distances of [nearest, farthest] (farthest may be infinite): rigorous for any factors.
double largest_attenuation(const LightSource& light, double nearest, double farthest);

// spot_i of a directional light, the same at every vertex.
double directional_spot(const LightSource& source);

struct Range {
    double low = 0, high = 0;
};
struct ColorRange {
    glm::dvec3 low{0}, high{0};
};

// What a face's materials may be.
struct FaceRange {
    ColorRange emission, ambient, diffuse, specular;
    Range shininess, alpha;
    Material::Reflectances reflectances{};  // of the colours that are not the vertices'
};

// A material's colour times a light's, in the samples of a spectrum.
ColorRange spectral_product_of(const LightModel& model, const LightColor& light, const FaceRange& face,
                               ColorRange FaceRange::*color);
// In those that the scene asks for.
inline ColorRange product_of(const LightModel& model, const LightColor& light, const FaceRange& face,
                             ColorRange FaceRange::*color) {
    if (model.spectrum) return spectral_product_of(model, light, face, color);
    const glm::dvec3 a = (face.*color).low * light.rgb, b = (face.*color).high * light.rgb;
    return {glm::min(a, b), glm::max(a, b)};
}

// The factors of a light's terms, at most. Of the faces, the front's first.
struct LightFactors {
    double reach = 0;  // att_i spot_i
    std::array<double, 2> n_dot_vp{}, highlight{};
    double cone_misses_by = 0;  // in radians; 0 where the light's cone may reach the sphere
    double behind_by = 0;       // in radians; 0 where a normal of a face that shows may face the light
    bool cone_holds_all = false;
};

// Cheaply, by the distance alone, or with the angles.
LightFactors quick_factors(const DrawBounds& bounds, const LightSource& light);
LightFactors light_factors(const DrawBounds& bounds, const LightSource& light, const std::array<FaceRange, 2>& faces,
                           int face_count);

// a b, where 0 times infinity is 0.
inline double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

}  // namespace twinlight
