#include "app/web/page_world.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "app/session/overlays.h"
#include "base/math/directions.h"
#include "render/reference/copied_pixels.h"

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
        // Toward the middle, as its light goes.
        const glm::dvec3 toward = world.around.middle_world - light.place_world;
        marks.line(light.place_world, light.place_world + 1.4 * arrow_length(world) * unit(toward), color);
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
    marks.name(fmt::format("GL_LIGHT{}", light.number), light.place_world, kAbovePixels);
}

}  // namespace

webgl::WebglFrame PageWorld::frame(const session::Session& session) {
    // The view stays where it is while things move.
    const bool is_same = opened_ == session.opened;
    opened_ = session.opened;
    world_ = world_of(commands(session), session.scene.frame, is_same ? std::optional(world_.around) : std::nullopt);
    if (!is_same) camera_ = first_camera(world_);
    projection_ = projection_of(world_, camera_, session.width, session.height);

    Frame seen = as_seen_from_outside(session.scene.frame, world_, projection_);
    Draw lines = marks(kGL_LINES, world_lines(world_, projection_), projection_);
    lines.raster.depth_test = true;
    seen.items.emplace_back(std::move(lines));
    Marks marks(projection_, seen);
    if (world_.camera_world) {
        marks.point(*world_.camera_world, kCameraPixels, kCameraColor);
        marks.name("camera", *world_.camera_world, kAbovePixels);
    }
    for (std::size_t i = world_.lights.size(); i-- > 0;) add_light(marks, world_, i);  // the first on top
    marks.draw();
    const Look look{.shading = Shading::kPhong};
    const DrawableFrame drawable = reference::drawable(seen, {look});
    return webgl::webgl_frame(*drawable, {look, /*budget=*/0});
}

void PageWorld::press(const session::Session& session, int x, int y) {
    drag_ = {camera_, handle_at(world_, projection_, {x, y}, kReachPixels), session.history.now(), session.scene.frame,
             world_};
}

void PageWorld::drag(session::Session& session, int dx, int dy) {
    if (!drag_.handle) {
        camera_ = drag_.camera;
        orbit(camera_, dx, dy);
        return;
    }
    const int light = drag_.world.lights[drag_.handle->light].number;
    edit(session, with_handle_moved(*drag_.commands, drag_.frame, drag_.world, projection_, *drag_.handle, {dx, dy}),
         fmt::format("{} GL_LIGHT{}", drag_.handle->is_spot_direction ? "turn" : "move", light),
         fmt::format("light {}", light));
}

}  // namespace twinlight::web
