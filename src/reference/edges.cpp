// The pixels where two right rasterisers may choose different triangles (DESIGN, "Edges").
//
// A pixel is interior when one surface fills its whole square and wins the depth test all over it. So it is
// an edge pixel where
//   - the border of what is seen there passes through its square, or
//   - anything else touches its square that is not certainly hidden by what is seen there: a neighbouring
//   facet, a
//     silhouette in front, a surface that cuts this one or lies as deep, a line or point and the pixels
//     around it.
#include <glm/common.hpp>

#include "reference/reference.h"
#include "reference/visibility.h"

namespace twinlight::reference {

namespace {

// Rasterisers snap vertices to a grid, llvmpipe's and most GPUs' is 1/256 pixel; the square grows by that much.
constexpr double kSnap = 1.0 / 256;
constexpr double kHalfSquare = 0.5 + kSnap;
// Lines and points may choose the pixel beside (3.4.1 allows a line to be off by one).
constexpr double kHalfLineSquare = 1.5;
// Two depths that a buffer of 24 bits may hold as the same number, each rounded.
constexpr double kDepthQuantum = 2.0 / (1 << 24);

struct Interval {
    double low = 0, high = 0;
};

// The depths of a piece over the square about a pixel's centre. A line's or point's own are widened by its slope.
Interval depths(const Piece& piece, const glm::dvec2& centre, double half_width) {
    const double depth = depth_at(piece, centre);
    double change = 0;
    if (piece.shape == Shape::kTriangle)
        change = half_width * (std::abs(piece.depth_plane.x) + std::abs(piece.depth_plane.y));
    if (piece.shape == Shape::kLine) {
        const glm::dvec3 d = glm::abs(piece.to.position_window - piece.from.position_window);
        change = 2 * half_width * d.z / std::max({d.x, d.y, 1.0});
    }
    return {depth - change, depth + change};
}

enum class Outcome { kPasses, kFails, kOpen };

// Whether every depth of `incoming` passes against every depth of `stored`.
Outcome depth_outcome(Enum depth_func, const Interval& incoming, const Interval& stored) {
    const bool nearer = incoming.high + kDepthQuantum < stored.low;
    const bool farther = incoming.low - kDepthQuantum > stored.high;
    if (depth_func == kGL_ALWAYS) return Outcome::kPasses;
    if (depth_func == kGL_NEVER) return Outcome::kFails;
    if (!nearer && !farther) return Outcome::kOpen;
    // Equality is out of the question now: one comparison of the two intervals stands for all.
    return depth_passes(depth_func, nearer ? -1 : 1, 0) ? Outcome::kPasses : Outcome::kFails;
}

// Whether `later` overwrites `earlier` in the whole square.
Outcome overwrites(const Stages& stages, const Piece& later, const Piece& earlier, const glm::dvec2& centre,
                   double half_width) {
    const RasterState& raster = stages.draw_of(later).raster;
    if (!raster.depth_test) return Outcome::kPasses;
    const RasterState& before = stages.draw_of(earlier).raster;
    if (!before.depth_test || !before.depth_mask) return Outcome::kOpen;  // it left no depth to compare with
    return depth_outcome(raster.depth_func, depths(later, centre, half_width), depths(earlier, centre, half_width));
}

// Whether the piece `id`, which touches the square, is certainly not seen in it, for `seen` hides it.
bool hidden(const Stages& stages, StepId id, StepId seen, const glm::dvec2& centre, double half_width) {
    const std::size_t number = static_cast<std::size_t>(id);
    if (seen < 0) return number < stages.pieces_before_clear[static_cast<std::size_t>(-1 - seen)];
    const Piece &piece = stages.piece(id), &other = stages.piece(seen);
    if (id < seen) return overwrites(stages, other, piece, centre, half_width) == Outcome::kPasses;
    return overwrites(stages, piece, other, centre, half_width) == Outcome::kFails;
}

enum class Touch { kNo, kInside, kBorder };

// How a polygon meets the square about `centre`, which is known to meet its bounding box. Edges along the
// sides of the view volume are no border: every rasteriser has them at the viewport's rim.
Touch touch(const std::vector<Edge>& edges, const glm::dvec2& centre) {
    Touch result = Touch::kInside;
    for (const Edge& edge : edges) {
        const double side = edge.side(centre), reach = edge.reach(kHalfSquare);
        if (side < -reach) return Touch::kNo;
        if (side <= reach && edge.origin() != EdgeOrigin::kSide) result = Touch::kBorder;
    }
    return result;
}

class EdgeFinder {
  public:
    EdgeFinder(const Stages& stages, const VisibleRows& rows) : stages_(stages), rows_(rows), edge_(rows.step.size()) {}

    void polygon(StepId id) {
        const Piece& piece = stages_.piece(id);
        const PixelRect box = bounds(piece.corners, window(), kSnap);
        if (box.y0 >= box.y1 || box.x0 >= box.x1) return;
        const std::vector<Edge> edges = edges_of(piece.corners);
        if (edges.size() < 2) return;
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) {
                if (edge_[rows_.index(x, y)]) continue;
                const Touch how = touch(edges, pixel_centre(x, y));
                if (how == Touch::kNo) continue;
                const StepId seen = rows_.step[rows_.index(x, y)];
                if (seen == id ? how == Touch::kBorder : !hidden(stages_, id, seen, pixel_centre(x, y), kHalfSquare))
                    edge_[rows_.index(x, y)] = true;
            }
    }

    // Lines and points: the pixels that they cover and those around.
    void thin(StepId id) {
        const PixelRect around{-1, rows_.y0 - 1, rows_.width + 1, rows_.y1 + 1};
        for_each_pixel(stages_.piece(id), around, [&](int px, int py) {
            for (int y = py - 1; y <= py + 1; ++y)
                for (int x = px - 1; x <= px + 1; ++x) {
                    if (!window().contains(x, y)) continue;
                    const StepId seen = rows_.step[rows_.index(x, y)];
                    if (seen == id || !hidden(stages_, id, seen, pixel_centre(x, y), kHalfLineSquare))
                        edge_[rows_.index(x, y)] = true;
                }
        });
    }

    bool edge(int x, int y) const { return edge_[rows_.index(x, y)]; }

  private:
    PixelRect window() const { return {0, rows_.y0, rows_.width, rows_.y1}; }

    const Stages& stages_;
    const VisibleRows& rows_;
    std::vector<char> edge_;
};

}  // namespace

PixelMask edge_pixels(const Frame& frame) {
    const Stages stages = run_stages(frame, QuadCut::kFirstToThird);
    // Bytes, not bits: bands write beside each other.
    std::vector<char> mask(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
    for_each_band(frame.height, [&](int y0, int y1) {
        const VisibleRows rows = visible_rows(stages, frame.width, y0, y1);
        EdgeFinder finder(stages, rows);
        for (std::size_t i = 0; i < stages.pieces.size(); ++i) {
            const StepId id = static_cast<StepId>(i);
            stages.pieces[i].shape == Shape::kTriangle ? finder.polygon(id) : finder.thin(id);
        }
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < frame.width; ++x)
                mask[static_cast<std::size_t>(frame.height - 1 - y) * static_cast<std::size_t>(frame.width) +
                     static_cast<std::size_t>(x)] = finder.edge(x, y);
    });
    return {mask.begin(), mask.end()};
}

}  // namespace twinlight::reference
