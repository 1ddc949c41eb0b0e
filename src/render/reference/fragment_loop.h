// The fragments of a picture: goes through pieces, clears and accumulations in the order of the commands, and for each
// piece through coverage, stencil and depth test, shading, alpha test, blending and masks (chapters 3 and 4).
//
// One template for two kinds of stored pixels:
//   - numbers: the picture (framebuffer.h), and one pixel of it with its fragments (pixel_history.h);
//   - intervals: how much correct pictures may differ (allowed_difference.cpp).
//
// Lighting is delayed if possible: a pixel stores either a colour, or the step whose colour it has, which is lit only
// if it stays visible. A fragment is lit at once if its colour depends on the colour beneath (blending, a colour mask),
// or if it decides whether the fragment is drawn (the alpha test).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/image/difference.h"
#include "render/reference/fragment_operations.h"
#include "render/reference/geometry/coverage.h"
#include "render/reference/staged_frame.h"

namespace twinlight::reference {

// Where a piece's fragment may have its colour from if rasterisers round positions.
struct Nearby {
    std::vector<glm::dvec2> places{};
    std::optional<Piece> piece{};  // the places are of this one, instead
    bool has_any_color = false;
};

// Kept has
//   Real                                      double or Interval
//   for_each_fragment(id, within, visit)      calls visit(id, x, y, Outcome, surface point or null) at each pixel
//   depth(fragment)                           the fragment's depth
//   depth_outcome(func, fragment, depth, at)  of the test against the stored depth
//   set_depth(at, id, depth, outcome)
//   clear_stencil(clear, at)
//   stencil_outcome(face, at)                 of the test against the stored value
//   set_stencil(face, covers, stencil, depth, at)  after the outcomes of coverage and both tests
//   open_stencil(at)                          any value may be written
//   is_open(at), open(at, why), settle(at)    whether the colour is open; marks it as open; as certain
//   why(at), is_undefined(at)                 what was given to open(); whether the colour is undefined
//   is_unknown(at), open_to_any(at, why)      whether it may be any colour; marks it so
//   leave_undefined(at)                       the specification leaves it undefined, until it is settled
// and over intervals
//   nearby(piece, x, y)                       the places from which the piece's fragment at the pixel may have its colour (Nearby)
//   points(piece, x, y)                       the same for a surface: the points that may be seen as its fragment
//
// Over intervals an open pixel has several colours, of which correct pictures show one: that of the last step which may be seen
// there, and those beneath it (others_). Where they are mixed with a fragment (blending), each of them is.
template <class Kept>
class FragmentLoop {
  public:
    using Real = typename Kept::Real;

    // `window`: the pixels to draw, y up. Stages and shaders must outlive it.
    FragmentLoop(const StagedFrame& stages, const std::vector<Shader>& shaders, const PixelRect& window)
        : stages_(stages), shaders_(shaders), window_(window), kept_(stages, window), step_(window.count()) {}

    // Draws all steps. Calls watch(fragment, outcome) after each fragment, drawn or not.
    template <class Watch>
    void draw(const Watch& watch) {
        for (const Step& step : stages_.steps) {
            if (step.clear < 0) clear(step.clear);
            if (step.accumulate) accumulate(*step.accumulate);
            for (std::size_t i = step.first_piece; i < step.end_piece; ++i)
                if (stages_.rows[i].meets(window_)) piece(static_cast<StepId>(i), watch);
        }
    }
    void draw() {
        draw([](const Fragment&, Outcome) {});
    }

  private:
    // 4.2.3: a clear obeys the scissor and the colour mask.
    void clear(StepId id) {
        const Clear& clear = stages_.clear(id);
        FragmentState mask;
        mask.color_mask = clear.color_mask;
        const bool overwrites = overwrites_color(mask);
        if (clear.accumulation) need_accumulation();
        for_each(scissored(clear.scissor, window_), [&](int x, int y) {
            const std::size_t at = window_.index(x, y);
            if (clear.stencil) kept_.clear_stencil(clear, at);
            if (clear.accumulation) accumulation_[at] = {.color = channels<Real>(clear.clear_accumulation)};
            if (clear.depth) kept_.set_depth(at, id, clear.clear_depth, Outcome::kPasses);
            if (!clear.color) return;
            if (overwrites)
                wait(id, at, Outcome::kPasses, 0);
            else
                write(mask, {channels<Real>(clamped(clear.clear_color))}, x, y, Outcome::kPasses, 0);
        });
    }

    template <class Watch>
    void piece(StepId first_id, const Watch& watch) {
        const Piece& piece = stages_.piece(first_id);
        const Draw& draw = stages_.draw_of(piece);
        if (draw.pixels && draw.pixels->has_stencils) return stencil_value(first_id, watch);
        const RasterState& raster = draw.raster;
        const FragmentState& state = draw.fragment;
        const bool writes = writes_color(state);
        const bool waits = overwrites_color(state) && !state.alpha_test && !piece.is_smooth;
        // Draws a fragment that certainly or perhaps covers the pixel, and returns the outcome.
        const auto draw_fragment = [&](StepId id, const Fragment& fragment, int x, int y, Outcome covers) {
            const std::size_t at = window_.index(x, y);
            Outcome outcome = covers;
            Whys why = covers == Outcome::kOpen ? bit_of(Why::kBorder) : 0;
            const auto narrow = [&](Outcome of_test, Why test) {
                outcome = std::min(outcome, of_test);
                if (of_test == Outcome::kOpen) why |= bit_of(test);
            };
            Real depth{};
            Shaded<Real> shaded;
            // The order of the tests matters only to the stencil: both others must pass. If the pixel may have any colour,
            // the fragment's is not needed.
            const bool stays_unknown = kept_.is_unknown(at) && !overwrites_color(state);
            const auto alpha_test = [&] {
                if (waits || !((writes && !stays_unknown) || state.alpha_test) || outcome == Outcome::kFails) return;
                shaded = color_of(fragment, x, y, covers);
                if (state.alpha_test) narrow(alpha_outcome(state, shaded.color[3]), Why::kAlpha);
            };
            if (state.stencil) {
                alpha_test();
                if (outcome == Outcome::kFails) return outcome;
                const StencilFace& face =
                    face_of(fragment) == Face::kFront ? state.stencil->front : state.stencil->back;
                const Outcome stencil = kept_.stencil_outcome(face, at);
                Outcome of_depth = Outcome::kPasses;
                if (raster.depth_test && stencil != Outcome::kFails) {
                    depth = kept_.depth(fragment);
                    of_depth = kept_.depth_outcome(raster.depth_func, fragment, depth, at);
                }
                kept_.set_stencil(face, outcome, stencil, of_depth, at);
                narrow(stencil, Why::kStencil);
                narrow(of_depth, Why::kDepth);
            } else {
                if (raster.depth_test) {
                    depth = kept_.depth(fragment);
                    narrow(kept_.depth_outcome(raster.depth_func, fragment, depth, at), Why::kDepth);
                }
                if (outcome != Outcome::kFails) alpha_test();
            }
            if (outcome == Outcome::kFails) return outcome;
            // 4.1.6: without the depth test the depth buffer does not change.
            if (raster.depth_test && raster.depth_mask) kept_.set_depth(at, id, depth, outcome);
            if (!writes) return outcome;
            if (waits)
                wait(id, at, outcome, why);
            else if (!stays_unknown)
                write(state, shaded, x, y, outcome, why);
            if (stages_.is_undefined(*fragment.piece)) kept_.leave_undefined(at);
            return outcome;
        };
        const bool is_stippled = raster.polygon_stipple || raster.line_stipple;
        kept_.for_each_fragment(first_id, scissored(state.scissor, window_),
                                [&](StepId id, int x, int y, Outcome covers, const RayPoint* point) {
                                    const Outcome seen = is_stippled ? stippled(piece, x, y, covers) : covers;
                                    if (seen == Outcome::kFails) return;
                                    const Fragment fragment{&stages_.piece(id), pixel_centre(x, y), point};
                                    watch(fragment, draw_fragment(id, fragment, x, y, seen));
                                });
    }

    // 4.3.1: a stencil value of a pixel rectangle, which no test but the scissor's stops.
    template <class Watch>
    void stencil_value(StepId id, const Watch& watch) {
        const Piece& piece = stages_.piece(id);
        const Draw& draw = stages_.draw_of(piece);
        StencilFace face = draw.fragment.stencil->front;
        face.ref = draw.pixels->stencils[piece.primitive.vertices[0]];
        const auto set = [&](StepId, int x, int y, Outcome covers, const RayPoint*) {
            const std::size_t at = window_.index(x, y);
            if (covers == Outcome::kOpen)
                kept_.open_stencil(at);
            else
                kept_.set_stencil(face, covers, Outcome::kPasses, Outcome::kPasses, at);
            watch(Fragment{&piece, pixel_centre(x, y)}, covers);
        };
        kept_.for_each_fragment(id, scissored(draw.fragment.scissor, window_), set);
    }

    // What the stipples leave of an outcome: of lines (3.4.2), of filled polygons (3.5.2).
    Outcome stippled(const Piece& piece, int x, int y, Outcome covers) const {
        const RasterState& raster = stages_.draw_of(piece).raster;
        const bool is_polygon = piece.shape == Shape::kTriangle || piece.shape == Shape::kSurface;
        if (is_polygon && raster.polygon_stipple) {
            const std::uint32_t row = (*raster.polygon_stipple)[static_cast<std::size_t>(y % 32)];
            return (row >> (x % 32) & 1U) != 0 ? covers : Outcome::kFails;
        }
        if (piece.shape != Shape::kLine || !raster.line_stipple) return covers;
        int doubt = 0;
        if constexpr (std::is_same_v<Real, Interval>) {
            // A driver may find the line's first fragment one pixel farther on.
            constexpr int kFirst = 1;
            doubt = piece.stipple_doubt == kAnyCount ? kEveryCount : piece.stipple_doubt + kFirst;
        }
        return std::min(covers, stipple_outcome(*raster.line_stipple, stipple_count(piece, x, y), doubt));
    }
    static constexpr int kEveryCount = 16 * 256;  // the longest pattern

    static Face face_of(const Fragment& fragment) {
        return fragment.point ? fragment.point->face : fragment.piece->face;
    }

    // 4.2.4. Drivers may disagree on a pixel if the colour that they accumulate is open.
    void accumulate(const Accumulate& accumulate) {
        need_accumulation();
        FragmentState mask;
        mask.color_mask = accumulate.color_mask;
        for_each(scissored(accumulate.scissor, window_), [&](int x, int y) {
            const std::size_t at = window_.index(x, y);
            Accumulated& stored = accumulation_[at];
            if (accumulate.op == kGL_RETURN) {
                if (!writes_color(mask)) return;
                Shaded<Real> result;
                for (std::size_t i = 0; i < result.color.size(); ++i)
                    result.color[i] = clamp01(stored.color[i] * Real(accumulate.value));
                write(mask, result, x, y, Outcome::kPasses, 0);
                if (stored.is_open) kept_.open(at, stored.why);
                if (stored.is_unknown) kept_.open_to_any(at, stored.why);
                if (stored.is_undefined) kept_.leave_undefined(at);
                return;
            }
            const bool reads = accumulate.op == kGL_ACCUM || accumulate.op == kGL_LOAD,
                       loads = accumulate.op == kGL_LOAD;
            const Channels<Real> color = reads ? hull_of_all(x, y) : Channels<Real>{};
            stored.is_open = (!loads && stored.is_open) || (reads && kept_.is_open(at));
            stored.is_unknown = (!loads && stored.is_unknown) || (reads && kept_.is_unknown(at));
            stored.is_undefined = (!loads && stored.is_undefined) || (reads && kept_.is_undefined(at));
            stored.why = (loads ? 0 : stored.why) | (reads ? kept_.why(at) : 0);
            for (std::size_t i = 0; i < color.size(); ++i) {
                const Real result = accumulated(accumulate, stored.color[i], held(color[i]));
                stored.is_unknown |= leaves_accumulation(result);
                stored.color[i] = kept_accumulation(result);
            }
        });
    }
    void need_accumulation() {
        if (accumulation_.empty()) accumulation_.resize(window_.count());
    }

    // The fragment's colour; if only a rasteriser's rounding decides whether there is a fragment, of all places nearby.
    Shaded<Real> color_of(const Fragment& fragment, int x, int y, Outcome covers) {
        const Piece& piece = *fragment.piece;
        const Shader& shader = shaders_[piece.draw];
        if constexpr (kFindsRanges)
            if (piece.rays) return color_of_surface(piece, x, y);
        Shaded<Real> result = shader.template shade<Real>(fragment);
        Real coverage(piece.is_smooth ? coverage_of(piece, x, y) : 1);
        if constexpr (kFindsRanges) {
            if (covers != Outcome::kPasses) {
                const Nearby nearby = kept_.nearby(piece, x, y);
                if (nearby.has_any_color) result.color.fill({0, 1});
                for (const glm::dvec2& place : nearby.places) {
                    const Shaded<Real> there =
                        shader.template shade<Real>({nearby.piece ? &*nearby.piece : &piece, place});
                    result.color = hull(result.color, there.color);
                }
                if (piece.is_smooth) coverage = {0, 1};  // 3.2
            }
        }
        if (piece.is_smooth) result.color[3] = result.color[3] * coverage;
        return result;
    }

    Shaded<Real> color_of_surface(const Piece& piece, int x, int y) {
        const auto shade = [&](const RayPoint& point) {
            return shaders_[piece.draw].template shade<Real>({&piece, pixel_centre(x, y), &point});
        };
        const std::span<const RayPoint> points = kept_.points(piece, x, y);
        Shaded<Real> result = shade(points.front());
        for (const RayPoint& point : points.subspan(1)) {
            const Shaded<Real> there = shade(point);
            result.color = hull(result.color, there.color);
            result.has_choice |= there.has_choice;
        }
        return result;
    }

    // The pixel has the step's colour, lit later; if the outcome is open, perhaps.
    void wait(StepId id, std::size_t at, Outcome outcome, Whys why) {
        cover(at, outcome, why);
        step_[at] = id;
    }

    void write(const FragmentState& state, const Shaded<Real>& source, int x, int y, Outcome outcome, Whys why) {
        const std::size_t at = window_.index(x, y);
        // The fragment uses the colour beneath as the colour buffer stores it.
        const auto over = [&](const Channels<Real>& color) {
            Channels<Real> beneath{};
            for (std::size_t i = 0; const Real& channel : color) beneath[i++] = held(channel);
            return written(state, source.color, beneath);
        };
        if (overwrites_color(state)) {
            cover(at, outcome, why);
            set_color(at, written(state, source.color, {}));
        } else {
            const Channels<Real> beneath = resolved(x, y), color = over(beneath);
            if constexpr (kFindsRanges)
                if (kept_.is_open(at) || outcome == Outcome::kOpen) {
                    std::vector<Choice> before;
                    if (!others_.empty()) before = std::exchange(others_[at], {});
                    for (const Choice& choice : before) add_other(at, {kColor, over(color_of(choice, x, y))});
                    if (outcome == Outcome::kOpen) {
                        for (const Choice& choice : before) add_other(at, choice);
                        add_other(at, {kColor, beneath});
                        kept_.open(at, why);
                    }
                }
            set_color(at, color);
        }
        if (source.has_choice) kept_.open(at, bit_of(Why::kTexel));
    }
    void set_color(std::size_t at, const Channels<Real>& color) {
        if (colors_.empty()) colors_.resize(step_.size());
        colors_[at] = color;
        step_[at] = kColor;
    }

    // Before a colour that does not depend on those beneath: it hides them, certainly or perhaps.
    void cover(std::size_t at, Outcome outcome, Whys why) {
        if (outcome == Outcome::kPasses) {
            kept_.settle(at);
            if constexpr (kFindsRanges)
                if (!others_.empty()) others_[at].clear();
            return;
        }
        if constexpr (kFindsRanges) add_other(at, {step_[at], step_[at] == kColor ? colors_[at] : Channels<Real>{}});
        kept_.open(at, why);
    }

  protected:
    static constexpr bool kFindsRanges = std::is_same_v<Real, Interval>;
    static constexpr StepId kColor = std::numeric_limits<StepId>::min();

    // One of the colours that an open pixel may have: a step's, lit later, or kColor and the colour.
    struct Choice {
        StepId step = kColor;
        Channels<Real> color{};
        friend bool operator==(const Choice&, const Choice&) = default;
    };

    // The pixel's colour; lights the step if it was delayed.
    Channels<Real> resolved(int x, int y) {
        const std::size_t at = window_.index(x, y);
        return color_of({step_[at], step_[at] == kColor ? colors_[at] : Channels<Real>{}}, x, y);
    }
    Channels<Real> color_of(const Choice& choice, int x, int y) {
        const std::size_t at = window_.index(x, y);
        if (choice.step == kColor) return choice.color;
        if (choice.step < 0) return channels<Real>(clamped(stages_.clear(choice.step).clear_color));
        const Fragment fragment{&stages_.piece(choice.step), pixel_centre(x, y)};
        const Shaded<Real> shaded = color_of(fragment, x, y, kept_.is_open(at) ? Outcome::kOpen : Outcome::kPasses);
        if (shaded.has_choice) kept_.open(at, bit_of(Why::kTexel));
        return shaded.color;
    }
    // All colours that the pixel may have, unless it may have any.
    std::vector<Channels<Real>> choices(int x, int y) {
        std::vector<Channels<Real>> all{resolved(x, y)};
        if constexpr (kFindsRanges)
            if (!others_.empty())
                for (const Choice& choice : others_[window_.index(x, y)]) all.push_back(color_of(choice, x, y));
        return all;
    }

  private:
    Channels<Real> hull_of_all(int x, int y) {
        Channels<Real> all = resolved(x, y);
        if constexpr (kFindsRanges)
            for (const Channels<Real>& color : choices(x, y)) all = hull(all, color);
        return all;
    }
    void add_other(std::size_t at, const Choice& choice) {
        if (others_.empty()) others_.resize(step_.size());
        std::vector<Choice>& others = others_[at];
        if (std::ranges::find(others, choice) == others.end()) others.push_back(choice);
        if (others.size() < kMostChoices) return;
        const int width = window_.x1 - window_.x0, x = window_.x0 + static_cast<int>(at) % width,
                  y = window_.y0 + static_cast<int>(at) / width;
        std::vector<Choice> merged;
        for (const Choice& one : others) {
            const Choice lit{kColor, color_of(one, x, y)};
            if (std::ranges::find(merged, lit) == merged.end()) merged.push_back(lit);
        }
        while (merged.size() >= kMostChoices) merge_nearest(merged);
        others = std::move(merged);
    }
    // Replaces the two colours whose common range is the narrowest by it.
    static void merge_nearest(std::vector<Choice>& choices) {
        const auto common = [](const Choice& a, const Choice& b) { return Choice{kColor, hull(a.color, b.color)}; };
        const auto width = [](const Choice& choice) {
            double widest = 0;
            for (const Real& channel : choice.color) widest = std::max(widest, channel.width());
            return widest;
        };
        std::size_t first = 0, second = 1;
        double least = HUGE_VAL;
        for (std::size_t a = 0; a < choices.size(); ++a)
            for (std::size_t b = a + 1; b < choices.size(); ++b)
                if (const double one = width(common(choices[a], choices[b])); one < least) {
                    least = one;
                    first = a;
                    second = b;
                }
        choices[first] = common(choices[first], choices[second]);
        choices.erase(choices.begin() + static_cast<std::ptrdiff_t>(second));
    }
    static constexpr std::size_t kMostChoices = 8;

  protected:
    const StagedFrame& stages_;
    const std::vector<Shader>& shaders_;
    const PixelRect window_;
    Kept kept_;
    std::vector<StepId> step_;  // the step whose colour it has, or kColor
    struct Accumulated {
        Channels<Real> color{};
        bool is_open = false, is_unknown = false, is_undefined = false;
        Whys why = 0;
    };
    std::vector<Accumulated> accumulation_;    // empty until it is used
    std::vector<Channels<Real>> colors_;       // valid where the step is kColor; empty until the first
    std::vector<std::vector<Choice>> others_;  // of open pixels, besides the step; empty until the first
};

// Draws the pixels `within` in bands of rows, and calls visit(buffer, band) for each band, y up. Buffer: a FragmentLoop.
template <class Buffer, class Visit>
void draw_in_bands(const StagedFrame& stages, const std::vector<Shader>& shaders, const PixelRect& within,
                   const Visit& visit) {
    for_each_band(within.y1 - within.y0, [&](int y0, int y1) {
        const PixelRect band{within.x0, within.y0 + y0, within.x1, within.y0 + y1};
        Buffer buffer(stages, shaders, band);
        buffer.draw();
        visit(buffer, band);
    });
}

}  // namespace twinlight::reference
