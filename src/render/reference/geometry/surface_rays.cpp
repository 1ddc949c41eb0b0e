#include "render/reference/geometry/surface_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include "base/math/normal_matrix.h"
#include "render/reference/geometry/piece.h"
#include "render/reference/geometry/texture_place.h"

namespace twinlight::reference {

namespace {

glm::dvec3 glm_of(const Vec& v) { return vec3_cast<glm::dvec3>(v); }
glm::dvec4 place_of(const Vec& v) { return glm::dvec4(glm_of(v), 1); }

bool has_inverse(const glm::dmat4& m) { return std::isnormal(glm::determinant(m)); }

// The extent of a box around the surface: its distance across the axis, and its range along the axis.
struct Extent {
    double across, low, high;
};
Extent extent_of(const Surface& surface) {
    if (const auto* sphere = std::get_if<SphereSurface>(&surface.equation))
        return {sphere->radius, -sphere->radius, sphere->radius};
    if (const auto* torus = std::get_if<TorusSurface>(&surface.equation))
        return {torus->ring + torus->tube, -torus->tube, torus->tube};
    if (const auto* disk = std::get_if<DiskSurface>(&surface.equation)) return {disk->outer, disk->z, disk->z};
    const auto& frustum = std::get<FrustumSurface>(surface.equation);
    return {std::max(frustum.base, frustum.top), 0, frustum.height};
}

// The derivative of the ndc position if the clip position moves along `step`.
glm::dvec3 ndc_change(const glm::dvec4& clip, const glm::dvec4& step) {
    return (glm::dvec3(step) - glm::dvec3(clip) / clip.w * step.w) / clip.w;
}

}  // namespace

SurfaceRays::SurfaceRays(const Draw& draw, const Surface& surface)
    : draw_(draw), surface_(surface), normal_eye_from_object_(normal_matrix(glm::dmat3(draw.eye_from_object))) {
    clip_from_object_ = draw.clip_from_eye * draw.eye_from_object;
    has_inverse_ = has_inverse(draw.clip_from_eye) && has_inverse(draw.eye_from_object);
    if (!has_inverse_) return;
    object_from_clip_ = glm::inverse(draw.eye_from_object) * glm::inverse(draw.clip_from_eye);
    find_window_bounds();
}

void SurfaceRays::find_window_bounds() {
    const Rectangle& viewport = draw_.raster.viewport;
    const glm::dvec2 origin(viewport.x, viewport.y), size(viewport.width, viewport.height);
    low_window_ = origin + size;
    high_window_ = origin;
    const Extent extent = extent_of(surface_);
    for (int corner = 0; corner < 8; ++corner) {
        const Vec place{(corner & 1) != 0 ? extent.across : -extent.across,
                        (corner & 2) != 0 ? extent.across : -extent.across,
                        (corner & 4) != 0 ? extent.high : extent.low};
        const glm::dvec4 c = clip(place_of(object_from_surface(surface_, place)));
        if (!(c.w > 0)) {  // behind the eye, so the projected box bounds nothing
            low_window_ = origin;
            high_window_ = origin + size;
            return;
        }
        const glm::dvec2 window(window_from_ndc(draw_.raster, glm::dvec3(c) / c.w));
        low_window_ = glm::min(low_window_, window);
        high_window_ = glm::max(high_window_, window);
    }
    low_window_ = glm::max(low_window_, origin);
    high_window_ = glm::min(high_window_, origin + size);
}

int SurfaceRays::most_points() const {
    if (!has_inverse_) return 0;
    if (std::holds_alternative<TorusSurface>(surface_.equation)) return 4;
    return std::holds_alternative<DiskSurface>(surface_.equation) ? 1 : 2;
}

template <class Visit>
void SurfaceRays::for_each_crossing(const glm::dvec2& position_window, double slack, const Visit& visit) const {
    const Rectangle& viewport = draw_.raster.viewport;
    const glm::dvec2 ndc =
        (position_window - glm::dvec2(viewport.x, viewport.y)) / glm::dvec2(viewport.width, viewport.height) * 2.0 -
        1.0;
    const glm::dvec4 near = object_from_clip_ * glm::dvec4(ndc, -1, 1), far = object_from_clip_ * glm::dvec4(ndc, 1, 1);
    if (near.w == 0) return;
    const glm::dvec3 from = glm::dvec3(near) / near.w;
    glm::dvec3 way = glm::dvec3(far) - from * far.w;  // the far plane may be at infinity
    if (far.w < 0) way = -way;
    if (way == glm::dvec3(0)) return;
    const Vec origin = surface_from_object(surface_, vec3_cast<Vec>(from)),
              direction = surface_from_object(surface_, vec3_cast<Vec>(way));
    const Crossings<double> all = crossings(surface_, origin, direction);
    for (int i = all.count - 1; i >= 0; --i) {
        const Vec at = origin + all.s[static_cast<std::size_t>(i)] * direction;
        const glm::dvec4 position_object = place_of(object_from_surface(surface_, at));
        if (!is_inside(position_object, slack)) continue;
        const Vec normal_object = object_from_surface(surface_, lighting::unit(outward_normal(surface_, at)));
        const Tangents on = tangents(position_object, normal_object);
        if (culled(draw_.raster, face(on))) continue;
        if (!visit(position_object, normal_object, on)) return;
    }
}

std::vector<RayPoint> SurfaceRays::points(const glm::dvec2& position_window, double slack) const {
    std::vector<RayPoint> points;
    for_each_crossing(position_window, slack, [&](const auto&... crossing) {
        points.push_back(seen(crossing...));
        return true;
    });
    return points;
}

std::optional<RayPoint> SurfaceRays::point(const glm::dvec2& position_window, int number) const {
    std::optional<RayPoint> point;
    for_each_crossing(position_window, 0, [&](const auto&... crossing) {
        if (number-- == 0) point = seen(crossing...);
        return !point;
    });
    return point;
}

// 2.12: the view volume and the clip planes.
bool SurfaceRays::is_inside(const glm::dvec4& position_object, double slack) const {
    const glm::dvec4 c = clip(position_object);
    const double border = c.w * (1 + slack);
    if (!(c.w > 0) || std::abs(c.x) > border || std::abs(c.y) > border || std::abs(c.z) > border) return false;
    const glm::dvec4 position_eye = draw_.eye_from_object * position_object;
    return std::ranges::all_of(draw_.raster.clip_planes_eye, [&](const auto& plane) {
        return !plane || glm::dot(*plane, position_eye) >= -slack * glm::dot(glm::abs(*plane), glm::abs(position_eye));
    });
}

SurfaceRays::Tangents SurfaceRays::tangents(const glm::dvec4& position_object, const Vec& normal_object) const {
    const Vec& n = normal_object;
    // Perpendicular to the axis that n is farthest from.
    const bool x_is_least = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z);
    const bool y_is_least = std::abs(n.y) <= std::abs(n.z);
    const Vec axis = x_is_least ? Vec{1, 0, 0} : y_is_least ? Vec{0, 1, 0} : Vec{0, 0, 1};
    Tangents result{};
    result.u = lighting::unit(cross(axis, n));
    result.v = cross(n, result.u);
    const glm::dvec4 c = clip(position_object), along_u = clip_from_object_ * glm::dvec4(glm_of(result.u), 0),
                     along_v = clip_from_object_ * glm::dvec4(glm_of(result.v), 0);
    const Rectangle& viewport = draw_.raster.viewport;
    const glm::dvec3 window_per_ndc =
        glm::dvec3(viewport.width, viewport.height, draw_.raster.depth_far - draw_.raster.depth_near) / 2.0;
    result.window_per_u = ndc_change(c, along_u) * window_per_ndc;
    result.window_per_v = ndc_change(c, along_v) * window_per_ndc;
    result.is_counter_clockwise =
        result.window_per_u.x * result.window_per_v.y - result.window_per_u.y * result.window_per_v.x > 0;
    return result;
}

glm::dvec3 SurfaceRays::Tangents::object_step(const glm::dvec2& window_step) const {
    const glm::dmat2 window_per_uv{glm::dvec2(window_per_u), glm::dvec2(window_per_v)};
    if (glm::determinant(window_per_uv) == 0) return glm::dvec3(0);  // seen edge on
    const glm::dvec2 uv = glm::inverse(window_per_uv) * window_step;
    return uv.x * glm_of(u) + uv.y * glm_of(v);
}

// 2.14.1: a clockwise face is a back face; GL_CW and an inverted shape reverse this.
Face SurfaceRays::face(const Tangents& tangents) const {
    const bool turned = (draw_.raster.front_face == kGL_CW) != surface_.inside;
    return tangents.is_counter_clockwise != turned ? Face::kFront : Face::kBack;
}

// 3.5.5: the slope is the tangent plane's.
double SurfaceRays::depth(const glm::dvec4& position_object, const Tangents& tangents) const {
    const RasterState& raster = draw_.raster;
    const glm::dvec4 c = clip(position_object);
    double depth = window_from_ndc(raster, glm::dvec3(c) / c.w).z;
    if (raster.polygon_offset.fill) {
        const glm::dmat2 window_per_uv{glm::dvec2(tangents.window_per_u), glm::dvec2(tangents.window_per_v)};
        const glm::dvec2 depth_per_uv(tangents.window_per_u.z, tangents.window_per_v.z);
        const glm::dvec2 slope = glm::determinant(window_per_uv) == 0
                                     ? glm::dvec2(0)
                                     : glm::transpose(glm::inverse(window_per_uv)) * depth_per_uv;
        depth += polygon_offset(raster, kGL_FILL, slope);
    }
    return std::clamp(depth, 0.0, 1.0);
}

glm::dvec2 SurfaceRays::tex_coord(const glm::dvec3& position_object) const {
    const auto [s, t] = surface_tex_coord(surface_, surface_from_object(surface_, vec3_cast<Vec>(position_object)));
    return {s, t};
}

// The change per pixel is measured on the tangent plane over a small fraction of a pixel, because s may jump from 0 to
// 1 nearby.
TexturePlace SurfaceRays::texture_place(const glm::dvec3& position_object, const Tangents& tangents) const {
    constexpr double kPart = 1.0 / 1024;
    const glm::dvec4 fixed = draw_.vertices.front().tex_coord;
    const glm::dvec2 here = surface_.textured ? tex_coord(position_object) : glm::dvec2(fixed);
    const auto transformed = [&](const glm::dvec2& st) -> glm::dvec3 {
        const glm::dvec4 t = draw_.texture.texture_matrix * (surface_.textured ? glm::dvec4(st, 0, 1) : fixed);
        return {quotient(t.x, t.w), quotient(t.y, t.w), 0};  // no exact surface has a texture that needs r
    };
    TexturePlace place{.str = transformed(here)};
    const auto change = [&](const glm::dvec2& window_step) {
        glm::dvec2 there = tex_coord(position_object + tangents.object_step(kPart * window_step));
        there -= glm::round(there - here);
        return (transformed(there) - place.str) / kPart;
    };
    if (surface_.textured) {
        place.per_x = change({1, 0});
        place.per_y = change({0, 1});
    }
    return place;
}

RayPoint SurfaceRays::seen(const glm::dvec4& position_object, const Vec& normal_object,
                           const Tangents& tangents) const {
    RayPoint point{
        .object = {}, .vertex = {}, .depth = depth(position_object, tangents), .face = face(tangents), .place = {}};
    point.vertex.position_eye = draw_.eye_from_object * position_object;
    point.vertex.position_clip = clip(position_object);
    point.object.position_object = position_object;
    point.object.normal_object = glm_of(surface_.inside ? -normal_object : normal_object);
    point.vertex.normal_eye =
        glm_of(lighting::unit(vec3_cast<Vec>(normal_eye_from_object_ * point.object.normal_object)));
    point.vertex.color = draw_.vertices.front().color;
    if (draw_.texture.texture) point.place = texture_place(glm::dvec3(position_object), tangents);
    return point;
}

}  // namespace twinlight::reference
