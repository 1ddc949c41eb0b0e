// The rule about surfaces whose backs are seen and lit as if they were their fronts.
#include <algorithm>
#include <cmath>

#include "base/text/translation.h"
#include "judge/lint/seen.h"
#include "render/reference/vertices/draw_lighting.h"

namespace twinlight::lint {

namespace {

using reference::StageVertex;

// How much of the picture a triangle covers, from 0 to 1; 0 if it is partly behind the eye.
double share_of_picture(const std::array<const StageVertex*, 3>& corners) {
    std::array<glm::dvec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec4& clip = corners[i]->position_clip;
        if (clip.w <= 0) return 0;
        p[i] = glm::clamp(glm::dvec2(clip) / clip.w, -1.0, 1.0);
    }
    const glm::dvec2 a = p[1] - p[0], b = p[2] - p[0];
    return std::abs(a.x * b.y - a.y * b.x) / 2 / 4;
}

// Back faces in view that get no light, while their normals, turned around, would get much.
class BackSeen : public Watch {
    struct Back {
        TriangleNumber number;
        glm::dvec4 center_clip;
        double share;  // of the picture
    };
    struct Object {
        const Draw* first = nullptr;
        std::vector<Back> backs{};
    };

    void finish(const Frame& frame, bool) override {
        const std::vector<const Draw*> draws = frame.draws();
        std::map<std::pair<int, int>, Object> objects;  // by line and column
        for (std::size_t d = 0; d < draws.size(); ++d) {
            const Draw& draw = *draws[d];
            if (!draws_polygons(draw.mode) || draw.draws_borders() || !uses_normals(draw) || is_flattened(draw) ||
                draw.lighting.light_model.two_side)
                continue;
            Object& object = objects[{draw.place.line, draw.place.column}];
            if (!object.first) object.first = &draw;
            add_backs(draw, d, object.backs);
        }
        std::optional<SeenPoints> seen;
        for (auto& [place, object] : objects) {
            if (object.backs.empty()) continue;
            if (!seen) seen.emplace(frame);
            if (is_clear(object.backs, *seen)) report(*object.first);
        }
    }

    static void add_backs(const Draw& draw, std::size_t number, std::vector<Back>& backs) {
        const reference::DrawLighting lighting(draw, false);
        const std::vector<StageVertex> vertices = reference::vertex_stage(draw);
        const std::vector<Triangle> triangles = triangles_of(draw);
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            std::array<const StageVertex*, 3> corners{};
            glm::dvec4 center_clip(0);
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = &vertices[triangles[t][i]];
                center_clip += corners[i]->position_clip / 3.0;
            }
            const double share = share_of_picture(corners);
            if (share > 0 && is_back_with_light(draw, lighting, corners))
                backs.push_back({{number, t}, center_clip, share});
        }
    }
    // Whether the largest of the faces that are shown cover a part of the picture that everyone sees.
    static bool is_clear(std::vector<Back>& backs, const SeenPoints& seen) {
        constexpr double kClear = 0.01;
        constexpr std::size_t kTries = 500;
        const std::size_t tries = std::min(backs.size(), kTries);
        std::partial_sort(backs.begin(), backs.begin() + static_cast<std::ptrdiff_t>(tries), backs.end(),
                          [](const Back& a, const Back& b) { return a.share > b.share; });
        double sum = 0;
        for (std::size_t i = 0; i < tries && sum < kClear; ++i)
            if (seen.shows(backs[i].number, backs[i].center_clip)) sum += backs[i].share;
        return sum >= kClear;
    }
    void report(const Draw& draw) {
        const std::string call = "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);";
        warn({.place = draw.place,
              .message =
                  tr("the back of this surface is seen, but its normals point away from the viewer, so no light from "
                     "this side reaches it"),
              .fix = tr("{} or, if only this side is seen, turn the normals around", call),
              .edits = {{.place = draw.place, .insert = call}},
              .key = "back"});
    }

    static bool is_back_with_light(const Draw& draw, const reference::DrawLighting& lighting,
                                   const std::array<const StageVertex*, 3>& corners) {
        for (const StageVertex* corner : corners) {
            if (corner->position_eye.w == 0) return false;
            const glm::dvec3 p = glm::dvec3(corner->position_eye) / corner->position_eye.w;
            const glm::dvec3 to_eye = to_viewer(draw, p);
            constexpr double kGrazing = 0.2;
            if (!(glm::dot(to_eye, corner->normal_eye) < -kGrazing * glm::length(to_eye))) return false;
            const auto color = [&](double side) {
                const reference::Colors lit =
                    lighting.lit(corner->position_eye, side * corner->normal_eye,
                                 lighting.material(*corner, reference::Face::kFront), reference::Face::kFront);
                return glm::clamp(glm::dvec3(lit.primary + lit.secondary), 0.0, 1.0);
            };
            const glm::dvec3 lost = color(-1) - color(1);
            if (!(std::max({lost.r, lost.g, lost.b}) > 0.25)) return false;
        }
        return true;
    }
};

}  // namespace

std::vector<Rule> back_side_rules() {
    return {
        {"back-seen",
         "The back of a surface is seen, such as the inside of an open cylinder, but lighting is one-sided. It is "
         "dark, "
         "although the light is on this side.",
         "Section 2.14.1: without `GL_LIGHT_MODEL_TWO_SIDE` both faces have the front's normal and colour. With it, "
         "back "
         "faces get the reversed normal.",
         "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);",
         R"(// the view
// the light
+glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
 glRotatef(-60, 1, 0, 0);
 GLUquadric* tube = gluNewQuadric();
 gluCylinder(tube, 1.2, 1.5, 1.2, 40, 10);
)",
         make_watch<BackSeen>,
         {"no-depth-test", "normals-turned", "normals-face-away", "light-inside", "winding-against-normals",
          "back-material-one-sided", "normal-missing", "normal-stale", "one-normal", "normal-array-off"}},
    };
}

}  // namespace twinlight::lint
