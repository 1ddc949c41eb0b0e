// Rules about matrices, the camera, depth and clearing.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text/translation.h"
#include "judge/lint/watch.h"
#include "scene/command/text.h"

namespace twinlight::lint {

namespace {

bool is_perspective(const Command& command) {
    return is_effect(command, "perspective") || is_effect(command, "frustum");
}

class ProjectionInModelview : public Watch {
    void after(const Command& command, const State& state) override {
        if (!is_perspective(command) || state.attributes().matrix_mode != kGL_MODELVIEW) return;
        warn({.place = command.place,
              .message = tr("{} changes the modelview matrix: glMatrixMode is GL_MODELVIEW", command.name()),
              .fix = tr("glMatrixMode(GL_PROJECTION); before it, glMatrixMode(GL_MODELVIEW); after it"),
              .edits = {{.place = command.place, .insert = "glMatrixMode(GL_PROJECTION);"},
                        {.place = command.place, .insert = "glMatrixMode(GL_MODELVIEW);", .is_after = true}}});
    }
};

class CameraInProjection : public Watch {
  public:
    void after(const Command& command, const State& state) override {
        if (state.attributes().matrix_mode != kGL_PROJECTION) return;
        if (is_effect(command, "load_identity")) pending_ = {};
        if (is_effect(command, "look_at")) pending_ = command.place;
    }
    void drawn(const Draw& draw, const State&) override {
        if (pending_.line == 0 || (enabled_lights(draw).empty() && !draw.fog.enabled)) return;
        warn({.place = pending_,
              .message = tr(
                  "gluLookAt changes the projection matrix: lights and fog then see another camera than the objects"),
              .fix = tr("glMatrixMode(GL_MODELVIEW); before it"),
              .edits = {{.place = pending_, .insert = "glMatrixMode(GL_MODELVIEW);"}},
              .key = "camera"});
        pending_ = {};
    }

  private:
    Place pending_;
};

class ProjectionNotReset : public Watch {
    void before(const Command& command, const State& state) override {
        if (!is_perspective(command) || state.attributes().matrix_mode != kGL_PROJECTION) return;
        if (state.projection()[2][3] == 0) return;  // no perspective yet
        warn({.place = command.place,
              .message = tr("{} is multiplied to a perspective that is already there", command.name()),
              .fix = tr("glLoadIdentity(); before it"),
              .edits = {{.place = command.place, .insert = "glLoadIdentity();"}}});
    }
};

// Objects that are squeezed, because the aspect of gluPerspective is not that of the viewport.
class AspectOfViewport : public Watch {
  public:
    void start(const CommandList* list) override { knows_viewport_ = list && list->window; }
    void after(const Command& command, const State&) override {
        if (is_effect(command, "viewport")) knows_viewport_ = true;
        if (is_effect(command, "perspective")) perspective_ = command;
    }
    void drawn(const Draw& draw, const State&) override {
        const Rectangle& viewport = draw.raster.viewport;
        if (draw.pixels || !perspective_ || !knows_viewport_ || viewport.width <= 0 || viewport.height <= 0) return;
        if (!is_its_projection(draw.clip_from_eye) || !keeps_proportions(draw.eye_from_object)) return;
        const double aspect = perspective_->number(1), right = static_cast<double>(viewport.width) / viewport.height;
        constexpr double kVisible = 1.03;  // less is hardly seen; 1.3 for 4/3 is 1.026
        if (std::max(aspect / right, right / aspect) < kVisible) return;
        const auto number = [&](int i) { return fmt::format("{:.9g}", perspective_->number(i)); };
        const std::string call = fmt::format("gluPerspective({}, {}.0 / {}, {}, {});", number(0), viewport.width,
                                             viewport.height, number(2), number(3));
        const bool is_integer_division = aspect == std::floor(right);
        warn({.place = perspective_->place,
              .message = tr("the picture is squeezed: the aspect of gluPerspective is {:.4g}, but the viewport "
                            "has {} x {} pixels, which is {:.4g}",
                            aspect, viewport.width, viewport.height, right),
              .fix = is_integer_division ? tr("{} or, where integers are divided, (double)width / height", call) : call,
              .edits = {{.place = perspective_->place, .removes = true, .insert = call}}});
    }

  private:
    // Whether the projection is gluPerspective's, and nothing else.
    bool is_its_projection(const glm::dmat4& clip_from_eye) const {
        const double aspect = perspective_->number(1);
        if (!(aspect > 0) || clip_from_eye[2][3] != -1) return false;
        for (int row = 0; row < 2; ++row)
            for (int column = 0; column < 4; ++column)
                if (row != column && clip_from_eye[column][row] != 0) return false;
        return std::abs(clip_from_eye[0][0] * aspect / clip_from_eye[1][1] - 1) < 1e-6;
    }
    // Whether the modelview matrix scales all directions alike; another one may make up for the aspect.
    static bool keeps_proportions(const glm::dmat4& eye_from_object) {
        const glm::dmat3 m(eye_from_object);
        const double length = glm::length(m[0]);
        for (int i = 0; i < 3; ++i) {
            if (std::abs(glm::length(m[i]) - length) > 0.01 * length) return false;
            if (std::abs(glm::dot(m[i], m[(i + 1) % 3])) > 0.01 * length * length) return false;
        }
        return length > 0;
    }

    std::optional<Command> perspective_;  // the last one
    bool knows_viewport_ = false;
};

class NearPlane : public Watch {
    void after(const Command& command, const State&) override {
        if (!is_perspective(command)) return;
        const bool has_angle = is_effect(command, "perspective");  // else its near plane sets the angle, too
        const std::size_t near_at = has_angle ? 2 : 4;
        const double z_near = command.arguments[near_at], z_far = command.arguments[near_at + 1];
        if (z_near > 0 && z_far / z_near < 2e6) return;
        Command nearer = command;
        nearer.arguments[near_at] = z_far / 1000;
        std::vector<Edit> edits;
        if (has_angle) edits = {{.place = command.place, .removes = true, .insert = print_command(nearer)}};
        warn({.place = command.place,
              .message = z_near <= 0
                             ? tr("the near plane of {} is {}: depths cannot be distinguished", command.name(), z_near)
                             : tr("the far plane is {:.2g} times as far as the near plane: depths far "
                                  "away cannot be distinguished",
                                  z_far / z_near),
              .fix = tr("put the near plane as far away as possible, at least at a thousandth of the far plane"),
              .edits = std::move(edits)});
    }
};

class EmptyDepthRange : public Watch {
    void drawn(const Draw& draw, const State&) override {
        if (draw.raster.depth_near != draw.raster.depth_far || !draw.raster.depth_test || place_.line == 0) return;
        warn({.place = place_,
              .message = tr("glDepthRange maps all depths to {}, so the depth test cannot compare objects",
                            draw.raster.depth_near),
              .fix = "glDepthRange(0, 1);",
              .edits = {{.place = place_, .removes = true, .insert = "glDepthRange(0, 1);"}}});
    }
    void after(const Command& command, const State&) override {
        if (is_effect(command, "depth_range")) place_ = command.place;
    }
    Place place_;
};

// glClear of colour but not of depth, between depth-tested Draws.
class DepthNotCleared : public Watch {
  public:
    void after(const Command& command, const State& state) override {
        if (!is_effect(command, "clear")) return;
        const Enum mask = command.enumerant(0);
        if (mask & kGL_DEPTH_BUFFER_BIT) {
            is_clean_ = state.raster().depth_mask;
            pending_ = {};
        } else if ((mask & kGL_COLOR_BUFFER_BIT) && !is_clean_) {
            pending_ = command.place;
            mask_ = mask;
        }
    }
    void redrawn(const Redraw& redraw) override {
        if (redraw.shows_first(Redraw::Buffer::kDepth)) {
            Warning warning =
                not_cleared(redraw, kGL_DEPTH_BUFFER_BIT,
                            tr("the depth buffer is not cleared: the first picture hides parts of the second"));
            warning.key = "clear";
            warn(std::move(warning));
        }
    }
    void drawn(const Draw& draw, const State&) override {
        if (!draw.raster.depth_test || draw.raster.depth_func == kGL_ALWAYS) return;
        is_clean_ = false;
        if (pending_.line == 0) return;
        const std::string call = fmt::format("glClear({} | GL_DEPTH_BUFFER_BIT);", bit_names(mask_));
        warn({.place = pending_,
              .message =
                  tr("the depth buffer is not cleared: the depth test compares with the depths of the picture before"),
              .fix = call,
              .edits = {{.place = pending_, .removes = true, .insert = call}},
              .key = "clear"});
        pending_ = {};
    }

  private:
    bool is_clean_ = false;
    Place pending_;
    Enum mask_ = 0;
};

class ClearMasked : public Watch {
    void after(const Command& command, const State& state) override {
        if (!is_effect(command, "clear") || !(command.enumerant(0) & kGL_DEPTH_BUFFER_BIT) || state.raster().depth_mask)
            return;
        warn({.place = command.place,
              .message = tr("this glClear does not clear the depth buffer: glDepthMask(GL_FALSE) is in force"),
              .fix = tr("glDepthMask(GL_TRUE); before it"),
              .edits = {{.place = command.place, .insert = "glDepthMask(GL_TRUE);"}}});
    }
};

// pi, pi/2, pi/3, pi/4 or pi/6, to the digits that people type.
bool is_part_of_pi(double angle) {
    return std::ranges::any_of(std::array{1.0, 2.0, 3.0, 4.0, 6.0},
                               [&](double part) { return std::abs(std::abs(angle) - std::numbers::pi / part) < 1e-3; });
}

class Radians : public Watch {
    void after(const Command& command, const State&) override {
        const bool is_rotation = is_effect(command, "rotate") && is_part_of_pi(command.number(0));
        const bool is_view = is_effect(command, "perspective") && command.number(0) > 0 && command.number(0) < 3.2;
        if (!is_rotation && !is_view) return;
        Command in_degrees = command;
        in_degrees.arguments[0] = std::round(command.number(0) * 180 / std::numbers::pi * 100) / 100;
        warn({.place = command.place,
              .message = tr("{} is given an angle of {:.5g}: angles are in degrees, and this looks like radians",
                            command.name(), command.number(0)),
              .fix = print_command(in_degrees),
              .edits = {{.place = command.place, .removes = true, .insert = print_command(in_degrees)}}});
    }
};

class NoAxis : public Watch {
    void after(const Command& command, const State&) override {
        if (!is_effect(command, "rotate") || command.number(0) == 0) return;
        if (command.number(1) != 0 || command.number(2) != 0 || command.number(3) != 0) return;
        warn({.place = command.place,
              .message = tr("glRotate has the axis (0, 0, 0), so the rotation is undefined"),
              .fix = tr("give an axis, such as glRotatef(angle, 0, 1, 0)")});
    }
};

}  // namespace

std::vector<Rule> view_rules() {
    return {
        {"projection-in-modelview",
         "`gluPerspective` or `glFrustum` is called while `glMatrixMode` is `GL_MODELVIEW`. Lights, normals and fog "
         "are then computed in a distorted space.",
         "Section 2.11.2: these commands multiply the current matrix. Section 2.14.1: lighting happens in eye "
         "coordinates, which the modelview matrix makes.",
         "glMatrixMode(GL_PROJECTION); gluPerspective(...); glMatrixMode(GL_MODELVIEW);",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glEnable(GL_DEPTH_TEST);
+glMatrixMode(GL_PROJECTION);
 gluPerspective(45, 4.0 / 3.0, 1, 100);
+glMatrixMode(GL_MODELVIEW);
 gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
// the light
 glEnable(GL_NORMALIZE);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ProjectionInModelview>},
        {"camera-in-projection",
         "`gluLookAt` is called while `glMatrixMode` is `GL_PROJECTION`. The objects are in the right place, but "
         "lights, highlights and fog see a camera at the origin.",
         "Section 2.11.2 and 2.14.1: eye coordinates come from the modelview matrix only.",
         "glMatrixMode(GL_MODELVIEW); gluLookAt(...);",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glEnable(GL_DEPTH_TEST);
-glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});
 glMatrixMode(GL_PROJECTION);
 gluPerspective(45, 4.0 / 3.0, 1, 100);
+glMatrixMode(GL_MODELVIEW);
 gluLookAt(5, 2, 3,  0, 0, 0,  0, 1, 0);
-glMatrixMode(GL_MODELVIEW);
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<CameraInProjection>},
        {"projection-not-reset",
         "A perspective is multiplied by one that is already there, as when `glLoadIdentity` is missing from a reshape "
         "function.",
         "Section 2.11.2: `gluPerspective` and `glFrustum` multiply the current matrix; they do not replace it.",
         "glLoadIdentity();",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glEnable(GL_DEPTH_TEST);
 glMatrixMode(GL_PROJECTION);
 gluPerspective(45, 1, 1, 100);
+glLoadIdentity();
 gluPerspective(45, 4.0 / 3.0, 1, 100);
 glMatrixMode(GL_MODELVIEW);
 gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
// the light
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ProjectionNotReset>},
        {"aspect-of-viewport",
         "The aspect of `gluPerspective` is not that of the viewport. The picture is squeezed: a ball looks like an "
         "egg. "
         "Often `width / height` is an integer division, which drops the fraction.",
         "Section 2.11.1: the viewport stretches the view volume to its own width and height.",
         "gluPerspective(45, (double)width / height, 1, 100);",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glEnable(GL_DEPTH_TEST);
 int width = 160, height = 120;
 glViewport(0, 0, width, height);
 glMatrixMode(GL_PROJECTION);
-gluPerspective(45, width / height, 1, 100);
+gluPerspective(45, (double)width / height, 1, 100);
 glMatrixMode(GL_MODELVIEW);
 gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
// the light
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<AspectOfViewport>},
        {"near-plane",
         "The near plane of `gluPerspective` or `glFrustum` is at 0, or very much nearer than the far plane. All "
         "depths are almost "
         "the same, and near objects do not hide far ones.",
         "Section 2.11.1: depths are divided by the distance; their precision at distance z is about z * z / near "
         "times that of the depth buffer.",
         "gluPerspective(45, 4.0 / 3.0, 1, 100);",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glEnable(GL_DEPTH_TEST);
 glMatrixMode(GL_PROJECTION);
-gluPerspective(45, 4.0 / 3.0, 0, 100);
+gluPerspective(45, 4.0 / 3.0, 1, 100);
 glMatrixMode(GL_MODELVIEW);
 gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
// the light
 glEnable(GL_COLOR_MATERIAL);
 glColor3f(1, 0.4, 0.3);
 glutSolidSphere(1.2, 40, 20);
 glColor3f(0.3, 0.5, 1);
 glTranslatef(1, 0, -3);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<NearPlane>},
        {"depth-range-empty", "`glDepthRange` maps all depths to one number. The depth test cannot compare objects.",
         "Section 2.11.1: depths are mapped from near to far; if both are the same, so are all depths.",
         "glDepthRange(0, 1);",
         R"(// the view
// the light
-glDepthRange(0.5, 0.5);
+glDepthRange(0, 1);
 glEnable(GL_COLOR_MATERIAL);
 glDepthFunc(GL_LEQUAL);
 glColor3f(1, 0.4, 0.3);
 glutSolidSphere(1.2, 40, 20);
 glColor3f(0.3, 0.5, 1);
 glTranslatef(1, 0, -3);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<EmptyDepthRange>},
        {"depth-not-cleared",
         "The depths are not cleared before objects are drawn with the depth test. Objects of the previous picture "
         "hide them.",
         "Section 4.2.3: `glClear` clears only the buffers that it names.",
         "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);",
         R"(// the view
// the light
 glutSolidSphere(1.5, 40, 20);
-glClear(GL_COLOR_BUFFER_BIT);
+glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glTranslatef(0.6, 0, -1.5);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<DepthNotCleared>,
         {"colors-not-cleared"}},
        {"clear-masked",
         "`glClear` should clear the depths, but `glDepthMask(GL_FALSE)` is in force. They stay as they are.",
         "Section 4.2.3: masks apply to clearing, too.", "glDepthMask(GL_TRUE);",
         R"(// the view
// the light
 glutSolidSphere(1.5, 40, 20);
 glDepthMask(GL_FALSE);
+glDepthMask(GL_TRUE);
 glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
-glDepthMask(GL_TRUE);
 glTranslatef(0.6, 0, -1.5);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ClearMasked>},
        {"angle-in-radians", "An angle is given in radians. GL's angles are in degrees, so it is almost 0.",
         "Section 2.11.2: the angle of `glRotate` is in degrees, and so is that of `gluPerspective`.", "write degrees",
         R"(// the view
// the light
-glRotatef(M_PI / 4, 0, 1, 0);
+glRotatef(45, 0, 1, 0);
 glutSolidCube(2);
)",
         make_watch<Radians>},
        {"rotate-no-axis", "`glRotate` has the axis (0, 0, 0). The rotation is undefined.",
         "Section 2.11.2: the axis is divided by its length.", "glRotatef(angle, 0, 1, 0);",
         R"(// the view
// the light
-glRotatef(45, 0, 0, 0);
+glRotatef(45, 0, 1, 0);
 glutSolidCube(2);
)",
         make_watch<NoAxis>},
    };
}

}  // namespace twinlight::lint
