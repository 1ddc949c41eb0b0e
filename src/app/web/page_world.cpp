#include "app/web/page_world.h"

#include <utility>
#include <vector>

#include "app/session/overlays.h"
#include "render/reference/copied_pixels.h"
#include "scene/command/names.h"

namespace twinlight::web {

namespace {

using session::LightMarker;
using session::OverlayVertex;

constexpr double kLinePixels = 2, kLampPixels = 15, kTipPixels = 9, kCameraPixels = 9;
constexpr double kAbovePixels = 20;  // from a lamp to its name
constexpr double kReachPixels = 24;  // of a press: 28 pixels of a phone across, for a finger
constexpr glm::vec4 kCameraColor{0.94F, 0.7F, 0.28F, 1};

Draw marks(Enum mode, const std::vector<OverlayVertex>& places, const session::WorldProjection& projection) {
    Draw draw;
    draw.mode = mode;
    for (const OverlayVertex& place : places) {
        Vertex vertex;
        vertex.position_object = place.position_clip;
        vertex.color = place.color;
        draw.vertices.edit().push_back(vertex);
    }
    draw.raster.line_width = kLinePixels;
    draw.raster.viewport = {0, 0, projection.width, projection.height};
    return draw;
}

// The marks of lights and the camera, as they are added.
class Marks {
  public:
    Marks(const session::WorldProjection& projection, Frame& frame) : projection_(projection), frame_(frame) {}

    void line(const glm::dvec3& a_world, const glm::dvec3& b_world, const glm::vec4& color) {
        lines_.push_back(mark(a_world, color));
        lines_.push_back(mark(b_world, color));
    }
    void point(const glm::dvec3& place_world, double pixels, const glm::vec4& color) {
        Draw draw = marks(kGL_POINTS, {mark(place_world, color)}, projection_);
        draw.raster.point_size = pixels;
        draw.raster.point_smooth = true;
        draw.fragment.blend = true;
        draw.fragment.blend_src = draw.fragment.blend_src_alpha = kGL_SRC_ALPHA;
        draw.fragment.blend_dst = draw.fragment.blend_dst_alpha = kGL_ONE_MINUS_SRC_ALPHA;
        points_.push_back(std::move(draw));
    }
    void name(const std::string& text, const glm::dvec3& place_world, double above) {
        if (const auto place = projection_.place_of(place_world))
            frame_.labels.push_back(
                {text, {place->x / projection_.width, 1 - (place->y - above) / projection_.height}});
    }
    // Puts them over the frame.
    void draw() {
        if (!lines_.empty()) frame_.items.emplace_back(marks(kGL_LINES, lines_, projection_));
        for (Draw& point : points_) frame_.items.emplace_back(std::move(point));
    }

  private:
    OverlayVertex mark(const glm::dvec3& place_world, const glm::vec4& color) const {
        return {glm::vec4(projection_.clip_from_world * glm::dvec4(place_world, 1)), color};
    }

    const session::WorldProjection& projection_;
    Frame& frame_;
    std::vector<OverlayVertex> lines_{};
    std::vector<Draw> points_{};
};

void add_light(Marks& marks, const session::World& world, std::size_t number) {
    const LightMarker& light = world.lights[number];
    const glm::vec4 color(glm::vec3(light.color), 1);
    if (light.is_directional) {
        marks.line(light.place_world, arrow_tip(world, light), color);
    }
    if (light.cutoff_deg) {
        const std::vector<glm::dvec3> rim = cone_rim(light, arrow_length(world));
        for (std::size_t i = 0; i < rim.size(); ++i) {
            marks.line(rim[i], rim[(i + 1) % rim.size()], color);
            if (i % 4 == 0) marks.line(light.place_world, rim[i], color);
        }
        const glm::dvec3 tip = place_of(world, session::Handle{number, true});
        marks.line(light.place_world, tip, color);
        marks.point(tip, kTipPixels, color);
    }
    marks.point(light.place_world, kLampPixels, color);
    marks.name(light_name(light.number), light.place_world, kAbovePixels);
}

}  // namespace

webgl::WebglFrame PageWorld::frame(const session::Session& session) {
    view_.follow(session);
    const session::World& world = view_.world;
    Frame seen = as_seen_from_outside(session.scene.frame, world, view_.projection);
    Draw lines = marks(kGL_LINES, world_lines(world, view_.projection), view_.projection);
    lines.raster.depth_test = true;
    seen.items.emplace_back(std::move(lines));
    Marks marks(view_.projection, seen);
    if (world.camera_world) {
        marks.point(*world.camera_world, kCameraPixels, kCameraColor);
        marks.name("camera", *world.camera_world, kAbovePixels);
    }
    for (std::size_t i = world.lights.size(); i-- > 0;) add_light(marks, world, i);  // the first on top
    marks.draw();
    const Look look{.shading = Shading::kPhong};
    const DrawableFrame drawable = reference::drawable(seen, {look});
    return webgl::webgl_frame(*drawable, {look, /*budget=*/0});
}

void PageWorld::press(const session::Session& session, int x, int y) {
    before_ = view_.camera;
    drag_.reset();
    if (const auto handle = handle_at(view_.world, view_.projection, {x, y}, kReachPixels))
        drag_.emplace(session, view_.world, *handle);
}

void PageWorld::drag(session::Session& session, int dx, int dy) {
    if (drag_) return carry_out(session, *drag_, view_.projection, {dx, dy});
    view_.camera = before_;
    orbit(view_.camera, dx, dy);
}

}  // namespace twinlight::web
