#include "render/effect/surface_draw.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace twinlight {
namespace {

bool has_inverse(const glm::dmat4& m) { return std::isnormal(glm::determinant(m)); }

// The z coordinate of the surface's middle on its axis.
double middle_of(const Surface& surface) {
    if (const auto* disk = std::get_if<DiskSurface>(&surface.equation)) return disk->z;
    if (const auto* frustum = std::get_if<FrustumSurface>(&surface.equation)) return frustum->height / 2;
    return 0;
}

Surface in_unit(Surface surface, double unit) {
    if (auto* sphere = std::get_if<SphereSurface>(&surface.equation)) {
        sphere->radius /= unit;
    } else if (auto* torus = std::get_if<TorusSurface>(&surface.equation)) {
        *torus = {torus->tube / unit, torus->ring / unit};
    } else if (auto* disk = std::get_if<DiskSurface>(&surface.equation)) {
        disk->inner /= unit;
        disk->outer /= unit;
        disk->z = 0;
    } else {
        auto& frustum = std::get<FrustumSurface>(surface.equation);
        frustum = {frustum.base / unit, frustum.top / unit, frustum.height / unit};
    }
    return surface;
}

// The columns are the axes of the surface's space (surface_parts) in object space.
glm::dmat4 object_from_surface_axes(const Surface& surface) {
    glm::dmat4 m(1);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 along(0);
        along[axis] = 1;
        m[axis] = glm::dvec4(vec3_cast<glm::dvec3>(object_from_surface(surface, vec3_cast<Vec3<double>>(along))), 0);
    }
    return m;
}

// A frustum's outward normals have one angle to the axis, a disk has one normal; spheres and tori have all directions.
void find_normals(const Surface& surface, VertexFacts& facts) {
    facts.shortest_normal = facts.longest_normal = 1;
    facts.normals_equal = false;
    facts.normal_half_angle = std::numbers::pi;
    double along_axis = 0;  // of the unit normal
    if (const auto* disk = std::get_if<DiskSurface>(&surface.equation)) {
        facts.normals_equal = true;
        facts.normal_half_angle = 0;
        along_axis = disk->faces_up ? 1 : -1;
    } else if (const auto* frustum = std::get_if<FrustumSurface>(&surface.equation)) {
        const double narrows = frustum->base - frustum->top;
        along_axis = narrows / std::hypot(frustum->height, narrows);
        facts.normal_half_angle = std::acos(std::max(std::abs(along_axis) - kBoundsRounding, 0.0));
    }
    if (surface.inside) along_axis = -along_axis;
    facts.normal_axis_dir_object = {0, 0, along_axis < 0 ? -1 : 1};
}

VertexFacts facts_of(const Surface& surface, const Draw& draw) {
    VertexFacts facts;
    const Reach reach = reach_of(surface);
    const bool is_sphere = std::holds_alternative<SphereSurface>(surface.equation);
    const bool is_torus = std::holds_alternative<TorusSurface>(surface.equation);
    facts.has_sphere = true;
    facts.radius_object =
        (is_sphere || is_torus ? reach.across : std::hypot(reach.across, reach.along)) * (1 + kBoundsRounding);
    facts.position_reach = {reach.across, reach.across, reach.along, 1};
    find_normals(surface, facts);
    const Vertex& vertex = draw.vertices.front();
    facts.color_low = facts.color_high = vertex.color;
    facts.q_is_1 = surface.textured || vertex.tex_coord.q == 1;
    if (!draw.materials.empty()) facts.materials.push_back(vertex.material);
    return facts;
}

// The Draw without its vertices.
Draw state_of(const Draw& draw) {
    Draw state;
    state.lighting = draw.lighting;
    state.raster = draw.raster;
    state.texture = draw.texture;
    state.fog = draw.fog;
    state.fragment = draw.fragment;
    state.materials = draw.materials;
    state.eye_from_object = draw.eye_from_object;
    state.clip_from_eye = draw.clip_from_eye;
    state.place = draw.place;
    return state;
}

SurfaceDraw surface_draw(const Surface& surface, const Draw& shape) {
    const Reach reach = reach_of(surface);
    const double unit = std::exp2(std::ceil(std::log2(std::max(reach.across, reach.along))));
    SurfaceDraw result{.surface = in_unit(surface, unit), .draw = state_of(shape), .facts = {}};
    result.facts = facts_of(result.surface, shape);
    Draw& draw = result.draw;
    draw.eye_from_object =
        glm::scale(glm::translate(draw.eye_from_object * object_from_surface_axes(surface), {0, 0, middle_of(surface)}),
                   glm::dvec3(unit));
    draw.lighting.normalize = true;
    draw.lighting.rescale_normal = false;
    draw.mode = kGL_TRIANGLE_STRIP;
    for (int corner = 0; corner < 4; ++corner) {
        Vertex& vertex = draw.vertices.edit().emplace_back(shape.vertices.front());
        vertex.position_object = {corner & 1, corner >> 1, 0, 1};
        vertex.normal_object = result.facts.normal_axis_dir_object;
    }
    return result;
}

}  // namespace

Reach reach_of(const Surface& surface) {
    if (const auto* sphere = std::get_if<SphereSurface>(&surface.equation)) return {sphere->radius, sphere->radius};
    if (const auto* torus = std::get_if<TorusSurface>(&surface.equation))
        return {torus->ring + torus->tube, torus->tube};
    if (const auto* disk = std::get_if<DiskSurface>(&surface.equation)) return {disk->outer, 0};
    const auto& frustum = std::get<FrustumSurface>(surface.equation);
    return {std::max(frustum.base, frustum.top), frustum.height / 2};
}

std::vector<SurfaceDraw> surface_draws(const Draw& draw) {
    std::vector<SurfaceDraw> draws;
    if (!has_inverse(draw.clip_from_eye) || !has_inverse(draw.eye_from_object)) return draws;
    for (const Surface& surface : *draw.surfaces) draws.push_back(surface_draw(surface, draw));
    return draws;
}

}  // namespace twinlight
