#include "render/programmable/numbers/surface_values.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "render/effect/surface_draw.h"
#include "render/programmable/numbers/program_uniforms.h"

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

struct WindowRectangle {  // window coordinates
    glm::dvec2 low{0}, high{0};
};

// The surface lies inside this rectangle, which includes a margin of one pixel for float rounding. Nothing if the
// rectangle is outside the viewport.
std::optional<WindowRectangle> window_rectangle(const Rectangle& viewport, const std::vector<glm::dvec4>& corners) {
    const glm::dvec2 origin(viewport.x, viewport.y), size(viewport.width, viewport.height);
    WindowRectangle rectangle{origin + size, origin};
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
    SurfaceUniforms(const SurfaceDraw& surface, const SurfaceForm& form, const WindowRectangle& rectangle,
                    Uniforms uniforms)
        : surface_(surface.surface),
          draw_(surface.draw),
          form_(form),
          rectangle_(rectangle),
          uniforms_(std::move(uniforms)) {}

    Uniforms build() {
        set_rays();
        values_of_surface(form_).for_each([&](SurfaceValue value) {
            uniforms_.add(declaration_of(value).name);
            put(value);
        });
        return std::move(uniforms_);
    }

  private:
    // These append to the uniform that was added last.
    void put(double value) { uniforms_.push_back(to_float(value)); }
    template <int kLength>
    void put(const glm::vec<kLength, double>& v) {
        for (int i = 0; i < kLength; ++i) put(v[i]);
    }

    // The ray through a window position goes through two points: h, the point that projects to (x_ndc, y_ndc, z) for
    // some z, and the preimage of the depth direction: the eye, or a point at infinity.
    void set_rays() {
        middle_window_ = glm::floor((rectangle_.low + rectangle_.high) / 2.0) + 0.5;
        // The z of the surface's middle, so that h is close to it.
        const glm::dvec4 middle_clip = clip_from_surface_[3];
        const double z = middle_clip.w > 0 ? std::clamp(middle_clip.z / middle_clip.w, -1.0, 1.0) : -1;
        h_ = surface_from_clip_ * glm::dvec4(ndc(middle_window_), z, 1);
        const glm::dvec2 size(draw_.raster.viewport.width, draw_.raster.viewport.height);
        per_x_ = surface_from_clip_[0] * (2 / size.x);
        per_y_ = surface_from_clip_[1] * (2 / size.y);
        unit_ = 1 / glm::length(direction(h_));
    }
    glm::dvec2 ndc(const glm::dvec2& window) const {
        const Rectangle& viewport = draw_.raster.viewport;
        const glm::dvec2 origin(viewport.x, viewport.y), size(viewport.width, viewport.height);
        return (window - origin) / size * 2.0 - 1.0;
    }
    glm::dvec3 direction(const glm::dvec4& at) const { return glm::dvec3(depth_) * at.w - glm::dvec3(at) * depth_.w; }
    glm::dvec3 moment(const glm::dvec4& at) const { return glm::cross(glm::dvec3(at), glm::dvec3(depth_)); }

    // Clip coordinates have no unit; this one makes w about 1.
    double clip_unit() const {
        const glm::dvec4 w = glm::abs(glm::transpose(clip_from_surface_)[3]);
        return 1 / std::max({w.x, w.y, w.z, w.w, std::numeric_limits<double>::min()});
    }

    glm::dvec4 clip_row(int i) const { return clip_unit() * glm::transpose(clip_from_surface_)[i]; }

    // 2.14.1: seen with its outward normal towards the eye, a surface is counter-clockwise, unless a matrix mirrors it.
    // Clip coordinates are left-handed.
    double front_side() const {
        const double determinant = glm::determinant(draw_.eye_from_object) * glm::determinant(draw_.clip_from_eye);
        const bool turned = (draw_.raster.front_face == kGL_CW) != surface_.inside;
        return (determinant > 0) != turned ? 1 : -1;
    }

    void put(SurfaceValue value) {
        const RasterState& raster = draw_.raster;
        constexpr double kDepthStep = 1.0 / (1 << 24);  // r of section 3.5.5, for a 24-bit depth buffer
        switch (value) {
            case SurfaceValue::kRectangleNdc: return put(glm::dvec4(ndc(rectangle_.low), ndc(rectangle_.high)));
            case SurfaceValue::kMiddleWindow: return put(middle_window_);
            case SurfaceValue::kDirection: return put(unit_ * direction(h_));
            case SurfaceValue::kDirectionPerX: return put(unit_ * direction(per_x_));
            case SurfaceValue::kDirectionPerY: return put(unit_ * direction(per_y_));
            case SurfaceValue::kMoment: return put(unit_ * moment(h_));
            case SurfaceValue::kMomentPerX: return put(unit_ * moment(per_x_));
            case SurfaceValue::kMomentPerY: return put(unit_ * moment(per_y_));
            // w - z and w + z are 0 on the far and near plane. They are uniforms, because the difference of floats would
            // be inexact.
            case SurfaceValue::kClipW: return put(clip_row(3));
            case SurfaceValue::kToNearPlane: return put(clip_row(3) + clip_row(2));
            case SurfaceValue::kToFarPlane: return put(clip_row(3) - clip_row(2));
            case SurfaceValue::kFarDepth: return put(raster.depth_far);
            case SurfaceValue::kHalfDepthRange: return put((raster.depth_far - raster.depth_near) / 2);
            case SurfaceValue::kStepX: return put(1 / clip_unit() * per_x_);
            case SurfaceValue::kStepY: return put(1 / clip_unit() * per_y_);
            case SurfaceValue::kStepDepth: return put(1 / clip_unit() * depth_);
            case SurfaceValue::kOffsetFactor: return put(raster.polygon_offset.factor);
            case SurfaceValue::kOffset: return put(raster.polygon_offset.units * kDepthStep);
            case SurfaceValue::kFrontSide: return put(front_side());
            case SurfaceValue::kShownSide: return put(raster.cull_face == kGL_BACK ? front_side() : -front_side());
            case SurfaceValue::kPointNumber: return put(0);  // of the first pass
            case SurfaceValue::kRadius:
                if (const auto* sphere = std::get_if<SphereSurface>(&surface_.equation)) return put(sphere->radius);
                return put((frustum().base + frustum().top) / 2);
            case SurfaceValue::kSlope: return put((frustum().top - frustum().base) / frustum().height);
            case SurfaceValue::kHalfHeight: return put(frustum().height / 2);
            case SurfaceValue::kInner: return put(disk().inner);
            case SurfaceValue::kOuter: return put(disk().outer);
            case SurfaceValue::kDiskSide: return put(disk().faces_up ? 1 : -1);
            case SurfaceValue::kTube: return put(std::get<TorusSurface>(surface_.equation).tube);
            case SurfaceValue::kRing: return put(std::get<TorusSurface>(surface_.equation).ring);
            case SurfaceValue::kSector: {
                const double half = std::min(std::abs(disk().sweep_deg) / 2, 180.0) * std::numbers::pi / 180;
                const double middle = (disk().start_deg + disk().sweep_deg / 2) * std::numbers::pi / 180;
                return put(glm::dvec4(std::sin(middle), std::cos(middle), std::sin(half), std::cos(half)));
            }
        }
    }
    const DiskSurface& disk() const { return std::get<DiskSurface>(surface_.equation); }
    const FrustumSurface& frustum() const { return std::get<FrustumSurface>(surface_.equation); }

    const Surface& surface_;
    const Draw& draw_;
    const SurfaceForm& form_;
    const WindowRectangle rectangle_;
    const glm::dmat4 clip_from_surface_ = draw_.clip_from_eye * draw_.eye_from_object;
    const glm::dmat4 surface_from_clip_ = glm::inverse(draw_.eye_from_object) * glm::inverse(draw_.clip_from_eye);
    const glm::dvec4 depth_ = surface_from_clip_[2];
    glm::dvec2 middle_window_{0};
    glm::dvec4 h_{0};                 // of the middle of the rectangle
    glm::dvec4 per_x_{0}, per_y_{0};  // how it changes per pixel
    double unit_ = 1;                 // makes the direction through h_ a vector of length 1
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
        const std::optional<WindowRectangle> rectangle = window_rectangle(draw.raster.viewport, corners);
        if (!rectangle) continue;
        SurfaceProgram program;
        program.plan = plan_effects(surface.draw, options, surface.facts);
        program.code = code_for(surface.draw, program.plan, form_of(surface, program.plan, corners));
        // The normals of fragments are scaled to length 1 anyway.
        if (program.code.effects.shading == Shading::kPhong) program.code.effects.normalize = false;
        const SurfaceForm& form = program.code.form.surface;
        Uniforms numbers =
            SurfaceUniforms(surface, form, *rectangle, uniforms(surface.draw, program.plan, program.code)).build();
        const int passes = form.nearest || points_of(draw) == Points::kFarthest ? 1 : most_points(surface.surface);
        for (int point = 0; point < passes; ++point) {
            if (!form.nearest)
                numbers.set(declaration_of(SurfaceValue::kPointNumber).name, {static_cast<float>(point)});
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
