// One pixel or vertex of a scene: every lighting term with its numbers, as data, as text and as JSON.
//
// The numbers are the reference's. What the renderers give there is the caller's to add, where it is wanted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/image/difference.h"
#include "base/text/json.h"
#include "render/look.h"
#include "render/path.h"
#include "render/reference/pixel_history.h"
#include "scene/frame/scene.h"

namespace twinlight::explain {

struct Pixel {
    int x = 0, y = 0;  // from the top left corner of the picture
};
struct VertexOfDraw {
    std::size_t draw = 0, vertex = 0;  // both count from 0
};

// The colour that a renderer gives.
struct Rendered {
    Path renderer = Path::kReference;
    Rgba color{};
};

// What correct renderers may draw at a pixel: AllowedDifference's.
struct AllowedPixel {
    bool edge = false;
    Rgba channels{};                     // what a channel may be off by, away from edges
    std::vector<Why> why{};              // why it is at an edge, or a channel may be off
    std::string undefined{};             // why OpenGL leaves the colour undefined; "" if it does not
    std::vector<AllowedRange> ranges{};  // at an edge; none: any colour
};

struct PixelExplanation {
    Pixel pixel{};
    Look look{};
    reference::PixelHistory history{};      // the fragments that cover the pixel, and the reference's colour
    std::vector<Rendered> rendered{};       // the caller's; may stay empty
    std::optional<AllowedPixel> allowed{};  // the caller's
};
PixelExplanation explain_pixel(const Frame& frame, const Look& look, const Pixel& pixel);

struct FaceExplanation {
    reference::VertexHistory history{};
    std::vector<Rendered> rendered{};  // the caller's, of picture_of(); may stay empty
};
struct VertexExplanation {
    VertexOfDraw vertex{};
    Look look{};
    std::vector<FaceExplanation> faces{};  // front and back with two-sided lighting, else front
};
// Lit as GL lights vertices. The Draw must have lighting enabled.
VertexExplanation explain_vertex(const Frame& frame, const Look& look, const VertexOfDraw& vertex);

// A picture of one pixel that shows the vertex as a point, so that each renderer can light it: the projection moves it
// to the middle, and only lighting is left of the state. Points show the front, so the back face becomes the front.
Frame picture_of(const Draw& draw, std::uint32_t vertex, reference::Face face);

// The index of the last fragment that hides all earlier ones; 0 if no fragment does.
std::size_t first_seen(const Frame& frame, const std::vector<reference::PixelFragment>& fragments);
// Where surfaces have almost the depth of the one that shows, rounding decides which one does: a sentence that names their draws.
// Empty where none have it.
std::string almost_one_depth(const Frame& frame, const std::vector<reference::PixelFragment>& fragments);
// What happens to the lit colour before blending: "after clamping, texture (3.8), fog (3.10)".
std::string steps_after_lighting(const reference::PixelFragment& fragment, const Draw& draw, bool lecture_variants);

struct TextOptions {
    bool all = false;       // also what the scene does not use
    bool in_color = false;  // with a terminal's codes for bold
    bool calls = false;     // the chain of calls to each draw of a recorded program
};
std::string text_of(const Scene& scene, const PixelExplanation& explanation, const TextOptions& options);
std::string text_of(const Scene& scene, const VertexExplanation& explanation, const TextOptions& options);
Json json_of(const Scene& scene, const PixelExplanation& explanation);
Json json_of(const Scene& scene, const VertexExplanation& explanation);

}  // namespace twinlight::explain
