// The most that a light can add to a Draw: an upper bound of the lighting equation (2.14.1) over all points of the
// Draw.
//
// Positions lie in a sphere, and so do the positions that phong shading interpolates. Normals lie in a cone.
// Interpolated normals, scaled to length 1, stay in it if its half angle is below 90 degrees, because then the cone is
// convex. The rest is geometry of cones: the directions from a sphere to a light outside it form a cone of half angle
// asin(radius / distance), and the angle between directions of two cones is at least the angle between the axes minus
// both half angles.
//
// Every bound holds in exact arithmetic, and for the reference in double precision: spheres, cones and products are
// enlarged by more than the rounding error. The bounds do not cover the error of float arithmetic in the lights that
// are kept.
#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "render/effect/color_products.h"
#include "render/effect/vertex_facts.h"
#include "scene/frame/frame.h"

namespace twinlight {

// All directions within half_angle of the axis; all directions if it is pi or more.
struct Cone {
    glm::dvec3 axis_dir{0, 0, 1};
    double half_angle = 0;  // in radians
};

// Where a Draw lies in eye coordinates.
struct DrawBounds {
    bool has_sphere = false;  // false: positions may be anywhere
    glm::dvec3 center_eye{0};
    double radius_eye = 0;

    Cone normals_eye;
    double longest_normal_eye = 1;
    // How far the normals' lengths may be from 1 without GL_NORMALIZE, after they are divided by normal_scale.
    double unequal_normals = 0;
    double normal_scale = 1;
    bool unit_normals = false;

    Cone to_viewer_eye;  // the directions VPe; (0, 0, 1) without a local viewer
    bool reflection = false;
    bool has_zero_normal = false;
};

// `lighting` is Plan::lighting; `phong`: whether every fragment is lit.
DrawBounds draw_bounds(const Draw& draw, const VertexFacts& vertices, const LightingState& lighting, bool phong);

// The largest att_i over distances in [nearest, farthest]; farthest may be infinite. Holds for any factors.
double largest_attenuation(const LightSource& light, double nearest, double farthest);

// spot_i of a directional light, the same at every vertex.
double directional_spot(const LightSource& source);

struct Range {
    double low = 0, high = 0;
};
struct ColorRange {
    glm::dvec3 low{0}, high{0};
};

// The ranges of a face's material properties over the vertices.
struct FaceRange {
    ColorRange emission, ambient, diffuse, specular;
    Range shininess, alpha;
    Material::Reflectances reflectances{};  // of the colours that are the same at all vertices
};

// A material's colour times a light's, computed in the samples of a spectrum.
ColorRange spectral_product_of(const LightModel& model, const LightColor& light, const FaceRange& face,
                               ColorRange FaceRange::*color);
// A material's colour times a light's, in spectral samples if the scene has a spectrum, else in RGB.
inline ColorRange product_of(const LightModel& model, const LightColor& light, const FaceRange& face,
                             ColorRange FaceRange::*color) {
    if (model.spectrum) return spectral_product_of(model, light, face, color);
    const glm::dvec3 a = (face.*color).low * light.rgb, b = (face.*color).high * light.rgb;
    return {glm::min(a, b), glm::max(a, b)};
}

// Upper bounds of the factors of a light's terms. Index 0 is the front face, 1 the back.
struct LightFactors {
    double reach = 0;  // att_i spot_i
    std::array<double, 2> n_dot_vp{}, highlight{};
    double cone_misses_by = 0;  // in radians; 0 if the light's cone may reach the sphere
    double behind_by = 0;       // in radians; 0 if a normal of a visible face may face the light
    bool cone_holds_all = false;
};

// quick_factors() uses only the distance. light_factors() also uses the angles, and is slower.
LightFactors quick_factors(const DrawBounds& bounds, const LightSource& light);
LightFactors light_factors(const DrawBounds& bounds, const LightSource& light, const std::array<FaceRange, 2>& faces,
                           int face_count);

// a * b, with 0 times infinity = 0.
inline double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

}  // namespace twinlight
