// Which pixels a piece covers (3.3, 3.4.1, 3.5.1). In: a Piece. Out: one call per pixel, with the window coordinates of
// its lower left corner, y up.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render/reference/geometry/piece.h"
#include "render/reference/geometry/surface_rays.h"

namespace twinlight::reference {

// A rectangle of pixels; the upper bounds are excluded.
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    bool is_empty() const { return x0 >= x1 || y0 >= y1; }
    bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
    // For arrays with one element per pixel, row by row from y0 up.
    std::size_t count() const { return static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0); }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(x1 - x0) + static_cast<std::size_t>(x - x0);
    }
};

inline glm::dvec2 pixel_centre(int x, int y) { return {x + 0.5, y + 0.5}; }

// The pixels whose squares, enlarged by `margin`, meet the polygon's bounding box.
PixelRect bounds(const Corners& polygon, const PixelRect& within, double margin);

// The pixels where the surface may be visible.
PixelRect bounds(const SurfaceRays& rays, const PixelRect& within);

// A rectangle around the pixels that the piece may touch in any correct picture.
PixelRect reach_of(const Piece& piece, const PixelRect& within);

// Rows of pixels; the upper bound is excluded.
struct PixelRows {
    int y0 = 0, y1 = 0;
    bool meets(const PixelRect& rect) const { return y0 < rect.y1 && rect.y0 < y1; }
};
// Rows outside which a piece has no fragment and opens no pixel (allowed_difference.cpp). `border`: Options::border. Cheaper to
// compare than the piece's corners, once for each band of rows.
PixelRows rows_of(const Piece& piece, double border);

// One edge of a counter-clockwise polygon.
class Edge {
  public:
    Edge(const Corner& from, const Corner& to);

    // The cross product of the edge and the vector from its start to `p`: positive inside. Polygons that share the edge
    // in opposite directions get exactly opposite values, because both compute it from the same end.
    double side(const glm::dvec2& p) const { return sign_ * (way_.x * (p.y - start_.y) - way_.y * (p.x - start_.x)); }
    // RULING (3.5.1: a centre on a common edge belongs to exactly one polygon, but not to which): left and bottom edges
    // are inside, as in llvmpipe.
    bool covers(const glm::dvec2& centre) const {
        const double s = side(centre);
        return s > 0 || (s == 0 && owns_centres_);
    }
    // The largest change of side() within a square of this half width about a point.
    double reach(double half_width) const { return half_width * (std::abs(way_.x) + std::abs(way_.y)); }
    EdgeOrigin origin() const { return origin_; }

  private:
    glm::dvec2 start_, way_;
    double sign_;
    bool owns_centres_;
    EdgeOrigin origin_;
};

// The edges with a direction; fewer than two if the polygon is a point.
std::vector<Edge> edges_of(const Corners& polygon);

// The fragments of a line, in their order along it. Width 1 follows the diamond exit rule; wider lines repeat each
// fragment across the line (3.4.2.1).
std::vector<std::pair<int, int>> line_pixels(const glm::dvec2& from_window, const glm::dvec2& to_window, int width,
                                             const PixelRect& within);

// The square of a point (3.3): centred on the pixel that contains it if the size is odd, or on the nearest corner of a
// pixel if the size is even.
PixelRect point_square(const glm::dvec2& position_window, int size, const PixelRect& within);
// The pixels whose centres lie in a point sprite's square (3.3.1). RULING: those on its left and lower sides do, as with polygons.
PixelRect sprite_square(const glm::dvec2& position_window, double size, const PixelRect& within);
// Of either.
PixelRect square_of(const Piece& point, const PixelRect& within);

// 3.3, 3.4.2: the share of the pixel's square that a smooth line or point covers, which its alpha is multiplied by
// (3.11). 3.2 lets drivers compute another share for squares that are partly covered.
double coverage_of(const Piece& piece, int x, int y);
// The pixels where that is above 0.
std::vector<std::pair<int, int>> smooth_pixels(const Piece& piece, const PixelRect& within);

// Calls visit(x, y) for each pixel.
template <class Visit>
void for_each(const PixelRect& rect, const Visit& visit) {
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x) visit(x, y);
}

// Calls fragment(x, y) for every pixel of `within` that a mesh's piece covers.
template <class Fragment>
void for_each_pixel(const Piece& piece, const PixelRect& within, const Fragment& fragment) {
    if (piece.is_smooth) {
        for (const auto& [x, y] : smooth_pixels(piece, within)) fragment(x, y);
        return;
    }
    switch (piece.shape) {
        case Shape::kPoint: for_each(square_of(piece, within), fragment); break;
        case Shape::kLine:
            for (const auto& [x, y] : line_pixels(glm::dvec2(piece.ends().from.position_window),
                                                  glm::dvec2(piece.ends().to.position_window), piece.size, within))
                fragment(x, y);
            break;
        case Shape::kTriangle: {
            const PixelRect box = bounds(piece.corners, within, 0);
            if (box.is_empty()) break;
            const std::vector<Edge> edges = edges_of(piece.corners);
            if (edges.size() < 2) break;
            for_each(box, [&](int x, int y) {
                if (std::all_of(edges.begin(), edges.end(),
                                [&](const Edge& edge) { return edge.covers(pixel_centre(x, y)); }))
                    fragment(x, y);
            });
            break;
        }
        case Shape::kSurface: break;
    }
}

// Calls fragment(x, y, number, point) for every visible point of a surface at the pixels of `within`.
template <class Fragment>
void for_each_point(const Piece& piece, const PixelRect& within, const Fragment& fragment) {
    for_each(bounds(*piece.rays, within), [&](int x, int y) {
        int number = 0;
        for (const RayPoint& point : piece.rays->points(pixel_centre(x, y))) fragment(x, y, number++, point);
    });
}

}  // namespace twinlight::reference
