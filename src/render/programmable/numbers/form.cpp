#include "render/programmable/numbers/form.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "base/math/directions.h"
#include "base/math/normal_matrix.h"
#include "render/programmable/numbers/vertex_attributes.h"
#include "render/programmable/numbers/wide_range.h"
#include "scene/frame/far_from_origin.h"

namespace twinlight::programmable {
namespace {

constexpr double kFloatRounding = 0x1p-23;

// Far enough from the limits of float that squares and their sums stay in range.
bool ordinary(double size) { return size > 1e-6 && size < 1e6; }

bool ordinary_or_zero(const glm::dvec3& v) {
    const double size = glm::length(v);
    return size == 0 || ordinary(size);
}

bool lit_in_object_space(const Draw& draw, const Plan& plan, bool is_surface) {
    const EffectSet& effects = plan.effects;
    if (!effects.lighting || effects.vertex_w || plan.for_any_pose) return false;
    // Fragments of a mesh are lit in eye coordinates, where lights keep their place if the object moves. Fragments of
    // an exact surface are computed in its own space, with normals of length 1.
    const bool by_fragment = effects.shading == Shading::kPhong;
    if (by_fragment && !is_surface) return false;
    const double scale = similarity_scale(draw.eye_from_object);
    if (!ordinary(scale)) return false;
    // The normal matrix is the rotation times 1 / scale; GL_NORMALIZE and GL_RESCALE_NORMAL remove the scale.
    const bool scales_normals = !effects.normalize && !plan.lighting.rescale_normal && !by_fragment;
    if (effects.needs_normal() && scales_normals && std::abs(scale - 1) > kFloatRounding) return false;
    if (!effects.needs_position_eye()) return true;
    // Distances in object coordinates must be as exact as in eye coordinates, so no large translation may lie between
    // them.
    if (!ordinary_or_zero(glm::dvec3(draw.eye_from_object[3]))) return false;
    return std::ranges::all_of(plan.lights, [&](const PlannedLight& planned) {
        const glm::dvec4& p = plan.lighting.lights[static_cast<std::size_t>(planned.number)].position_eye;
        return p.w == 0 || ordinary_or_zero(glm::dvec3(p) / p.w);
    });
}

bool has_wide_normals(const Draw& draw, const EffectSet& effects) {
    if (!effects.lighting || !effects.needs_normal() || !makes_normals_unit(effects)) return false;
    constexpr double kMostDifferent = 1e6;
    const glm::dmat3 m(draw.eye_from_object);
    const auto [shortest, longest] =
        std::minmax({largest_component(m[0]), largest_component(m[1]), largest_component(m[2])});
    return longest > kMostDifferent * shortest;
}

// The root of the sum of the squares of all elements: at least the largest stretch.
double norm(const glm::dmat3& m) {
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

}  // namespace

bool has_sized_normals(const Draw& draw, const Plan& plan) {
    const EffectSet& effects = plan.effects;
    const double shortest = plan.vertices.shortest_normal, longest = plan.vertices.longest_normal;
    if (!effects.lighting || !effects.any_light(&LightEffects::specular) || longest == 0) return false;
    if (effects.normalize || effects.shading == Shading::kPhong || effects.highlight == Highlight::kReflection)
        return false;
    const glm::dmat3 m(draw.eye_from_object);
    // With rows and columns about as long as 1, an invertible matrix scales normals by less than 1e9 (normal_matrix.h).
    const auto is_near_1 = [](double size) { return size > 1e-2 && size < 1e2; };
    const glm::dmat3 rows = glm::transpose(m);
    bool all_near_1 = is_near_1(shortest) && is_near_1(longest);
    for (int i = 0; i < 3; ++i)
        all_near_1 = all_near_1 && is_near_1(largest_component(m[i])) && is_near_1(largest_component(rows[i]));
    if (all_near_1) return false;
    const glm::dmat3 normals = normal_matrix(m);
    const double largest_stretch = norm(normals), third = glm::length(normals[2]);
    if (!(largest_stretch > 0)) return false;
    const double factor = plan.lighting.rescale_normal && third > 0 ? 1 / third : 1;
    constexpr double kShort = 1e-9, kLong = 1e9;  // their squares, and those of small cosines with them, are floats
    return !(factor * shortest / norm(m) > kShort && factor * longest * largest_stretch < kLong);
}

double similarity_scale(const glm::dmat4& eye_from_object) {
    const glm::dmat4& m = eye_from_object;
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) return 0;
    const glm::dmat3 linear(m);
    const glm::dmat3 products = glm::transpose(linear) * linear;
    const double square = products[0][0];
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(products[column][row] - (column == row ? square : 0)) <= kFloatRounding * square)) return 0;
    return std::sqrt(square);
}

std::optional<glm::dvec3> upload_origin(const Draw& draw, const VertexFacts& facts) {
    // Relative coordinates are as large as the object, not as its distance from the origin: this saves at least two
    // bits.
    constexpr double kGain = 4;
    if (!facts.has_sphere || !(glm::length(facts.center_object) > kGain * facts.radius_object)) return {};
    double stretch = 0;  // bounds the squared stretch: the sum of the squares of the matrix's elements
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 axis(draw.eye_from_object[column]);
        stretch += glm::dot(axis, axis);
    }
    const double radius_eye = std::sqrt(stretch) * facts.radius_object;
    if (!is_far_from_origin(draw, glm::dvec4(facts.center_object, 1), radius_eye)) return {};
    return facts.center_object;
}

bool reads_stored_color(Enum logic_op) {
    return logic_op != kGL_CLEAR && logic_op != kGL_SET && logic_op != kGL_COPY && logic_op != kGL_COPY_INVERTED;
}

void set_dialect(Code& code, const Draw& draw, Glsl dialect) {
    Form& form = code.form;
    form.dialect = dialect;
    if (draw.fragment.alpha_test) form.alpha_func = draw.fragment.alpha_func;
    if (dialect != Glsl::k300es) return;
    form.sprites_rise = draw.draws_sprites() && draw.raster.point_parameters.sprite_coord_origin == kGL_LOWER_LEFT;
    form.sizes_points = draw.draws_points() && !code.effects.attenuated_points;
}

Code code_for(const Draw& draw, const Plan& plan, const SurfaceForm& surface) {
    const bool is_surface = surface.kind != SurfaceKind::kNone;
    const bool wide_range = !is_surface && has_wide_range(draw, plan);
    const bool homogeneous = !is_surface && !wide_range && plan.effects.lighting && plan.effects.vertex_w &&
                             plan.effects.needs_position_eye();
    Code code{.effects = plan.effects,
              .form = {.object_space = !wide_range && lit_in_object_space(draw, plan, is_surface),
                       .wide_range = wide_range,
                       .homogeneous = homogeneous,
                       .wide_normals = !is_surface && has_wide_normals(draw, plan.effects),
                       .sized_normals = !is_surface && has_sized_normals(draw, plan),
                       .position_w = !plan.vertices.w_is_1,
                       .loops = {},
                       .surface = surface},
              .lights = {},
              .origin_object = upload_origin(draw, plan.vertices)};
    code.lights.reserve(plan.effects.lights.size());
    if (plan.effects.lights.size() <= kMostWrittenOut) {
        for (std::size_t i = 0; i < plan.effects.lights.size(); ++i) code.lights.push_back({i});
        return code;
    }
    std::map<LightEffects, std::vector<std::size_t>> equal;
    for (std::size_t i = 0; i < plan.effects.lights.size(); ++i) equal[plan.effects.lights[i]].push_back(i);
    code.effects.lights.clear();
    for (std::size_t i = 0; i < plan.effects.lights.size(); ++i) {
        if (equal[plan.effects.lights[i]].size() > kMostWrittenOut) continue;
        code.effects.lights.push_back(plan.effects.lights[i]);
        code.lights.push_back({i});
    }
    for (const auto& [facts, lights] : equal) {
        if (lights.size() <= kMostWrittenOut) continue;
        code.effects.lights.push_back(facts);
        code.form.loops.push_back(
            static_cast<int>(std::bit_ceil(lights.size())));  // rounded up, so that a few more lights need no new text
        code.lights.push_back(lights);
    }
    return code;
}

}  // namespace twinlight::programmable
