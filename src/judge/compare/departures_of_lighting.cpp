// Departures in the lighting of a Draw's vertices, and cases where rounding decides.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "base/math/normal_matrix.h"
#include "judge/compare/departure_rules.h"

namespace twinlight::compare {

namespace {

glm::dvec3 eye_position(const Draw& draw, const Vertex& vertex) {
    const glm::dvec4 eye = draw.eye_from_object * vertex.position_object;
    return glm::dvec3(eye) / (eye.w == 0 ? 1 : eye.w);
}

glm::dvec3 eye_normal(const Draw& draw, const Vertex& vertex) {
    const glm::dmat3 m = glm::transpose(glm::inverse(glm::dmat3(draw.eye_from_object)));
    return glm::normalize(m * vertex.normal_object);
}

glm::dvec3 toward(const LightSource& light, const glm::dvec3& position_eye) {
    const glm::dvec3 p(light.position_eye);
    return glm::normalize(light.is_directional() ? p : p / light.position_eye.w - position_eye);
}

// Whether `predicate` is true for any vertex's materials, (front, back).
bool any_material(const Draw& draw, const std::function<bool(const Material&, const Material&)>& predicate) {
    if (predicate(draw.lighting.front, draw.lighting.back)) return true;
    return std::ranges::any_of(draw.materials, [&](const Materials& m) { return predicate(m.front, m.back); });
}

// The square of such a length is 0, subnormal or infinite in a float.
bool leaves_floats(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length < 1e-18 || length > 1e18;
}

// Float rounding changes the cosine of unit vectors by about 1e-6. Closer to a jump than this, rounding may decide.
constexpr double kJump = 1e-5;

double cosine_to_axis(const LightSource& light, const Draw& draw, const Vertex& vertex) {
    return glm::dot(-toward(light, eye_position(draw, vertex)), glm::normalize(light.spot_direction_eye));
}

bool is_at_edge_of_cone(const Draw& draw, const Vertex& vertex) {
    return any_light(draw, [&](const LightSource& light) {
        return light.has_cutoff() &&
               std::abs(cosine_to_axis(light, draw, vertex) - std::cos(light.spot_cutoff_deg * M_PI / 180)) < kJump;
    });
}

// There max(PV . s, 0) is cos 90.
bool is_behind_cone_of_90(const Draw& draw, const Vertex& vertex) {
    return any_light(draw, [&](const LightSource& light) {
        return light.spot_cutoff_deg == 90 && light.spot_exponent == 0 &&
               !(cosine_to_axis(light, draw, vertex) > kJump);
    });
}

}  // namespace

namespace {

// Whether any highlight of a lit Draw has such an exponent.
bool any_highlight(const Draw& draw, bool (*predicate)(double shininess)) {
    const auto shows = [&](const Material& material) {
        return glm::dvec3(material.specular) != glm::dvec3(0) && predicate(material.shininess);
    };
    const bool two_side = draw.lighting.light_model.two_side;
    return draw.lighting.enabled && any_material(draw, [&](const Material& front, const Material& back) {
               return shows(front) || (two_side && shows(back));
           });
}

}  // namespace

bool has_shininess(const Draw& draw) {
    return any_highlight(draw, [](double shininess) { return shininess > 0; });
}

bool has_shininess_0(const Draw& draw) {
    return any_highlight(draw, [](double shininess) { return shininess == 0; });
}

bool has_shininess_0_with_factors(const Draw& draw) {
    const bool two_side = draw.lighting.light_model.two_side;
    const bool has_0 = any_material(draw, [&](const Material& front, const Material& back) {
        return front.shininess == 0 || (two_side && back.shininess == 0);
    });
    return has_0 &&
           any_light(draw, [](const LightSource& light) { return light.is_attenuated() || light.has_cutoff(); });
}

bool has_shininess_0_on_one_side(const Draw& draw) {
    return draw.lighting.enabled && draw.lighting.light_model.two_side &&
           any_material(draw, [](const Material& front, const Material& back) {
               return (front.shininess == 0) != (back.shininess == 0);
           });
}

bool has_color_material_on_back_alone(const Draw& draw) {
    const ColorMaterial& color_material = draw.lighting.color_material;
    return draw.lighting.light_model.two_side && color_material.enabled && color_material.face == kGL_BACK &&
           color_material.mode != kGL_EMISSION;
}

bool has_w_under_positional_light(const Draw& draw, const Vertex& vertex) {
    const double w = (draw.eye_from_object * vertex.position_object).w;
    return std::abs(w - 1) > 1e-9 &&
           (draw.lighting.light_model.local_viewer ||
            any_light(draw, [](const LightSource& light) { return !light.is_directional(); }));
}

bool has_w_0_under_directional_light(const Draw& draw, const Vertex& vertex) {
    return (draw.eye_from_object * vertex.position_object).w == 0 &&
           any_light(draw, [](const LightSource& light) { return light.is_directional(); });
}

bool has_w_0_under_positional_light(const Draw& draw, const Vertex& vertex) {
    return (draw.eye_from_object * vertex.position_object).w == 0 &&
           any_light(draw, [](const LightSource& light) { return !light.is_directional(); });
}

bool has_extreme_direction(const Draw& draw, const Vertex& vertex) {
    const auto is_extreme = [&](const LightSource& light) {
        const glm::dvec3 p(light.position_eye);
        const double w = light.position_eye.w;
        if (w == 0) return leaves_floats(p);
        const glm::dvec3 way = p / w - eye_position(draw, vertex);
        return way != glm::dvec3(0) && leaves_floats(way);
    };
    return draw.lighting.enabled && (leaves_floats(vertex.normal_object) || any_light(draw, is_extreme));
}

// (n . h)^s for the longest possible n . h, the normal's length, is infinite in floats.
bool has_overflowing_highlight(const Draw& draw, const Vertex& vertex) {
    if (!draw.lighting.enabled || draw.lighting.normalize) return false;
    const glm::dmat3 normal_eye_from_object = normal_matrix(glm::dmat3(draw.eye_from_object));
    double length = glm::length(normal_eye_from_object * vertex.normal_object);
    if (draw.lighting.rescale_normal) length /= glm::length(normal_eye_from_object[2]);
    constexpr double kLargestLogarithm = 85;  // somewhat less than a float's, for rounding
    return length > 1 && any_material(draw, [&](const Material& front, const Material& back) {
               const bool two_side = draw.lighting.light_model.two_side;
               const double shininess = two_side ? std::max(front.shininess, back.shininess) : front.shininess;
               return shininess * std::log(length) > kLargestLogarithm;
           });
}

bool rescales_much(const Draw& draw) {
    if (!draw.lighting.enabled || !draw.lighting.rescale_normal || draw.lighting.normalize) return false;
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(draw.eye_from_object))));
    return scale > 1e5 || scale < 1e-5;
}

bool has_normals_in_projection(const Draw& draw) {
    const glm::dmat4& matrix = draw.eye_from_object;
    bool uses_normals = draw.lighting.enabled;
    draw.for_each_unit([&](std::size_t, const TextureUnit& unit) {
        uses_normals |= std::ranges::any_of(unit.generated, &GeneratedCoordinate::needs_normal);
    });
    if (!uses_normals || (matrix[0][3] == 0 && matrix[1][3] == 0 && matrix[2][3] == 0)) return false;
    constexpr double kRounding = 1e-6;
    const glm::dmat3 right = glm::inverse(glm::dmat3(matrix)), drivers = glm::dmat3(glm::inverse(matrix));
    double size = 0, difference = 0;
    for (int column = 0; column < 3; ++column) {
        size = std::max(size, glm::length(right[column]));
        difference = std::max(difference, glm::length(drivers[column] - right[column]));
    }
    return !(difference <= kRounding * size);  // nor if a matrix has no inverse
}

bool has_no_answer(const Draw& draw, const Vertex& vertex) {
    const glm::dvec4 eye = draw.eye_from_object * vertex.position_object;
    constexpr double kHuge = 0x1p100;  // the driver divides colours by w of clip coordinates, and loses them
    const glm::dvec4 clip = draw.clip_from_eye * eye;
    if (eye.w < 0 || std::abs(clip.w) > kHuge || clip == glm::dvec4(0)) return true;
    if (!draw.lighting.enabled) return false;
    if (vertex.normal_object == glm::dvec3(0) || glm::determinant(glm::dmat3(draw.eye_from_object)) == 0) return true;
    return any_light(draw, [&](const LightSource& light) {
        const glm::dvec3 p(light.position_eye);
        const bool is_here = light.is_directional()
                                 ? p == glm::dvec3(0)
                                 : glm::length(p / light.position_eye.w - eye_position(draw, vertex)) < 1e-3;
        const double attenuation = light.constant_attenuation + light.linear_attenuation + light.quadratic_attenuation;
        const bool has_axis = !light.has_cutoff() || light.spot_direction_eye != glm::dvec3(0);
        return is_here || !has_axis || (!light.is_directional() && attenuation == 0);
    });
}

// On the axis of a cone of 0 degrees, or at 90 degrees in one of 90 and behind that, floats give the specification's answer
// without rounding.
bool is_at_exact_edge_of_cone(const Draw& draw, const Vertex& vertex) {
    if (is_behind_cone_of_90(draw, vertex)) return true;
    return is_at_edge_of_cone(draw, vertex) && any_light(draw, [&](const LightSource& light) {
               return light.spot_cutoff_deg == 0 || light.spot_cutoff_deg == 90;
           });
}

bool is_near_edge_of_cone(const Draw& draw, const Vertex& vertex) {
    return is_at_edge_of_cone(draw, vertex) && !is_at_exact_edge_of_cone(draw, vertex);
}

bool has_light_at_horizon(const Draw& draw, const Vertex& vertex) {
    return any_light(draw, [&](const LightSource& light) {
        return std::abs(glm::dot(eye_normal(draw, vertex), toward(light, eye_position(draw, vertex)))) < kJump;
    });
}

}  // namespace twinlight::compare
