#include "render/programmable/surface_values.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "render/effect/surface_draw.h"

namespace twinlight::programmable {
namespace {

// ---- Which of a ray's points are drawn ----

int most_points(const Surface& surface) {
    if (std::holds_alternative<TorusSurface>(surface.equation)) return 4;
    return std::holds_alternative<DiskSurface>(surface.equation) ? 1 : 2;
}

// A ray's points come from far to near (scene/shape/surface.h); each may be a fragment.
enum class Points { kNearest, kFarthest, kAll };

// Whether one point hides the others whatever was drawn before. The nearer of two points has the smaller depth, unless
// the depth range is reversed or depths are offset by slopes.
Points points_of(const Draw& draw) {
    const RasterState& raster = draw.raster;
    if (draw.fragment.blend || draw.fragment.alpha_test) return Points::kAll;
    if (!raster.depth_test || raster.depth_func == kGL_ALWAYS) return Points::kNearest;
    const bool is_in_order =
        raster.depth_near < raster.depth_far && !(raster.polygon_offset.fill && raster.polygon_offset.factor != 0);
    if (!is_in_order) return Points::kAll;
    if (raster.depth_func == kGL_LESS || raster.depth_func == kGL_LEQUAL) return Points::kNearest;
    const bool is_farther = raster.depth_func == kGL_GREATER || raster.depth_func == kGL_GEQUAL;
    return is_farther && raster.depth_mask ? Points::kFarthest : Points::kAll;
}

// ---- Where the surface lies ----

// The corners of the surface's bounding box, in clip coordinates.
std::vector<glm::dvec4> clip_corners(const Surface& surface, const glm::dmat4& clip_from_surface) {
    const Reach reach = reach_of(surface);
    std::vector<glm::dvec4> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(clip_from_surface * glm::dvec4((i & 1) != 0 ? reach.across : -reach.across,
                                                         (i & 2) != 0 ? reach.across : -reach.across,
                                                         (i & 4) != 0 ? reach.along : -reach.along, 1));
    return corners;
}

struct Rectangle {  // window coordinates
    glm::dvec2 low{0}, high{0};
};

// The surface lies inside this rectangle, which includes a margin of one pixel for float rounding. Nothing if the
// rectangle is outside the viewport.
std::optional<Rectangle> window_rectangle(const Viewport& viewport, const std::vector<glm::dvec4>& corners) {
    const glm::dvec2 origin(viewport.x, viewport.y), size(viewport.width, viewport.height);
    Rectangle rectangle{origin + size, origin};
    for (const glm::dvec4& corner : corners) {
        if (!(corner.w > 0)) {  // behind the eye, so the projected box bounds nothing
            rectangle = {origin, origin + size};
            break;
        }
        const glm::dvec2 window = (glm::dvec2(corner) / corner.w + 1.0) / 2.0 * size + origin;
        rectangle = {glm::min(rectangle.low, window - 1.0), glm::max(rectangle.high, window + 1.0)};
    }
    rectangle = {glm::max(rectangle.low, origin), glm::min(rectangle.high, origin + size)};
    if (rectangle.low.x >= rectangle.high.x || rectangle.low.y >= rectangle.high.y) return {};
    return rectangle;
}

// ---- The numbers ----

class SurfaceUniforms {
  public:
    SurfaceUniforms(const SurfaceDraw& surface, Uniforms uniforms)
        : surface_(surface.surface), draw_(surface.draw), uniforms_(std::move(uniforms)) {}

    Uniforms build(const Rectangle& rectangle) {
        rays(rectangle);
        clip_space();
        equation();
        return std::move(uniforms_);
    }

  private:
    void set(const char* name, std::initializer_list<double> values) {
        uniforms_.add(name);
        for (const double value : values) uniforms_.push_back(to_float(value));
    }
    void set(const char* name, const glm::dvec3& v) { set(name, {v.x, v.y, v.z}); }
    void set(const char* name, const glm::dvec4& v) { set(name, {v.x, v.y, v.z, v.w}); }

    // The ray through a window position goes through two points: h, the point that projects to (x_ndc, y_ndc, z) for
    // some z, and the preimage of the depth direction: the eye, or a point at infinity.
    void rays(const Rectangle& rectangle) {
        const Viewport& viewport = draw_.raster.viewport;
        const glm::dvec2 origin(viewport.x, viewport.y), size(viewport.width, viewport.height);
        const auto ndc = [&](const glm::dvec2& window) { return (window - origin) / size * 2.0 - 1.0; };
        const glm::dvec2 low = ndc(rectangle.low), high = ndc(rectangle.high);
        set("u_rectangle_ndc", {low.x, low.y, high.x, high.y});
        const glm::dvec2 middle_window = glm::floor((rectangle.low + rectangle.high) / 2.0) + 0.5;
        set("u_middle_window", {middle_window.x, middle_window.y});

        // The z of the surface's middle, so that h is close to it.
        const glm::dvec4 middle_clip = clip_from_surface_[3];
        const double z = middle_clip.w > 0 ? std::clamp(middle_clip.z / middle_clip.w, -1.0, 1.0) : -1;
        const glm::dvec4 h = surface_from_clip_ * glm::dvec4(ndc(middle_window), z, 1);
        const glm::dvec4 depth = surface_from_clip_[2];
        const glm::dvec4 per_x = surface_from_clip_[0] * (2 / size.x), per_y = surface_from_clip_[1] * (2 / size.y);
        const auto direction = [&](const glm::dvec4& at) {
            return glm::dvec3(depth) * at.w - glm::dvec3(at) * depth.w;
        };
        const auto moment = [&](const glm::dvec4& at) { return glm::cross(glm::dvec3(at), glm::dvec3(depth)); };
        const double unit = 1 / glm::length(direction(h));
        set("u_direction", unit * direction(h));
        set("u_direction_per_x", unit * direction(per_x));
        set("u_direction_per_y", unit * direction(per_y));
        set("u_moment", unit * moment(h));
        set("u_moment_per_x", unit * moment(per_x));
        set("u_moment_per_y", unit * moment(per_y));

        // How the point that projects to a window position moves with x, y and depth; homogeneous.
        const double scale = 1 / clip_unit();
        set("u_step_x", scale * per_x);
        set("u_step_y", scale * per_y);
        set("u_step_depth", scale * depth);
    }

    // Clip coordinates have no unit; this one makes w about 1.
    double clip_unit() const {
        const glm::dvec4 w = glm::abs(glm::transpose(clip_from_surface_)[3]);
        return 1 / std::max({w.x, w.y, w.z, w.w, std::numeric_limits<double>::min()});
    }

    // w - z and w + z are 0 on the far and near plane. They are uniforms, because the difference of floats would be
    // inexact.
    void clip_space() {
        const glm::dmat4 rows = clip_unit() * glm::transpose(clip_from_surface_);
        set("u_clip_w", rows[3]);
        set("u_to_near_plane", rows[3] + rows[2]);
        set("u_to_far_plane", rows[3] - rows[2]);
        const RasterState& raster = draw_.raster;
        set("u_far_depth", {raster.depth_far});
        set("u_half_depth_range", {(raster.depth_far - raster.depth_near) / 2});
        // 2.14.1: seen with its outward normal towards the eye, a surface is counter-clockwise, unless a matrix mirrors
        // it. Clip coordinates are left-handed.
        const double determinant = glm::determinant(draw_.eye_from_object) * glm::determinant(draw_.clip_from_eye);
        const bool turned = (raster.front_face == kGL_CW) != surface_.inside;
        const double front_side = (determinant > 0) != turned ? 1 : -1;
        set("u_front_side", {front_side});
        set("u_shown_side", {raster.cull_face == kGL_BACK ? front_side : -front_side});
        constexpr double kDepthStep = 1.0 / (1 << 24);  // r of section 3.5.5, for a 24-bit depth buffer
        set("u_offset_factor", {raster.polygon_offset.factor});
        set("u_offset", {raster.polygon_offset.units * kDepthStep});
    }

    void equation() {
        if (const auto* sphere = std::get_if<SphereSurface>(&surface_.equation)) {
            set("u_radius", {sphere->radius});
        } else if (const auto* torus = std::get_if<TorusSurface>(&surface_.equation)) {
            set("u_tube", {torus->tube});
            set("u_ring", {torus->ring});
        } else if (const auto* disk = std::get_if<DiskSurface>(&surface_.equation)) {
            set("u_inner", {disk->inner});
            set("u_outer", {disk->outer});
            set("u_disk_side", {disk->faces_up ? 1.0 : -1.0});
            const double half = std::min(std::abs(disk->sweep_deg) / 2, 180.0) * std::numbers::pi / 180;
            const double middle = (disk->start_deg + disk->sweep_deg / 2) * std::numbers::pi / 180;
            set("u_sector", {std::sin(middle), std::cos(middle), std::sin(half), std::cos(half)});
        } else {
            const auto& frustum = std::get<FrustumSurface>(surface_.equation);
            set("u_radius", {(frustum.base + frustum.top) / 2});
            set("u_slope", {(frustum.top - frustum.base) / frustum.height});
            set("u_half_height", {frustum.height / 2});
        }
    }

    const Surface& surface_;
    const Draw& draw_;
    const glm::dmat4 clip_from_surface_ = draw_.clip_from_eye * draw_.eye_from_object;
    const glm::dmat4 surface_from_clip_ = glm::inverse(draw_.eye_from_object) * glm::inverse(draw_.clip_from_eye);
    Uniforms uniforms_;
};

// ---- The code ----

SurfaceKind kind_of(const Surface& surface) {
    if (std::holds_alternative<SphereSurface>(surface.equation)) return SurfaceKind::kSphere;
    if (std::holds_alternative<TorusSurface>(surface.equation)) return SurfaceKind::kTorus;
    return std::holds_alternative<DiskSurface>(surface.equation) ? SurfaceKind::kDisk : SurfaceKind::kFrustum;
}

SurfaceForm form_of(const SurfaceDraw& surface, const Plan& plan, const std::vector<glm::dvec4>& corners) {
    constexpr double kMargin = 1e-6;  // more than the rounding error of floats
    const auto* disk = std::get_if<DiskSurface>(&surface.surface.equation);
    const RasterState& raster = surface.draw.raster;
    return {.kind = kind_of(surface.surface),
            .inside = surface.surface.inside,
            .sector = disk && std::abs(disk->sweep_deg) < 360,
            .tex_coord = surface.surface.textured && plan.effects.has_texture(),
            .near_far = !std::ranges::all_of(
                corners, [](const glm::dvec4& c) { return std::abs(c.z) < c.w * (1 - kMargin) && c.w > 0; }),
            .culls = raster.cull_enabled,
            .depth = raster.depth_test,
            .offset = raster.depth_test && raster.polygon_offset.fill,
            .nearest = most_points(surface.surface) == 1 || points_of(surface.draw) == Points::kNearest};
}

}  // namespace

std::vector<SurfaceProgram> surface_programs(const Draw& draw, const PlanOptions& options) {
    std::vector<SurfaceProgram> programs;
    if (draw.raster.cull_enabled && draw.raster.cull_face == kGL_FRONT_AND_BACK) return programs;
    for (SurfaceDraw& surface : surface_draws(draw)) {
        const std::vector<glm::dvec4> corners =
            clip_corners(surface.surface, surface.draw.clip_from_eye * surface.draw.eye_from_object);
        const std::optional<Rectangle> rectangle = window_rectangle(draw.raster.viewport, corners);
        if (!rectangle) continue;
        SurfaceProgram program;
        program.plan = plan_effects(surface.draw, options, surface.facts);
        program.code = code_for(surface.draw, program.plan, form_of(surface, program.plan, corners));
        // The normals of fragments are scaled to length 1 anyway.
        if (program.code.effects.shading == Shading::kPhong) program.code.effects.normalize = false;
        Uniforms numbers =
            SurfaceUniforms(surface, uniforms(surface.draw, program.plan, program.code)).build(*rectangle);
        const int passes = program.code.form.surface.nearest || points_of(draw) == Points::kFarthest
                               ? 1
                               : most_points(surface.surface);
        for (int point = 0; point < passes; ++point) {
            numbers.set("u_point_number", {static_cast<float>(point)});
            program.passes.push_back(numbers);
        }
        RasterState& raster = surface.draw.raster;
        raster.cull_enabled = false;
        raster.clip_planes_eye = {};
        raster.polygon_offset = {};
        program.draw = std::move(surface.draw);
        programs.push_back(std::move(program));
    }
    return programs;
}

}  // namespace twinlight::programmable
