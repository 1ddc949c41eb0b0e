// The pixels where right implementations may differ, and by how much (docs/lighting.md, "Edges").
//
// The steps of the picture once more, in their order, but over what each may come to all over a pixel's square:
//   - coverage: a piece fills the square, or its border passes through it;
//   - depth: an interval; where it overlaps what is stored, the outcome of the test is open;
//   - colour: an interval a channel (framebuffer.h does the same with colours).
// A pixel becomes open where a fragment may or may not change its colour, and certain again where one certainly
// overwrites it. What is open at the end is an edge pixel.
#include <climits>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "render/reference/fragment_operations.h"
#include "render/reference/framebuffer.h"
#include "render/reference/reference.h"
#include "render/reference/surface_edges.h"
#include "render/reference/texture_place.h"

namespace twinlight::reference {

namespace {

// The square grows by what snapping may move a border.
constexpr double kHalfSquare = 0.5 + kSnap;
// Lines and points may choose the pixel beside (3.4.1 allows a line to be off by one).
constexpr double kHalfLineSquare = 1.5;
// Two depths that a buffer of 24 bits may hold as the same number, each rounded.
constexpr double kDepthQuantum = 2 * kDepthStep;
// A colour's error in float arithmetic (2.1.1: 1 part in 10^5 an operation), where it decides about a code.
constexpr double kArithmetic = 1e-4;

constexpr double kRoundedProduct = 0.5 / kColorCodes;

constexpr StepId kColor = std::numeric_limits<StepId>::min();
constexpr StepId kNobody = kColor;

// The depths of a piece over the square about a pixel's centre. A line's or point's own are widened by its slope.
Interval depths(const Piece& piece, const glm::dvec2& centre, double half_width) {
    double change = 0;
    if (piece.shape == Shape::kTriangle)
        change = half_width * (std::abs(piece.depth_plane.x) + std::abs(piece.depth_plane.y));
    if (piece.shape == Shape::kLine) {
        const glm::dvec3 d = glm::abs(piece.to.position_window - piece.from.position_window);
        change = 2 * half_width * d.z / std::max({d.x, d.y, 1.0});
    }
    return widened(depth_at(piece, centre), change);
}

enum class Outcome : std::uint8_t { kPasses, kFails, kOpen };

// What the depth test makes of `incoming - stored`.
Outcome depth_outcome(Enum depth_func, const Interval& difference) {
    if (depth_func == kGL_ALWAYS) return Outcome::kPasses;
    if (depth_func == kGL_NEVER) return Outcome::kFails;
    const bool nearer = difference.high<-kDepthQuantum, farther = difference.low> kDepthQuantum;
    if (!nearer && !farther) return Outcome::kOpen;
    // Equality is out of the question now: one comparison stands for all.
    return depth_passes(depth_func, nearer ? -1 : 1, 0) ? Outcome::kPasses : Outcome::kFails;
}

// A driver may cut one that it shades flat, or has in a display list, otherwise than the same one shaded smooth, or not.
bool is_quadrilaterals(const Draw& draw) { return draw.mode == kGL_QUADS || draw.mode == kGL_QUAD_STRIP; }

// The same triangle, clipped alike, but perhaps for its polygon offset.
bool same_triangle(const Piece& a, const Piece& b) {
    return a.shape == Shape::kTriangle && b.shape == Shape::kTriangle && a.corners == b.corners &&
           a.weight_over_w_planes == b.weight_over_w_planes && a.depth_plane.x == b.depth_plane.x &&
           a.depth_plane.y == b.depth_plane.y;
}

// What the alpha test makes of all alphas of the interval, compared as 8-bit numbers or finer ones: 4.1.4 takes as many
// bits as the colour buffer has, at least.
Outcome alpha_outcome(const FragmentState& state, const Interval& alpha) {
    const double reference = clamp01(state.alpha_ref);
    const bool equal = alpha == Interval(reference);
    const bool may_be_equal = alpha.low - kArithmetic - 1.0 / kColorCodes <= reference &&
                              reference <= alpha.high + kArithmetic + 1.0 / kColorCodes;
    if (!equal && may_be_equal && state.alpha_func != kGL_ALWAYS && state.alpha_func != kGL_NEVER)
        return Outcome::kOpen;
    return alpha_passes(state, alpha.low) ? Outcome::kPasses : Outcome::kFails;
}

// What a colour buffer may hold of a channel.
Interval held(const Interval& channel) {
    return {quantised(channel.low - kArithmetic), quantised(channel.high + kArithmetic)};
}

// How many products of the blend equation round: all but those with 0 or 1.
int rounded_products(const FragmentState& state, std::size_t i) {
    const Enum equation = blend_equation(state, i);
    if (equation == kGL_MIN || equation == kGL_MAX) return 0;
    const auto rounds = [](Enum factor) { return factor != kGL_ZERO && factor != kGL_ONE ? 1 : 0; };
    return i == 3 ? rounds(state.blend_src_alpha) + rounds(state.blend_dst_alpha)
                  : rounds(state.blend_src) + rounds(state.blend_dst);
}

enum class Touch : std::uint8_t { kNo, kInside, kBorder };

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

// Whole rows of the window.
class Rows {
  public:
    Rows(const Stages& stages, const std::vector<Shader>& shaders, int width, int y0, int y1)
        : stages_(stages), shaders_(shaders), width_(width), y0_(y0), y1_(y1) {
        const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(y1 - y0);
        step_.resize(count);
        open_.resize(count);
        depth_.resize(count);
        depth_of_.resize(count);
        for (const Step& step : stages.steps) {
            if (step.clear < 0) clear(step.clear);
            for (std::size_t i = step.first_piece; i < step.end_piece; ++i) {
                const StepId id = static_cast<StepId>(i);
                stages.pieces[i].shape == Shape::kTriangle ? polygon(id) : thin(id);
            }
        }
    }

    struct Pixel {
        bool edge = false;
        Rgba slack{};
    };
    Pixel pixel(int x, int y) {
        const std::size_t at = index(x, y);
        Pixel result{.edge = open_[at] != 0};
        const bool exact = step_[at] != kColor && (step_[at] < 0 || !draw(step_[at]).texture.texture);
        if (result.edge || exact) return result;
        const Channels<Interval> color = resolved(x, y);
        result.edge = open_[at] != 0;
        for (std::size_t i = 0; i < color.size(); ++i) result.slack[i] = static_cast<float>(color[i].width());
        return result;
    }

  private:
    PixelRect window() const { return {0, y0_, width_, y1_}; }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - y0_) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    const Draw& draw(StepId id) const { return stages_.draw_of(stages_.piece(id)); }

    void clear(StepId id) {
        const Clear& clear = stages_.clear(id);
        FragmentState mask;
        mask.color_mask = clear.color_mask;
        const PixelRect rect = scissored(clear.scissor, window());
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x) {
                const std::size_t at = index(x, y);
                if (clear.depth) {
                    depth_[at] = clear.clear_depth;
                    depth_of_[at] = id;
                }
                if (!clear.color) continue;
                if (overwrites_color(mask)) {
                    step_[at] = id;
                    open_[at] = 0;
                } else {
                    write(mask, channels<Interval>(clamped(clear.clear_color)), x, y);
                }
            }
    }

    void polygon(StepId id) {
        const Piece& piece = stages_.piece(id);
        const PixelRect box = bounds(piece.corners, scissored(draw(id).fragment.scissor, window()), kSnap);
        if (box.y0 >= box.y1 || box.x0 >= box.x1) return;
        const std::vector<Edge> edges = edges_of(piece.corners);
        if (edges.size() < 2) return;
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) {
                const Touch how = touch(edges, pixel_centre(x, y));
                if (how != Touch::kNo) fragment(id, x, y, how == Touch::kInside, kHalfSquare);
            }
    }

    // Lines and points: certain are the pixels all around which it covers others; open the rest and those beside.
    void thin(StepId id) {
        const FragmentState& state = draw(id).fragment;
        const PixelRect seen = scissored(state.scissor, window());
        const PixelRect around{seen.x0 - 2, seen.y0 - 2, seen.x1 + 2, seen.y1 + 2};
        std::vector<std::pair<int, int>> covered;
        for_each_pixel(stages_.piece(id), around, [&](int x, int y) { covered.emplace_back(x, y); });
        // A line that is too short to leave any diamond covers nothing, or one fragment elsewhere.
        const bool nothing = covered.empty();
        if (nothing) {
            const Piece& piece = stages_.piece(id);
            const PixelRect end = point_square(glm::dvec2(piece.from.position_window), piece.size, around);
            for (int y = end.y0; y < end.y1; ++y)
                for (int x = end.x0; x < end.x1; ++x) covered.emplace_back(x, y);
        }
        if (covered.empty()) return;
        PixelRect box{INT_MAX, INT_MAX, INT_MIN, INT_MIN};
        for (const auto& [x, y] : covered)
            box = {std::min(box.x0, x - 1), std::min(box.y0, y - 1), std::max(box.x1, x + 2), std::max(box.y1, y + 2)};
        const int columns = box.x1 - box.x0;
        std::vector<char> neighbours(static_cast<std::size_t>(columns) * static_cast<std::size_t>(box.y1 - box.y0));
        for (const auto& [px, py] : covered)
            for (int y = py - 1; y <= py + 1; ++y)
                for (int x = px - 1; x <= px + 1; ++x)
                    ++neighbours[static_cast<std::size_t>(y - box.y0) * static_cast<std::size_t>(columns) +
                                 static_cast<std::size_t>(x - box.x0)];
        constexpr char kAll = 9;
        for (int y = std::max(box.y0, seen.y0); y < std::min(box.y1, seen.y1); ++y)
            for (int x = std::max(box.x0, seen.x0); x < std::min(box.x1, seen.x1); ++x) {
                const char count = neighbours[static_cast<std::size_t>(y - box.y0) * static_cast<std::size_t>(columns) +
                                              static_cast<std::size_t>(x - box.x0)];
                if (count == 0) continue;
                const bool first = !again(id, index(x, y));
                fragment(id, x, y, count == kAll && !nothing && first, kHalfLineSquare);
                // Whatever the depth test made of it: in the other order there is more, or less, to blend with.
                if (!first && !overwrites_color(state)) open_[index(x, y)] = 1;
            }
    }

    // Whether another line or point of the same polygon's border has been at the pixel. The text says in no order how a
    // border is drawn (3.5.4): which of two is seen where they lie on each other, at a corner, is open.
    bool again(StepId id, std::size_t at) {
        if (thin_.empty()) thin_.resize(open_.size(), kNobody);
        const StepId other_id = std::exchange(thin_[at], id);
        if (other_id == kNobody) return false;
        const Piece &piece = stages_.piece(id), &other = stages_.piece(other_id);
        // Triangles that a quadrilateral or a polygon is cut to have one provoking vertex; those of a mesh their own.
        return piece.draw == other.draw && piece.primitive.provoking == other.primitive.provoking;
    }

    Outcome depth_test(const Piece& piece, std::size_t at, const Interval& depth, const glm::dvec2& centre) const {
        const RasterState& raster = stages_.draw_of(piece).raster;
        if (!raster.depth_test) return Outcome::kPasses;
        const StepId other_id = depth_of_[at];
        if (other_id >= 0) {
            const Piece& other = stages_.piece(other_id);
            const glm::dvec3 between = piece.depth_plane - other.depth_plane;
            // Appendix A: what is drawn again has the same depths; 3.5.5: r keeps offsets apart.
            if (same_triangle(piece, other) && !is_quadrilaterals(stages_.draw_of(piece)))
                return depth_passes(raster.depth_func, between.z, 0) ? Outcome::kPasses : Outcome::kFails;
            if (piece.shape == Shape::kTriangle && other.shape == Shape::kTriangle) {
                const double change = kHalfSquare * (std::abs(between.x) + std::abs(between.y));
                const double difference = depth_at(piece, centre) - depth_at(other, centre);
                return depth_outcome(raster.depth_func, widened(difference, change));
            }
        }
        return depth_outcome(raster.depth_func, depth - depth_[at]);
    }

    void fragment(StepId id, int x, int y, bool fills, double half_width) {
        const std::size_t at = index(x, y);
        const Piece& piece = stages_.piece(id);
        const Draw& draw = stages_.draw_of(piece);
        const FragmentState& state = draw.fragment;
        const glm::dvec2 centre = pixel_centre(x, y);
        const Interval depth = draw.raster.depth_test ? depths(piece, centre, half_width) : Interval();
        const Outcome passes_depth = depth_test(piece, at, depth, centre);
        if (passes_depth == Outcome::kFails) return;
        bool certain = fills && passes_depth == Outcome::kPasses;

        // Where the pixel is open anyway its colour is of no interest.
        const bool color_waits = overwrites_color(state) && !state.alpha_test;
        FragmentBounds found;
        if (!color_waits && certain && (writes_color(state) || state.alpha_test)) {
            found = shaders_[piece.draw].bounds(piece, centre);
            const Outcome passes_alpha = state.alpha_test ? alpha_outcome(state, found.color[3]) : Outcome::kPasses;
            if (passes_alpha == Outcome::kFails) return;
            certain = passes_alpha == Outcome::kPasses;
        }

        if (draw.raster.depth_test && draw.raster.depth_mask) {
            depth_[at] = certain ? depth : hull(depth_[at], depth);
            depth_of_[at] = certain ? id : kNobody;
        }
        if (!writes_color(state)) return;
        if (!certain) {
            open_[at] = 1;
        } else if (color_waits) {
            step_[at] = id;
            open_[at] = 0;
        } else {
            if (overwrites_color(state)) open_[at] = 0;
            write(state, found.color, x, y);
            if (found.has_choice) open_[at] = 1;
        }
    }

    Channels<Interval> resolved(int x, int y) {
        const std::size_t at = index(x, y);
        const StepId id = step_[at];
        if (id == kColor) return colors_[at];
        if (id < 0) return channels<Interval>(clamped(stages_.clear(id).clear_color));
        const Piece& piece = stages_.piece(id);
        const FragmentBounds found = shaders_[piece.draw].bounds(piece, pixel_centre(x, y));
        if (found.has_choice) open_[at] = 1;
        return found.color;
    }

    // Blending in a buffer of 8 bits: drivers may round the fragment's colour and the blend colour to those bits before
    // they multiply, and each of the two products before they add them.
    void write(const FragmentState& state, const Channels<Interval>& source, int x, int y) {
        const std::size_t at = index(x, y);
        Channels<Interval> beneath{}, fragment = source, constant = channels<Interval>(clamped(state.blend_color));
        if (!overwrites_color(state))
            for (std::size_t i = 0; const Interval& channel : resolved(x, y)) beneath[i++] = held(channel);
        for (Channels<Interval>* factor : {&fragment, &constant})
            if (state.blend)
                for (Interval& channel : *factor) channel = hull(channel, held(channel));
        if (colors_.empty()) colors_.resize(step_.size());
        for (std::size_t i = 0; i < source.size(); ++i) {
            Interval& result = colors_[at][i];
            if (!state.color_mask[i])
                result = beneath[i];
            else if (!state.blend)
                result = source[i];
            else
                result = clamp01(widened(blended(state, i, fragment, beneath, constant),
                                         kRoundedProduct * rounded_products(state, i)));
        }
        step_[at] = kColor;
    }

    const Stages& stages_;
    const std::vector<Shader>& shaders_;
    const int width_, y0_, y1_;
    std::vector<StepId> step_;                // of the colour, or kColor
    std::vector<Channels<Interval>> colors_;  // where the step is kColor; empty as long as nowhere
    std::vector<char> open_;
    std::vector<Interval> depth_;
    std::vector<StepId> depth_of_;  // whose the depth is, where that is certain
    std::vector<StepId> thin_;      // the last line or point there; empty as long as there are none
};

}  // namespace

namespace {

Freedom freedom_of_cut(const Frame& frame, const Options& options) {
    const Stages stages = run_stages(frame, options);
    const std::vector<Shader> shaders = make_shaders(stages, options);
    const std::size_t count = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    std::vector<char> edge(count);  // bytes, not bits: bands write beside each other
    Freedom result{.edge = {}, .slack = Image(frame.width, frame.height)};
    for_each_band(frame.height, [&](int y0, int y1) {
        Rows rows(stages, shaders, frame.width, y0, y1);
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < frame.width; ++x) {
                const Rows::Pixel pixel = rows.pixel(x, y);
                const std::size_t at = result.slack.index(x, frame.height - 1 - y);
                edge[at] = pixel.edge;
                result.slack.pixels[at] = pixel.slack;
            }
    });
    result.edge.assign(edge.begin(), edge.end());
    return result;
}

void join(Freedom& freedom, const Freedom& other) {
    for (std::size_t i = 0; i < freedom.edge.size(); ++i) {
        freedom.edge[i] = freedom.edge[i] || other.edge[i];
        for (std::size_t c = 0; c < freedom.slack.pixels[i].size(); ++c) {
            freedom.slack.pixels[i][c] = std::max(freedom.slack.pixels[i][c], other.slack.pixels[i][c]);
        }
    }
}

}  // namespace

Freedom freedom(const Frame& frame, Options options) {
    if (options.shading == Shading::kExact) {
        options.shading = Shading::kPhong;
        Freedom result = freedom(frame, options);
        options.shading = Shading::kExact;
        add_surface_edges(frame, options, result.edge);
        return result;
    }
    options.quad_cut = QuadCut::kFirstToThird;
    Freedom result = freedom_of_cut(frame, options);
    if (!has_quadrilaterals(frame)) return result;
    options.quad_cut = QuadCut::kSecondToFourth;
    join(result, freedom_of_cut(frame, options));
    return result;
}

PixelMask edge_pixels(const Frame& frame) { return freedom(frame).edge; }

}  // namespace twinlight::reference
