// Overlays: what can be drawn over a picture of a scene, as vertices in clip coordinates. Uses no GL.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "render/effect/plan.h"
#include "scene/frame/frame.h"

namespace twinlight::session {

struct OverlayVertex {
    glm::vec4 position_clip;
    glm::vec4 color;
};

// What is drawn over one Draw of the frame, in its viewport and depth range.
struct DrawOverlay {
    Rectangle viewport{};
    double depth_near = 0, depth_far = 1;
    bool hides = false;  // its faces hide what is behind them

    // The Draw's triangles, three vertices each. `edges` has an element for each vertex: whether the edge from it to the next
    // vertex of its triangle is a border of a primitive, as the cuts of quadrilaterals and polygons are not.
    std::vector<glm::vec4> faces_clip{};
    std::vector<std::uint8_t> edges{};

    std::vector<OverlayVertex> tints{};  // some of the faces
    std::vector<OverlayVertex> marks{};  // triangles that are parts of faces
    // Triangles that cover the faces, or points. The alpha of a vertex is half its largest channel, at most 1: where it exceeds
    // 0.5, a channel exceeds 1.
    std::vector<OverlayVertex> brightness{}, point_brightness{};
    std::vector<OverlayVertex> lines{};  // two vertices each
    std::vector<OverlayVertex> points{};
};

// Text at a place of the picture: in pixels from the top left.
struct Label {
    glm::dvec2 place;
    std::string text;
    bool is_warning = false;
};

struct OverlayPicture {
    Wireframe wireframe = Wireframe::kOff;
    glm::vec4 background{0, 0, 0, 1};  // of a wireframe that replaces the picture
    std::vector<DrawOverlay> draws{};
    std::vector<Label> labels{};
};

bool any(const Overlays& overlays);

// The overlays of a frame. `plan_options` are those of the shaders whose lights are named.
//
// Wireframe: the borders of all primitives.
// Normals: a line from each vertex, as long as the normal that lights it, in thirtieths of the scene's radius. A normal whose
//     length is 1 is green, any other is red, and a label says how long those of its shape are. Unlit shapes have none, unless
//     nothing is lit.
// Provoking vertices: the corner of each primitive that belongs to the vertex whose colour flat shading takes (2.14.7).
// Back faces: tinted, where culling leaves them.
// Above 1: where a channel of the primary or secondary colour exceeds 1 before the clamp (2.14.6), at the vertices; for
//     lighting per pixel also between them, every 12 pixels.
// Kept lights: a label at the middle of each lit shape.
OverlayPicture overlays_of(const Frame& frame, const Overlays& overlays, const PlanOptions& plan_options);

}  // namespace twinlight::session
