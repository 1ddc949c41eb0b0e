#include "render/effect/bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "base/math/directions.h"
#include "render/lighting_of.h"

namespace twinlight {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Every angle is reduced by this, in radians. It is more than double's rounding error, and enough that float arithmetic
// sees the same side of a cone's border.
constexpr double kAngleMargin = 1e-6;
// Every bound is multiplied by this: powers magnify rounding errors by up to 128.
constexpr double kUp = 1 + 1e-9;
constexpr double kLargestExponent = 128;  // GL's limit (2.14.2); the bounds here hold up to it

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The smallest angle between a direction of one cone and one of the other.
double gap(const Cone& a, const Cone& b) {
    return std::max(angle_between(a.axis_dir, b.axis_dir) - a.half_angle - b.half_angle - kAngleMargin, 0.0);
}

double cos_of_gap(double angle) { return angle >= kPi / 2 ? 0 : std::cos(angle); }

// The largest x^s for x in [0, base], s in the range (0^0 = 1).
double largest_power(double base, const Range& exponent) {
    if (exponent.low < 0 || exponent.high > kLargestExponent) return kInfinity;
    return std::pow(base, base < 1 ? exponent.low : exponent.high) * kUp;
}

// ---- The Draw ----

// Bounds on the factors by which a matrix stretches vectors: at most `largest`, at least `smallest`.
struct Stretch {
    double largest = kInfinity, smallest = 0;
    // Far from singular (base/math/normal_matrix.h).
    bool known() const { return smallest > 0 && largest / smallest < 1e5; }
    double ratio() const { return largest / smallest; }
};

// The square roots of the eigenvalues of A^T A, bounded by Gershgorin's discs. The smallest is also bounded by the
// determinant: the product of the other two is at most the square of half the trace.
Stretch stretch_of(const glm::dmat3& a) {
    double scale = 0;
    for (int column = 0; column < 3; ++column) scale = std::max(scale, largest_component(a[column]));
    if (!(scale > 1 / kLargestLength && scale < kLargestLength)) return {};
    const glm::dmat3 m = a / scale;
    const glm::dmat3 square = glm::transpose(m) * m;
    double largest = 0, smallest = kInfinity, trace = 0;
    for (int i = 0; i < 3; ++i) {
        double others = 0;
        for (int j = 0; j < 3; ++j) others += i == j ? 0 : std::abs(square[i][j]);
        largest = std::max(largest, square[i][i] + others);
        smallest = std::min(smallest, square[i][i] - others);
        trace += square[i][i];
    }
    const double determinant = glm::determinant(m);
    smallest = std::max(smallest, 4 * determinant * determinant / (trace * trace) - kBoundsRounding);
    if (!(smallest > kBoundsRounding)) return {.largest = scale * std::sqrt(largest) * (1 + kBoundsRounding)};
    return {.largest = scale * std::sqrt(largest) * (1 + kBoundsRounding),
            .smallest = scale * std::sqrt(smallest) * (1 - kBoundsRounding)};
}

void find_sphere(const Draw& draw, const VertexFacts& vertices, const Stretch& stretch, DrawBounds& bounds) {
    const glm::dmat4& m = draw.eye_from_object;
    if (!keeps_w(m) || !vertices.has_sphere || stretch.largest == kInfinity) return;
    const glm::dvec3 turned = glm::dmat3(m) * vertices.center_object, moved(m[3]);
    bounds.center_eye = turned + moved;
    bounds.radius_eye =
        stretch.largest * vertices.radius_object +
        kBoundsRounding *
            (stretch.largest * (vertices.radius_object + glm::length(vertices.center_object)) + glm::length(moved));
    bounds.has_sphere = largest_component(bounds.center_eye) < kLargestLength && bounds.radius_eye < kLargestLength;
}

// 2.11.3: normals are transformed by the transposed inverse. A matrix with stretch ratio k takes two directions at an
// angle a to two directions at most b apart, tan(b/2) = k tan(a/2) (Wielandt's inequality). The worst case is symmetric
// about the axis that shrinks.
void find_normals(const Draw& draw, const VertexFacts& vertices, const LightingState& lighting, const Stretch& stretch,
                  bool phong, DrawBounds& bounds) {
    bounds.unit_normals = phong || lighting.normalize;
    bounds.has_zero_normal = vertices.has_zero_normal;
    bounds.longest_normal_eye = 1 + kBoundsRounding;
    bounds.normals_eye = {.axis_dir = vertices.normal_axis_dir_object, .half_angle = kPi};
    bounds.unequal_normals = kInfinity;
    if (vertices.longest_normal == 0) {
        bounds.normals_eye.half_angle = 0;
        return;
    }
    if (!stretch.known()) {
        if (!bounds.unit_normals) bounds.longest_normal_eye = kInfinity;
        return;
    }
    // GL_RESCALE_NORMAL divides by the length of the inverse's third row, which is between 1 / largest and 1 /
    // smallest.
    if (!bounds.unit_normals)
        bounds.longest_normal_eye = vertices.longest_normal * (1 + kBoundsRounding) *
                                    (lighting.rescale_normal ? stretch.ratio() : 1 / stretch.smallest);
    bounds.normal_scale = vertices.longest_normal / stretch.largest;
    if (vertices.shortest_normal > 0)
        bounds.unequal_normals = stretch.ratio() * vertices.longest_normal / vertices.shortest_normal - 1;
    const double half = vertices.normal_half_angle;
    if (half >= kPi) return;
    const glm::dmat3 upper = glm::dmat3(draw.eye_from_object) / stretch.largest;
    bounds.normals_eye.axis_dir = unit(glm::transpose(glm::inverse(upper)) * vertices.normal_axis_dir_object);
    const double turned = 2 * std::atan(stretch.ratio() * std::tan(half / 2)) + kAngleMargin;
    // Phong interpolates normals, and a cone beyond 90 degrees is not convex.
    bounds.normals_eye.half_angle = phong && turned >= kPi / 2 ? kPi : turned;
}

// The directions from the points of a sphere to a point; any direction if the point is inside.
Cone directions_to(const glm::dvec3& point, const glm::dvec3& center, double radius) {
    const glm::dvec3 way = point - center;
    const double distance = glm::length(way);
    if (!(distance * (1 - kBoundsRounding) > radius)) return {.half_angle = kPi};
    return {.axis_dir = way / distance, .half_angle = std::asin(std::min(radius / distance, 1.0))};
}

// ---- The light ----

// The light's position and its distances from the points of the Draw.
struct LightPlace {
    bool known = false;
    glm::dvec3 position_eye{0};
    double padded_radius = 0, nearest = 0, farthest = kInfinity;
};

LightPlace place_of(const DrawBounds& bounds, const LightSource& light) {
    LightPlace place;
    place.position_eye = glm::dvec3(light.position_eye) / light.position_eye.w;
    if (!bounds.has_sphere || !(largest_component(place.position_eye) < kLargestLength)) return place;
    const double distance = glm::length(place.position_eye - bounds.center_eye);
    place.padded_radius =
        bounds.radius_eye + kBoundsRounding * (glm::length(place.position_eye) + glm::length(bounds.center_eye));
    place.nearest = std::max(distance * (1 - kBoundsRounding) - place.padded_radius, 0.0);
    place.farthest = distance * (1 + kBoundsRounding) + place.padded_radius;
    place.known = true;
    return place;
}

// The largest spot_i where the cosine of the angle between PV and the cone's axis is at most `cosine`.
double largest_spot(const LightSource& light, double cosine) {
    if (light.smooth_cone) {
        const double outer = std::cos(light.smooth_cone->outer_deg * kPi / 180);
        const double span = std::cos(light.smooth_cone->inner_deg * kPi / 180) - outer;
        return span > kBoundsRounding ? std::clamp((cosine - outer) / span * kUp + kBoundsRounding / span, 0.0, 1.0)
                                      : 1;
    }
    return largest_power(std::max(cosine, 0.0), {light.spot_exponent, light.spot_exponent});
}

void find_spot(const LightSource& light, const Cone& to_light, LightFactors& factors) {
    if (light.cone() == SpotCone::kNone) return;
    const double cutoff = (light.smooth_cone ? light.smooth_cone->outer_deg : light.spot_cutoff_deg) * kPi / 180;
    const glm::dvec3 axis_dir = unit(light.spot_direction_eye);
    double nearest = 0, farthest = kPi;
    if (axis_dir == glm::dvec3(0)) {
        nearest = kPi / 2 - kAngleMargin;  // PV . 0 is 0
    } else if (to_light.half_angle < kPi / 2) {
        const double middle = angle_between(-to_light.axis_dir, axis_dir);
        nearest = std::max(middle - to_light.half_angle - kAngleMargin, 0.0);
        farthest = middle + to_light.half_angle + kAngleMargin;
    }
    // A smooth cone whose inner angle is wider than its outer one is a step at the outer angle.
    factors.cone_misses_by = std::max(nearest - cutoff, 0.0);
    factors.cone_holds_all = !light.smooth_cone && farthest <= cutoff;
    factors.reach =
        factors.cone_misses_by > 0
            ? 0
            : product(factors.reach, largest_spot(light, std::min(std::cos(nearest) + kBoundsRounding, 1.0)));
}

// The largest cosine between n and h, or between r and VPe. h lies between the directions to the light and to the
// viewer. While these are at most g apart, h turns by at most 1 / (2 cos(g/2)) times the sum of their turns.
double largest_highlight_cosine(const DrawBounds& bounds, const Cone& normals, const Cone& to_light) {
    const Cone& to_viewer = bounds.to_viewer_eye;
    const double spread = to_light.half_angle + to_viewer.half_angle;
    const double length = bounds.longest_normal_eye;
    if (bounds.reflection) {
        // |2 (n . VP) n - VP|^2 = 1 + 4 (n . VP)^2 (|n|^2 - 1), for normals of any length.
        const double square = length * length;
        if (!bounds.unit_normals) return std::sqrt(1 + 4 * square * std::max(square - 1, 0.0)) * kUp;
        if (bounds.has_zero_normal) return 1;  // r is -VP there
        const glm::dvec3 n = normals.axis_dir, vp = to_light.axis_dir;
        const double angle = angle_between(2 * glm::dot(n, vp) * n - vp, to_viewer.axis_dir);
        return cos_of_gap(std::max(angle - 2 * normals.half_angle - spread - kAngleMargin, 0.0)) + kBoundsRounding;
    }
    const double apart = angle_between(to_light.axis_dir, to_viewer.axis_dir) + spread;
    if (to_light.half_angle >= kPi / 2 || to_viewer.half_angle >= kPi / 2 || apart > kPi - 1e-3) return length;
    const Cone half{.axis_dir = unit(to_light.axis_dir + to_viewer.axis_dir),
                    .half_angle = spread / (2 * std::cos(apart / 2))};
    return length * (cos_of_gap(gap(normals, half)) + kBoundsRounding);
}

void find_angles(const DrawBounds& bounds, const Cone& to_light, const std::array<FaceRange, 2>& faces, int face_count,
                 LightFactors& factors) {
    double behind = kPi;
    for (int face = 0; face < face_count; ++face) {
        const auto i = static_cast<std::size_t>(face);
        Cone normals = bounds.normals_eye;
        if (face == 1) normals.axis_dir = -normals.axis_dir;
        const double angle = gap(normals, to_light);
        factors.n_dot_vp[i] = product(bounds.longest_normal_eye, cos_of_gap(angle)) * kUp;
        behind = std::min(behind, std::max(angle - kPi / 2, 0.0));
        const bool faces_away = angle > kPi / 2 && !bounds.reflection;  // f_i
        factors.highlight[i] =
            faces_away ? 0 : largest_power(largest_highlight_cosine(bounds, normals, to_light), faces[i].shininess);
    }
    factors.behind_by = behind;
}

}  // namespace

DrawBounds draw_bounds(const Draw& draw, const VertexFacts& vertices, const LightingState& lighting, bool phong) {
    DrawBounds bounds;
    const Stretch stretch = stretch_of(glm::dmat3(draw.eye_from_object));
    find_sphere(draw, vertices, stretch, bounds);
    find_normals(draw, vertices, lighting, stretch, phong, bounds);
    bounds.reflection = lighting.light_model.specular == Word::reflection;
    if (lighting.light_model.local_viewer)
        bounds.to_viewer_eye = bounds.has_sphere ? directions_to(glm::dvec3(0), bounds.center_eye, bounds.radius_eye)
                                                 : Cone{.half_angle = kPi};
    return bounds;
}

ColorRange spectral_product_of(const LightModel& model, const LightColor& light, const FaceRange& face,
                               ColorRange FaceRange::*color) {
    const auto& [low, high] = face.*color;
    if (low == high) {
        const Spectrum* reflectance = color == &FaceRange::ambient   ? face.reflectances.ambient
                                      : color == &FaceRange::diffuse ? face.reflectances.diffuse
                                                                     : face.reflectances.specular;
        const glm::dvec3 product = product_of(model, light, {low, reflectance});
        return {product, product};
    }
    const glm::dmat3 matrix = product_matrix(model, light);
    ColorRange range;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = low[i] * matrix[i], b = high[i] * matrix[i];
        range = {range.low + glm::min(a, b), range.high + glm::max(a, b)};
    }
    return range;
}

double largest_attenuation(const LightSource& light, double nearest, double farthest) {
    const double k0 = light.constant_attenuation, k1 = light.linear_attenuation, k2 = light.quadratic_attenuation;
    if (k0 <= 0 && k1 <= 0 && k2 <= 0) return 0;  // RULING: where the denominator is not positive, 0
    const auto denominator = [&](double d) { return k0 + product(d, k1 + product(k2, d)); };
    if (k0 >= 0 && k1 >= 0 && k2 >= 0) {
        const double smallest = denominator(nearest) * (1 - kBoundsRounding);
        return smallest > 0 ? 1 / smallest : kInfinity;
    }
    // GL refuses negative factors. If the denominator may come close to 0, there is no bound.
    if (!std::isfinite(farthest)) return kInfinity;
    double smallest = std::min(denominator(nearest), denominator(farthest));
    const double turn = k2 == 0 ? -1 : -k1 / (2 * k2);
    if (turn > nearest && turn < farthest) smallest = std::min(smallest, denominator(turn));
    smallest -= kBoundsRounding * (std::abs(k0) + farthest * (std::abs(k1) + std::abs(k2) * farthest));
    return smallest > 0 ? 1 / smallest * kUp : kInfinity;
}

double directional_spot(const LightSource& source) {
    if (source.cone() == SpotCone::kNone) return 1;
    const lighting::Light<double> light = lighting_of(source, true);
    return lighting::spot(light, light.position_eye);
}

LightFactors quick_factors(const DrawBounds& bounds, const LightSource& light) {
    LightFactors factors;
    const double length = bounds.longest_normal_eye;
    factors.n_dot_vp = {length, length};
    factors.highlight.fill(bounds.unit_normals && !bounds.reflection ? kUp : kInfinity);
    if (light.is_directional()) {
        factors.reach = directional_spot(light) * kUp;
    } else {
        const LightPlace place = place_of(bounds, light);
        const bool odd_exponent = light.spot_exponent < 0 || light.spot_exponent > kLargestExponent;
        factors.reach = odd_exponent ? kInfinity : largest_attenuation(light, place.nearest, place.farthest) * kUp;
    }
    return factors;
}

LightFactors light_factors(const DrawBounds& bounds, const LightSource& light, const std::array<FaceRange, 2>& faces,
                           int face_count) {
    LightFactors factors;
    Cone to_light{.half_angle = kPi};
    if (light.is_directional()) {
        factors.reach = directional_spot(light) * kUp;
        to_light = {.axis_dir = unit(glm::dvec3(light.position_eye)), .half_angle = 0};
        if (to_light.axis_dir == glm::dvec3(0)) to_light.half_angle = kPi;
    } else {
        const LightPlace place = place_of(bounds, light);
        factors.reach = largest_attenuation(light, place.nearest, place.farthest) * kUp;
        if (place.known) to_light = directions_to(place.position_eye, bounds.center_eye, place.padded_radius);
        find_spot(light, to_light, factors);
        if (factors.cone_misses_by > 0) return factors;  // and every term is 0
    }
    if (factors.reach == 0) return factors;
    find_angles(bounds, to_light, faces, face_count, factors);
    return factors;
}

}  // namespace twinlight
