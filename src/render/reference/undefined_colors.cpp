#include "render/reference/undefined_colors.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "base/math/normal_matrix.h"
#include "render/lighting_of.h"

namespace twinlight::reference {

std::string_view words_of(Undefined undefined) {
    switch (undefined) {
        case Undefined::kNormalMatrix: return "the modelview matrix has no inverse, so there are no normals (2.11.3)";
        case Undefined::kNormal: return "a normal is (0, 0, 0), and GL_NORMALIZE divides by its length (2.11.3)";
        case Undefined::kAttenuation: return "the attenuation of a light divides by 0 (2.14.1)";
        case Undefined::kLightDirection: return "a light is at the vertex, so it has no direction (2.14.1)";
        case Undefined::kSpotDirection: return "a spot's direction is (0, 0, 0) (2.14.1)";
    }
    return "";
}

namespace {

bool has_no_normals(const Draw& draw) { return draw.lighting.enabled && is_singular(glm::dmat3(draw.eye_from_object)); }

std::optional<Undefined> by_light(const LightSource& light, const glm::dvec4& eye) {
    const glm::dvec4& place = light.position_eye;
    if (light.has_cutoff() && light.spot_direction_eye == glm::dvec3(0)) return Undefined::kSpotDirection;
    if (light.is_directional())
        return glm::dvec3(place) == glm::dvec3(0) ? std::optional(Undefined::kLightDirection) : std::nullopt;
    const double d = eye.w == 0 ? 0 : glm::length(glm::dvec3(place) / place.w - glm::dvec3(eye) / eye.w);
    const double divisor = lighting::attenuation_denominator(lighting_of(light), d);
    if (eye.w != 0 && d == 0) return Undefined::kLightDirection;
    return divisor == 0 && eye.w != 0 ? std::optional(Undefined::kAttenuation) : std::nullopt;
}

std::optional<Undefined> undefined_color(const Draw& draw, bool has_no_normals, const Vertex& vertex) {
    const LightingState& lighting = draw.lighting;
    if (!lighting.enabled || std::ranges::none_of(lighting.lights, &LightSource::enabled)) return std::nullopt;
    if (has_no_normals) return Undefined::kNormalMatrix;
    if (lighting.normalize && vertex.normal_object == glm::dvec3(0)) return Undefined::kNormal;
    const glm::dvec4 eye = draw.eye_from_object * vertex.position_object;
    for (const LightSource& light : lighting.lights)
        if (light.enabled)
            if (const auto undefined = by_light(light, eye)) return undefined;
    return std::nullopt;
}

}  // namespace

std::optional<Undefined> undefined_color(const Draw& draw, const Vertex& vertex) {
    return undefined_color(draw, has_no_normals(draw), vertex);
}

std::optional<Undefined> first_undefined_color(const Frame& frame) {
    for (const Draw* draw : frame.draws()) {
        const bool is_flat = has_no_normals(*draw);
        for (const Vertex& vertex : draw->vertices)
            if (const auto undefined = undefined_color(*draw, is_flat, vertex)) return undefined;
    }
    return std::nullopt;
}

bool StagedFrame::is_undefined(const Piece& piece) const {
    if (undefined.empty() || undefined[piece.draw].empty()) return false;
    const std::vector<char>& of_vertices = undefined[piece.draw];
    const Primitive& primitive = piece.primitive;
    if (draw_of(piece).lighting.shade_model == kGL_FLAT) return of_vertices[primitive.provoking] != 0;
    const std::size_t count = primitive.shape == Shape::kPoint ? 1 : primitive.shape == Shape::kLine ? 2 : 3;
    return std::any_of(primitive.vertices.begin(), primitive.vertices.begin() + static_cast<std::ptrdiff_t>(count),
                       [&](std::uint32_t vertex) { return of_vertices[vertex] != 0; });
}

void mark_undefined_colors(StagedFrame& stages) {
    for (std::size_t i = 0; i < stages.draws.size(); ++i) {
        const Draw& draw = *stages.draws[i].draw;
        const bool is_flat = has_no_normals(draw);
        std::vector<char> of_vertices;
        for (std::size_t v = 0; v < draw.vertices.size(); ++v) {
            if (!undefined_color(draw, is_flat, draw.vertices[v])) continue;
            of_vertices.resize(draw.vertices.size());
            of_vertices[v] = 1;
        }
        if (of_vertices.empty()) continue;
        stages.undefined.resize(stages.draws.size());
        stages.undefined[i] = std::move(of_vertices);
    }
}

}  // namespace twinlight::reference
