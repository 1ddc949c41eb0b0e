// Primitives in window coordinates: viewport and depth range (2.11.1), facing (2.14.1), culling (3.5.1), polygon mode
// (3.5.4), polygon offset (3.5.5), the widths of lines and points (3.4.2.1, 3.3).
//
// In: a Draw's stage vertices and primitives. Out: Pieces for the rasteriser: clipped polygons, lines and points. A
// piece gives, at any window position, the depth and the perspective-correct weights of its primitive's vertices.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "render/reference/geometry/clip.h"
#include "render/reference/geometry/primitive_assembly.h"
#include "render/reference/textures/comparison.h"
#include "render/reference/vertices/draw_lighting.h"
#include "render/reference/vertices/vertex_stage.h"
#include "scene/frame/copied_texels.h"

namespace twinlight::reference {

// One point of a piece.
struct WindowVertex {
    glm::dvec3 position_window{0};
    glm::dvec3 weights_over_w{0};  // linear in window coordinates; their ratios are the weights (3.4.1, 3.5.1)
};

struct Corner {
    glm::dvec2 position_window{0};
    EdgeOrigin edge_to_next = EdgeOrigin::kInner;

    friend bool operator==(const Corner&, const Corner&) = default;
};

// The corners of a convex polygon, counter-clockwise (y up). Most pieces are whole triangles, and a mesh has millions
// of them, so three corners need no memory of their own.
class Corners {
  public:
    Corners() = default;
    explicit Corners(const std::vector<Corner>& corners);

    std::size_t size() const { return more_ ? more_->size() : count_; }
    Corner operator[](std::size_t i) const { return more_ ? (*more_)[i] : Corner{positions_window_[i], edges_[i]}; }
    glm::dvec2 position_window(std::size_t i) const {
        return more_ ? (*more_)[i].position_window : positions_window_[i];
    }

    friend bool operator==(const Corners& a, const Corners& b);

  private:
    static constexpr std::size_t kFew = 3;

    std::array<glm::dvec2, kFew> positions_window_{};
    std::array<EdgeOrigin, kFew> edges_{};
    std::uint8_t count_ = 0;
    std::shared_ptr<const std::vector<Corner>> more_{};  // all of them, if there are more than three
};

// How a filled polygon's values change over the window: each value at (x, y) is c.x * x + c.y * y + c.z.
struct Planes {
    std::array<glm::dvec3, 3> weight_over_w{};
    glm::dvec3 depth{0};
};

// Where a line begins and ends. A point uses only `from`.
struct Ends {
    WindowVertex from{}, to{};
};

class SurfaceRays;  // surface_rays.h

struct Piece {
    Primitive primitive;
    Face face = Face::kFront;
    std::uint32_t draw = 0;  // index of the Draw in the frame

    bool is_perhaps_clipped = false;  // see InClipPlane
    bool is_smooth = false;           // a line or point that coverage_of() blends
    std::uint8_t stipple_doubt = 0;   // of a line: by how much drivers may count stipple_from differently

    Shape shape = Shape::kPoint;  // how it is drawn: a triangle may be drawn as lines or points
    int size = 1;                 // the width of a line, the side of a point's square; in pixels
    double sprite_size = 0;       // 3.3.1: of a point sprite, whose side need not be whole; 0 for other pieces
    Corners corners{};            // of a polygon, or of the outline of a smooth line or point
    std::variant<Ends, Planes> place{};

    // For a surface: the number of the visible point at a pixel; each point has its own face. The pieces of a surface
    // follow each other in the order of their points.
    std::shared_ptr<const SurfaceRays> rays{};
    int point = 0;
    // For a stippled line: the stipple counter, extended to coordinate 0 of the line's longer axis (3.4.2).
    int stipple_from = 0;

    // For lines and points; for polygons. Asking a piece of the other kind is a mistake.
    const Ends& ends() const { return *std::get_if<Ends>(&place); }
    const Planes& planes() const { return *std::get_if<Planes>(&place); }
};

// Whether this face is culled (3.5.1).
bool culled(const RasterState& raster, Face face);

// 2.11.1: the viewport and the depth range.
glm::dvec3 window_from_ndc(const RasterState& raster, const glm::dvec3& ndc);

// 3.3 and 3.4.2.1: widths of lines and sizes of points without smoothing are rounded to whole pixels, at least 1.
int whole_pixels(double width);

// 3.5.5: the offset added to depths. `slope`: the change of depth per pixel in x and y. `mode`: how the polygon is
// drawn.
double polygon_offset(const RasterState& raster, Enum mode, const glm::dvec2& slope);

// Appends the pieces of one Draw, in the order of its primitives. A filled polygon that cannot cover a pixel's centre, wherever
// Options::border moves it, has none.
void add_pieces(const Draw& draw, std::uint32_t draw_index, std::span<const VertexPosition> positions,
                const Options& options, std::vector<Piece>& pieces, const CopyRanges* ranges = nullptr);

// 3.4.2: which fragment of its strip or loop a line has at a pixel, counted from 0.
int stipple_count(const Piece& line, int x, int y);
constexpr int kAnyCount = 255;  // Piece::stipple_doubt: any count is possible

// Appends the pieces of a shape's exact surfaces. Only their rays show which fragments there are.
void add_surface_pieces(const Draw& draw, std::uint32_t draw_index, std::vector<Piece>& pieces);

// Depth and weights of a mesh's piece at a window position; for a line or point at its nearest place. The sum of the
// weights is 1.
double depth_at(const Piece& piece, const glm::dvec2& position_window);
glm::dvec3 weights_at(const Piece& piece, const glm::dvec2& position_window);

// A quantity that is linear in the window, with its change per pixel in x and y. On a line it changes only along the
// line, on a point not at all.
struct Linear3 {
    glm::dvec3 value{0}, per_x{0}, per_y{0};
};
// The weights before division by their sum.
Linear3 weights_over_w_at(const Piece& piece, const glm::dvec2& position_window);

}  // namespace twinlight::reference
