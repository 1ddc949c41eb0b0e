// The pixels where correct implementations may differ, and by how much (docs/edges.md).
//
// Draws the fragments of the picture again, but with all values that they may have where a rasteriser rounds positions:
//   - coverage: a polygon certainly covers the pixel's centre, or its border passes beside it;
//   - depth: an interval; if it overlaps the stored one, the outcome of the depth test is open;
//   - colour: an interval per channel.
// A pixel becomes open if a fragment may or may not change its colour, and then has several colours. It becomes certain again if a
// fragment certainly overwrites it. Pixels that are open at the end are edge pixels.
#include "render/reference/allowed_difference.h"

#include <climits>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "render/reference/fragment_loop.h"
#include "render/reference/geometry/points_around.h"
#include "render/reference/geometry/texture_place.h"
#include "render/reference/reference.h"
#include "render/reference/undefined_colors.h"

namespace twinlight::reference {

namespace {

// Lines and points may cover the neighbouring pixel instead (3.4.1 allows lines to be off by one).
constexpr double kHalfLineSquare = 1.5;

// Whether both are the same triangle with the same clipping; polygon offsets may differ.
bool same_triangle(const Piece& a, const Piece& b) {
    if (a.shape != Shape::kTriangle || b.shape != Shape::kTriangle) return false;
    const Planes &p = a.planes(), &q = b.planes();
    return a.corners == b.corners && p.weight_over_w == q.weight_over_w && p.depth.x == q.depth.x &&
           p.depth.y == q.depth.y;
}

// Whether a polygon covers the centre of a pixel, wherever the borders are that may be off by this much: certainly, perhaps, or not. The
// square of that size about the centre must meet the polygon's bounding box. Edges along the sides of the view volume do not count:
// all rasterisers have them at the viewport's border.
Outcome covers(const std::vector<Edge>& edges, const glm::dvec2& centre, double border) {
    Outcome result = Outcome::kPasses;
    for (const Edge& edge : edges) {
        const double side = edge.side(centre), reach = edge.reach(border);
        if (side < -reach) return Outcome::kFails;
        if (side <= reach && edge.origin() != EdgeOrigin::kSide) result = Outcome::kOpen;
    }
    return result;
}

// The place on the line from a to b that is nearest to p.
glm::dvec2 nearest_on(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    const glm::dvec2 way = b - a;
    const double square = glm::dot(way, way);
    return square > 0 ? a + std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) * way : a;
}

// The place in the polygon that is nearest to p. The polygon has three corners or more.
glm::dvec2 nearest_in(const Corners& polygon, const glm::dvec2& p) {
    bool is_inside = true;
    glm::dvec2 nearest = polygon.position_window(0);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 from = polygon.position_window(i),
                         to = polygon.position_window(i + 1 < polygon.size() ? i + 1 : 0);
        const glm::dvec2 way = to - from, to_p = p - from, on = nearest_on(from, to, p);
        is_inside = is_inside && way.x * to_p.y - way.y * to_p.x >= 0;
        if (glm::distance(on, p) < glm::distance(nearest, p)) nearest = on;
    }
    return is_inside ? p : nearest;
}

bool has_texture(const Draw& draw) { return draw.texture.texture || !draw.further_units.empty(); }

// Whether the values of a line's fragments differ from one end to the other.
bool changes_along(const Piece& line, const Draw& draw) {
    if (has_texture(draw) || draw.fog.enabled) return true;
    if (draw.raster.depth_test && line.ends().from.position_window.z != line.ends().to.position_window.z) return true;
    if (draw.lighting.shade_model == kGL_FLAT) return false;
    const glm::dvec4& color = draw.vertices[line.primitive.vertices[0]].color;
    const std::size_t corners = draws_polygons(draw.mode) ? 3 : 2;
    for (std::size_t i = 1; i < corners; ++i)
        if (draw.vertices[line.primitive.vertices[i]].color != color) return true;
    return draw.lighting.enabled;
}

// 3.4.1 interpolates at the fragment's centre, which may lie beyond the line's ends: the line with more of it at both. Nothing where
// that reaches the eye, or if the line is so short that rounding decides what lies beyond.
std::optional<Piece> longer(const Piece& line, double reach) {
    constexpr double kShortest = 1e-3, kNearest = 1e-3;
    const Ends& ends = line.ends();
    const glm::dvec3 way = ends.to.position_window - ends.from.position_window;
    const double length = std::max(std::abs(way.x), std::abs(way.y));
    if (length < kShortest) return std::nullopt;
    const auto beyond = [&](const WindowVertex& end, const WindowVertex& other) {
        const double share = reach / length;
        return WindowVertex{end.position_window + share * (end.position_window - other.position_window),
                            end.weights_over_w + share * (end.weights_over_w - other.weights_over_w)};
    };
    const auto one_over_w = [](const WindowVertex& end) {
        return end.weights_over_w.x + end.weights_over_w.y + end.weights_over_w.z;
    };
    const Ends extended{beyond(ends.from, ends.to), beyond(ends.to, ends.from)};
    const double least = kNearest * std::min(one_over_w(ends.from), one_over_w(ends.to));
    if (!(std::min(one_over_w(extended.from), one_over_w(extended.to)) > least)) return std::nullopt;
    Piece result = line;
    result.place = extended;
    return result;
}

// The way along a line that changes the longer of x and y by 1.
glm::dvec2 pixel_along(const Ends& ends) {
    const glm::dvec2 way = ends.to.position_window - ends.from.position_window;
    const double longer = std::max(std::abs(way.x), std::abs(way.y));
    return longer > 0 ? way / longer : glm::dvec2(1, 0);
}

// How far from the centre a line's colour may be taken, along its longer axis: 3.4.1 takes the place on the line that is nearest to the
// centre, and drivers measure along that axis.
double reach_along(const Ends& ends, const glm::dvec2& centre) {
    constexpr double kRounding = 0.5;
    const glm::dvec2 from(ends.from.position_window), way = glm::dvec2(ends.to.position_window) - from;
    const double square = glm::dot(way, way);
    const int axis = std::abs(way.x) >= std::abs(way.y) ? 0 : 1;
    const glm::dvec2 nearest = square > 0 ? from + glm::dot(centre - from, way) / square * way : from;
    return kRounding + std::abs(nearest[axis] - centre[axis]);
}

// Calls visit(way) for the corners of a square.
template <class Visit>
void for_each_around(double half, const Visit& visit) {
    for (const double x : {-half, half})
        for (const double y : {-half, half}) visit(glm::dvec2(x, y));
}

// The state of a pixel besides its colour: an interval of depths, a stencil value, and whether it is open.
class OpenPixels {
  public:
    using Real = Interval;

    OpenPixels(const StagedFrame& stages, const PixelRect& window)
        : stages_(stages),
          window_(window),
          open_(window.count()),
          why_(window.count()),
          undefined_(window.count()),
          drawn_(window.count()),
          depth_(window.count()),
          depth_of_(window.count()),
          thin_(window.count(), kNobody) {}

    bool is_open(std::size_t at) const { return open_[at] != kSettled; }
    bool is_unknown(std::size_t at) const { return open_[at] == kUnknown; }
    bool is_undefined(std::size_t at) const { return undefined_[at] != 0; }
    Whys why(std::size_t at) const { return why_[at]; }
    void open(std::size_t at, Whys why) {
        open_[at] = std::max(open_[at], kOpen);
        why_[at] |= why;
    }
    void open_to_any(std::size_t at, Whys why) {
        open_[at] = kUnknown;
        why_[at] |= why;
    }
    void leave_undefined(std::size_t at) { undefined_[at] = 1; }
    void settle(std::size_t at) {
        open_[at] = kSettled;
        why_[at] = 0;
        undefined_[at] = 0;
    }
    // Whether any piece certainly or perhaps covers the pixel.
    bool is_drawn(std::size_t at) const { return drawn_[at] != 0; }

    // The points of a surface that may be seen as this piece's fragment at the pixel.
    std::span<const RayPoint> points(const Piece& piece, int x, int y) const {
        return around(piece, x, y).lit(piece.point);
    }

    // A facet smaller than a pixel has the colours between its own vertices, not those of its plane beyond them.
    Nearby nearby(const Piece& piece, int x, int y) const {
        const glm::dvec2 centre = pixel_centre(x, y);
        const Draw& draw = stages_.draw_of(piece);
        Nearby result;
        const auto add = [&](const glm::dvec2& place) { result.places.push_back(place); };
        if (piece.shape == Shape::kTriangle) {
            const double border = stages_.border;
            for_each_around(border, [&](const glm::dvec2& way) { add(nearest_in(piece.corners, centre + way)); });
            for (std::size_t i = 0; i < piece.corners.size(); ++i) {
                const glm::dvec2 corner = piece.corners.position_window(i), way = glm::abs(corner - centre);
                if (std::max(way.x, way.y) < border) add(corner);
            }
        } else if (draw.pixels) {
            // It may be another one of its pixels.
            result.has_any_color = piece.is_perhaps_clipped && (has_texture(draw) || !has_one_color(piece.draw));
        } else if (piece.shape == Shape::kLine && changes_along(piece, draw)) {
            const double reach =
                piece.is_smooth ? kHalfLineSquare + 1 + piece.size / 2.0 : reach_along(piece.ends(), centre);
            result.piece = longer(piece, reach);
            result.has_any_color = !result.piece || has_texture(draw);
            constexpr int kSteps = 4;  // to each side: fog grows to both sides of the eye's plane
            if (!result.has_any_color)
                for (int i = -kSteps; i <= kSteps; ++i) add(centre + reach * i / kSteps * pixel_along(piece.ends()));
        } else if (piece.sprite_size > 0) {
            result.has_any_color = has_texture(draw);
        }
        return result;
    }

    template <class Visit>
    void for_each_fragment(StepId id, const PixelRect& within, const Visit& visit_drawn) {
        const Piece& piece = stages_.piece(id);
        const auto visit = [&](StepId step, int x, int y, Outcome how, const RayPoint* point) {
            drawn_[window_.index(x, y)] = 1;
            visit_drawn(step, x, y, how, point);
        };
        if (piece.shape == Shape::kTriangle) return polygon(id, within, visit);
        if (piece.rays) return surface(id, within, visit);
        if (!stages_.draw_of(piece).pixels) return thin(id, within, visit);
        const Outcome how = piece.is_perhaps_clipped ? Outcome::kOpen : Outcome::kPasses;
        for_each_pixel(piece, within, [&](int x, int y) { visit(id, x, y, how, nullptr); });
    }

    // The depths beside the pixel's centre. For lines and points the slope widens the interval.
    Interval depth(const Fragment& fragment) const {
        const Piece& piece = *fragment.piece;
        if (piece.rays) return depth_of_surface(fragment);
        if (piece.shape == Shape::kPoint)
            if (const auto* copied = CopyRanges::of(stages_.ranges, stages_.draw_of(piece).pixels);
                copied && !copied->depths.empty()) {
                if (piece.is_perhaps_clipped) return {0, 1};  // another one of its pixels
                const glm::dvec2& range = copied->depths[piece.primitive.vertices[0]];
                return {range.x, range.y};
            }
        double change = 0;
        if (piece.shape == Shape::kTriangle)
            change = stages_.border * (std::abs(piece.planes().depth.x) + std::abs(piece.planes().depth.y)) +
                     offset_doubt(piece);
        if (piece.shape == Shape::kLine) {
            const glm::dvec3 d = glm::abs(piece.ends().to.position_window - piece.ends().from.position_window);
            change = 2 * kHalfLineSquare * d.z / std::max({d.x, d.y, 1.0});
        }
        return widened(depth_at(piece, fragment.position_window), change);
    }

    Outcome depth_outcome(Enum depth_func, const Fragment& fragment, const Interval& depth, std::size_t at) const {
        const StepId other_id = depth_of_[at];
        if (other_id >= 0) {
            const Piece &piece = *fragment.piece, &other = stages_.piece(other_id);
            if (piece.shape == Shape::kTriangle && other.shape == Shape::kTriangle) {
                const glm::dvec3 between = piece.planes().depth - other.planes().depth;
                // Appendix A: geometry that is drawn twice has the same depths; 3.5.5: r keeps offset depths apart. But
                // a driver may cut a quadrilateral differently depending on flat shading or display lists.
                // Appendix A speaks of the same state. Offsets in another one may have another m.
                const bool same_state = stages_.draw_of(piece).raster == stages_.draw_of(other).raster;
                const double doubt = same_state ? 0 : offset_doubt(piece) + offset_doubt(other);
                if (same_triangle(piece, other) && !is_quadrilaterals(stages_.draw_of(piece))) {
                    if (doubt > 0) return reference::depth_outcome(depth_func, widened(between.z, doubt));
                    // An offset of less than r need not be noticeable.
                    if (between.z != 0 && std::abs(between.z) < kDepthStep) return Outcome::kOpen;
                    return compares(depth_func, between.z, 0) ? Outcome::kPasses : Outcome::kFails;
                }
                const glm::dvec2& centre = fragment.position_window;
                const double change = stages_.border * (std::abs(between.x) + std::abs(between.y)) +
                                      offset_doubt(piece) + offset_doubt(other) + rounding_of_depth(piece, centre) +
                                      rounding_of_depth(other, centre);
                const double difference = depth_at(piece, centre) - depth_at(other, centre);
                return reference::depth_outcome(depth_func, widened(difference, change));
            }
        }
        return reference::depth_outcome(depth_func, depth - depth_[at]);
    }
    const Interval& stored_depth(std::size_t at) const { return depth_[at]; }
    void set_depth(std::size_t at, StepId id, const Interval& depth, Outcome outcome) {
        const bool certain = outcome == Outcome::kPasses;
        depth_[at] = certain ? depth : hull(depth_[at], depth);
        depth_of_[at] = certain ? id : kNobody;
    }

    void clear_stencil(const Clear& clear, std::size_t at) {
        int& stored = stencil(at);
        const bool is_whole = (~clear.stencil_mask & kMaxStencil) == 0;
        if (stored != kAnyValue || is_whole) stored = cleared_stencil(clear, std::max(stored, 0));
    }
    Outcome stencil_outcome(const StencilFace& face, std::size_t at) {
        const int stored = stencil(at);
        const bool ignores = face.func == kGL_ALWAYS || face.func == kGL_NEVER || (face.mask & kMaxStencil) == 0;
        if (stored == kAnyValue && !ignores) return Outcome::kOpen;
        return passes_stencil(face, std::max(stored, 0)) ? Outcome::kPasses : Outcome::kFails;
    }
    // If the operations that may happen lead to different values, the value is open.
    void set_stencil(const StencilFace& face, Outcome covers, Outcome of_stencil, Outcome of_depth, std::size_t at) {
        int& stored = stencil(at);
        std::optional<int> result;
        const auto may_become = [&](int value) { result = result.value_or(value) == value ? value : kAnyValue; };
        const auto may_do = [&](Enum operation) {
            const bool is_whole = (~face.write_mask & kMaxStencil) == 0;
            const bool overwrites = is_whole && (operation == kGL_ZERO || operation == kGL_REPLACE);
            may_become(stored != kAnyValue || overwrites ? stencil_after(face, operation, std::max(stored, 0))
                                                         : kAnyValue);
        };
        if (covers != Outcome::kPasses) may_become(stored);
        if (of_stencil != Outcome::kPasses) may_do(face.fail);
        if (of_stencil != Outcome::kFails && of_depth != Outcome::kPasses) may_do(face.depth_fail);
        if (of_stencil != Outcome::kFails && of_depth != Outcome::kFails) may_do(face.depth_pass);
        stored = *result;
    }
    void open_stencil(std::size_t at) { stencil(at) = kAnyValue; }
    // The stencil value; nothing: any.
    std::optional<int> known_stencil(std::size_t at) const {
        if (stencil_.empty()) return 0;
        return stencil_[at] == kAnyValue ? std::nullopt : std::optional(stencil_[at]);
    }

  protected:
    const StagedFrame& stages() const { return stages_; }

    // What a polygon's depth may be off in floats: those of the corners and of the pixel are rounded, and four times what the slopes
    // change between the window's corner and the pixel: slope, constant, product and sum.
    static double rounding_of_depth(const Piece& piece, const glm::dvec2& position_window) {
        constexpr double kRounding = 0x1p-24;
        const glm::dvec2 change = glm::abs(glm::dvec2(piece.planes().depth) * position_window);
        return kRounding * (2 * std::abs(depth_at(piece, position_window)) + 4 * (change.x + change.y));
    }

    // 3.5.5: by how much a polygon's offset may be another. m may be the larger of |dz/dx| and |dz/dy| or the gradient's length, and
    // it follows from corners that rasterisers round, which matters where a polygon is small or narrow.
    double offset_doubt(const Piece& piece) const {
        const PolygonOffset& offset = stages_.draw_of(piece).raster.polygon_offset;
        if (!offset.fill || offset.factor == 0) return 0;
        const glm::dvec2 gradient(piece.planes().depth);
        const double m = std::max(std::abs(gradient.x), std::abs(gradient.y)), length = glm::length(gradient);
        double twice_area = 0, around = 0;
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
            const glm::dvec2 from = piece.corners.position_window(i),
                             to = piece.corners.position_window(i + 1 < piece.corners.size() ? i + 1 : 0);
            twice_area += from.x * to.y - from.y * to.x;
            around += glm::distance(from, to);
        }
        const double share = std::min(1.0, 2 * stages_.border * around / std::abs(twice_area));
        return std::abs(offset.factor) * (length - m + share * length);
    }

  private:
    static constexpr char kSettled = 0, kOpen = 1, kUnknown = 2;
    // Whether all vertices of the Draw have one colour, as a bitmap's have.
    bool has_one_color(std::uint32_t number) const {
        if (one_color_.empty()) one_color_.resize(stages_.draws.size());
        std::optional<bool>& known = one_color_[number];
        const Draw& draw = *stages_.draws[number].draw;
        if (!known)
            known = !draw.pixels->copied && std::ranges::all_of(draw.vertices, [&](const Vertex& vertex) {
                return vertex.color == draw.vertices[0].color;
            });
        return *known;
    }
    static constexpr StepId kNobody = std::numeric_limits<StepId>::min();
    static constexpr int kAnyValue = -1;

    int& stencil(std::size_t at) {
        if (stencil_.empty()) stencil_.resize(open_.size());
        return stencil_[at];
    }

    template <class Visit>
    void polygon(StepId id, const PixelRect& within, const Visit& visit) const {
        const Piece& piece = stages_.piece(id);
        const PixelRect box = bounds(piece.corners, within, stages_.border);
        if (box.is_empty()) return;
        const std::vector<Edge> edges = edges_of(piece.corners);
        if (edges.size() < 2) return;
        for_each(box, [&](int x, int y) {
            Outcome how = covers(edges, pixel_centre(x, y), stages_.border);
            if (how == Outcome::kPasses && piece.is_perhaps_clipped) how = Outcome::kOpen;
            if (how != Outcome::kFails) visit(id, x, y, how, nullptr);
        });
    }

    // All points of a surface are drawn with its first piece.
    template <class Visit>
    void surface(StepId id, const PixelRect& within, const Visit& visit) const {
        const Piece& piece = stages_.piece(id);
        if (piece.point > 0) return;
        for_each(bounds(*piece.rays, within), [&](int x, int y) {
            const PointsAround& points = around(piece, x, y);
            const Outcome how = points.is_certain() ? Outcome::kPasses : Outcome::kOpen;
            for (int i = 0; i < points.count(); ++i) visit(id + i, x, y, how, &points.points(i).front());
        });
    }
    const PointsAround& around(const Piece& piece, int x, int y) const {
        if (around_rays_ != piece.rays.get() || around_x_ != x || around_y_ != y) {
            around_ = PointsAround(*piece.rays, pixel_centre(x, y));
            around_rays_ = piece.rays.get();
            around_x_ = x;
            around_y_ = y;
        }
        return around_;
    }
    Interval depth_of_surface(const Fragment& fragment) const {
        constexpr double kRoundings = 8 * 0x1p-24;  // where the ray meets it, and its depth
        const Piece& piece = *fragment.piece;
        const glm::ivec2 pixel(glm::floor(fragment.position_window));
        const std::span<const RayPoint> all = around(piece, pixel.x, pixel.y).points(piece.point);
        Interval depth(all.front().depth);
        for (const RayPoint& point : all) depth = hull(depth, point.depth);
        return widened(depth, kRoundings);
    }

    static bool covers_nothing(const Piece& piece) {
        constexpr int kFar = 1 << 24;
        bool covers = false;
        for_each_pixel(piece, reach_of(piece, {-kFar, -kFar, kFar, kFar}), [&](int, int) { covers = true; });
        return !covers;
    }

    // Lines and points: a pixel is certain if the piece covers all its neighbours; other covered pixels and neighbours
    // are open. Smooth ones have neighbours up to two pixels away: 3.2 leaves the coverage to drivers, and in Mesa's it
    // falls within the last pixel inside of the border.
    template <class Visit>
    void thin(StepId id, const PixelRect& within, const Visit& visit) {
        const Piece& piece = stages_.piece(id);
        const int reach = piece.is_smooth ? 2 : 1, far = reach + 1;
        const PixelRect around{within.x0 - far, within.y0 - far, within.x1 + far, within.y1 + far};
        std::vector<std::pair<int, int>> covered;
        const auto cover = [&](int x, int y) { covered.emplace_back(x, y); };
        for_each_pixel(piece, around, cover);
        // A line that leaves no diamond covers nothing, or one fragment nearby. It may also cover pixels elsewhere.
        const bool nothing = covered.empty() && covers_nothing(piece);
        if (nothing) for_each(point_square(glm::dvec2(piece.ends().from.position_window), piece.size, around), cover);
        if (covered.empty()) return;
        PixelRect box{INT_MAX, INT_MAX, INT_MIN, INT_MIN};
        for (const auto& [x, y] : covered)
            box = {std::min(box.x0, x - reach), std::min(box.y0, y - reach), std::max(box.x1, x + far),
                   std::max(box.y1, y + far)};
        std::vector<char> neighbours(box.count());
        for (const auto& [px, py] : covered)
            for_each({px - reach, py - reach, px + far, py + far},
                     [&](int x, int y) { ++neighbours[box.index(x, y)]; });
        const int all = (2 * reach + 1) * (2 * reach + 1);
        // Mesa lengthens a smooth line by half a pixel at each end, and with it what changes along the line.
        const bool is_stretched =
            piece.is_smooth && piece.shape == Shape::kLine && changes_along(piece, stages_.draw_of(piece));
        const PixelRect seen{std::max(box.x0, within.x0), std::max(box.y0, within.y0), std::min(box.x1, within.x1),
                             std::min(box.y1, within.y1)};
        for_each(seen, [&](int x, int y) {
            const char count = neighbours[box.index(x, y)];
            if (count == 0) return;
            const bool first = !again(id, window_.index(x, y));
            // With another order, blending would have more or less beneath it, whatever the depth test decides.
            if (!first && !overwrites_color(stages_.draw_of(piece).fragment))
                open_to_any(window_.index(x, y), bit_of(Why::kOrder));
            const bool is_certain = count == all && !nothing && first && !piece.is_perhaps_clipped && !is_stretched;
            visit(id, x, y, is_certain ? Outcome::kPasses : Outcome::kOpen, nullptr);
        });
    }

    // Whether another line or point of the same polygon's border has covered the pixel. The specification gives no
    // order for the border (3.5.4): where two overlap at a corner, either may be visible.
    bool again(StepId id, std::size_t at) {
        const StepId other_id = std::exchange(thin_[at], id);
        if (other_id == kNobody) return false;
        const Piece &piece = stages_.piece(id), &other = stages_.piece(other_id);
        // The triangles of one quadrilateral or polygon have the same provoking vertex; triangles of a mesh have
        // different ones.
        return piece.draw == other.draw && piece.primitive.provoking == other.primitive.provoking;
    }

    const StagedFrame& stages_;
    const PixelRect window_;
    std::vector<char> open_;  // kSettled, ...
    std::vector<Whys> why_;
    std::vector<char> undefined_, drawn_;
    mutable std::vector<std::optional<bool>> one_color_;  // of each Draw
    std::vector<Interval> depth_;
    std::vector<StepId> depth_of_;  // the piece with that depth, if certain
    std::vector<int> stencil_;      // the stencil value, or kAnyValue; empty until it is used
    std::vector<StepId> thin_;      // the last line or point at the pixel
    // The last points around a pixel, which are asked for several times.
    mutable PointsAround around_;
    mutable const SurfaceRays* around_rays_ = nullptr;
    mutable int around_x_ = 0, around_y_ = 0;
};

class IntervalBuffer : public FragmentLoop<OpenPixels> {
  public:
    using FragmentLoop::FragmentLoop;

    struct Pixel {
        bool edge = false, drawn = false, is_undefined = false;
        Whys open = 0;                       // at edges
        Why why = Why::kTextures;            // of `channels`
        Rgba channels{};                     // away from edges
        std::vector<AllowedRange> ranges{};  // at edges, unless any colour may be there
    };
    std::optional<int> known_stencil(int x, int y) const { return kept_.known_stencil(window_.index(x, y)); }
    Pixel pixel(int x, int y) {
        const std::size_t at = window_.index(x, y);
        const StepId id = step_[at];
        Pixel result{.edge = kept_.is_open(at), .drawn = kept_.is_drawn(at), .is_undefined = kept_.is_undefined(at)};
        if (!result.edge) {
            if (id != kColor && (id < 0 || !shaders_[stages_.piece(id).draw].has_several_colors(stages_.piece(id))))
                return result;
            const Channels<Interval> color = resolved(x, y);
            result.edge = kept_.is_open(at);  // which texel it has may be a choice
            if (id != kColor) result.why = shaders_[stages_.piece(id).draw].why_several_colors(stages_.piece(id));
            for (std::size_t i = 0; i < color.size(); ++i)
                result.channels[i] = result.edge ? 0 : static_cast<float>(color[i].width());
        }
        if (result.edge) result.open = kept_.why(at);
        if (!result.edge || kept_.is_unknown(at)) return result;
        for (const Channels<Interval>& color : choices(x, y)) {
            const AllowedRange range = range_of(color);
            if (!is_range(range) || has_all_colors(range)) {
                result.ranges.clear();
                break;
            }
            if (std::ranges::find(result.ranges, range) == result.ranges.end()) result.ranges.push_back(range);
        }
        return result;
    }

  private:
    static AllowedRange range_of(const Channels<Interval>& color) {
        AllowedRange range;
        for (std::size_t i = 0; i < color.size(); ++i) {
            range.low[i] = static_cast<float>(color[i].low);
            range.high[i] = static_cast<float>(color[i].high);
        }
        return range;
    }
    static bool has_all_colors(const AllowedRange& range) {
        for (std::size_t i = 0; i < 3; ++i)
            if (range.low[i] > 0 || range.high[i] < 1) return false;
        return true;
    }
    static bool is_range(const AllowedRange& range) {
        for (std::size_t i = 0; i < range.low.size(); ++i)
            if (!(range.low[i] <= range.high[i])) return false;
        return true;
    }
};

// The same for the depths at the centres of the pixels.
class OpenDepths : public OpenPixels {
  public:
    using OpenPixels::OpenPixels;

    Interval depth(const Fragment& fragment) const {
        const Piece& piece = *fragment.piece;
        // Lines and points may have the depth of a place nearby.
        if (piece.shape != Shape::kTriangle) return OpenPixels::depth(fragment);
        constexpr double kRoundings = 8 * 0x1p-24;  // of the plane, in floats: a constant plus slope times pixel number
        const glm::dvec3 plane = glm::abs(piece.planes().depth);
        const glm::dvec2 place = glm::abs(fragment.position_window);
        return widened(depth_at(piece, fragment.position_window),
                       stages().border * (plane.x + plane.y) + offset_doubt(piece) +
                           kRoundings * (plane.x * place.x + plane.y * place.y + std::abs(plane.z)));
    }
    void set_depth(std::size_t at, StepId id, const Interval& depth, Outcome outcome) {
        Interval stored = depth;
        if (id >= 0) {  // drivers have an r of their own (3.5.5)
            const PolygonOffset& offset = stages().draw_of(stages().piece(id)).raster.polygon_offset;
            if (offset.point || offset.line || offset.fill)
                stored = widened(depth, 2 * std::abs(offset.units) * kDepthStep);
        }
        OpenPixels::set_depth(at, id, stored, outcome);
    }
    const Interval& depth(std::size_t at) const { return stored_depth(at); }
};

class DepthIntervals : public FragmentLoop<OpenDepths> {
  public:
    using FragmentLoop::FragmentLoop;

    const Interval& depth(int x, int y) const { return kept_.depth(window_.index(x, y)); }
};

// Adds the colours of the other cut of quadrilaterals. Where the pixel is no edge in one cut, its colour is that of the picture.
void join_ranges(OpenDifference& difference, std::size_t at, std::vector<AllowedRange> more, bool is_edge,
                 bool was_edge) {
    const auto known = difference.ranges.find(at);
    const bool has_known = known != difference.ranges.end();
    const bool is_unknown = (is_edge && more.empty()) || (was_edge && !has_known);
    if (has_known && (is_unknown || !was_edge)) difference.ranges.erase(known);
    if (is_unknown || !is_edge) return;
    std::vector<AllowedRange>& ranges = difference.ranges[at];
    for (const AllowedRange& range : more)
        if (std::ranges::find(ranges, range) == ranges.end()) ranges.push_back(range);
}

}  // namespace

void find_differences(StagedFrame stages, const Options& options, const PixelRect& within, OpenDifference& difference,
                      Joining joining) {
    const bool adds = joining == Joining::kAdds;
    Image& channels = difference.channels;
    if (within.is_empty()) return;
    mark_undefined_colors(stages);
    std::mutex mutex;  // of difference.ranges: bands find them at once
    const auto join = [&](IntervalBuffer& buffer, int x, int y) {
        IntervalBuffer::Pixel pixel = buffer.pixel(x, y);
        const std::size_t at = channels.index(x, channels.height - 1 - y);
        const bool had_ranges = difference.edge[at] != 0, was_edge = adds && had_ranges;
        if (pixel.edge || had_ranges) {
            const std::lock_guard lock(mutex);
            join_ranges(difference, at, std::move(pixel.ranges), pixel.edge, was_edge);
        }
        difference.edge[at] = pixel.edge || was_edge;
        difference.drawn[at] = pixel.drawn || (adds && difference.drawn[at] != 0);
        difference.undefined[at] = pixel.is_undefined || (adds && difference.undefined[at] != 0);
        difference.open[at] = pixel.open | (adds ? difference.open[at] : 0);
        if (!adds || pixel.why != Why::kTextures) difference.why[at] = pixel.why;
        for (std::size_t c = 0; c < pixel.channels.size(); ++c) {
            float& channel = channels.pixels[at][c];
            channel = adds ? std::max(channel, pixel.channels[c]) : pixel.channels[c];
        }
    };
    draw_in_bands<IntervalBuffer>(stages, make_color_shaders(stages, options), within,
                                  [&](IntervalBuffer& buffer, const PixelRect& band) {
                                      for_each(band, [&](int x, int y) { join(buffer, x, y); });
                                  });
}

namespace {

// range_of(buffer, x, y) for each pixel.
template <class Buffer, class RangeOf>
BufferBounds bounds_of(StagedFrame stages, const Options& options, int width, int height, const RangeOf& range_of) {
    BufferBounds bounds{Image(width, height), Image(width, height)};
    draw_in_bands<Buffer>(stages, make_color_shaders(stages, options), {0, 0, width, height},
                          [&](const Buffer& buffer, const PixelRect& band) {
                              for_each(band, [&](int x, int y) {
                                  const Interval range = range_of(buffer, x, y);
                                  const auto low = static_cast<float>(range.low), high = static_cast<float>(range.high);
                                  bounds.low.at(x, height - 1 - y) = {low, low, low, 1};
                                  bounds.high.at(x, height - 1 - y) = {high, high, high, 1};
                              });
                          });
    return bounds;
}

}  // namespace

BufferBounds depth_bounds(StagedFrame stages, const Options& options, int width, int height) {
    return bounds_of<DepthIntervals>(std::move(stages), options, width, height,
                                     [](const DepthIntervals& buffer, int x, int y) { return buffer.depth(x, y); });
}

BufferBounds stencil_bounds(StagedFrame stages, const Options& options, int width, int height) {
    return bounds_of<IntervalBuffer>(std::move(stages), options, width, height,
                                     [](const IntervalBuffer& buffer, int x, int y) -> Interval {
                                         const std::optional<int> value = buffer.known_stencil(x, y);
                                         if (!value) return {0, 1};
                                         return Interval(*value / static_cast<double>(kMaxStencil));
                                     });
}

AllowedDifference allowed_difference(const Frame& frame, const Options& options) {
    return Pictures(frame).allowed_difference(options);
}

}  // namespace twinlight::reference
