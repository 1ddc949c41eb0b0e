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
#include <limits>
#include <type_traits>
#include <vector>

#include "render/reference/coverage.h"
#include "render/reference/fragment_operations.h"
#include "render/reference/staged_frame.h"

namespace twinlight::reference {

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
//   is_open(at), open(at), settle(at)         whether the colour is open; marks it as open; as certain
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
            for (std::size_t i = step.first_piece; i < step.end_piece; ++i) piece(static_cast<StepId>(i), watch);
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
            if (clear.accumulation) accumulation_[at] = {channels<Real>(clear.clear_accumulation), false};
            if (clear.depth) kept_.set_depth(at, id, clear.clear_depth, Outcome::kPasses);
            if (!clear.color) return;
            if (overwrites)
                wait(id, at);
            else
                write(mask, {channels<Real>(clamped(clear.clear_color))}, x, y);
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
            Real depth{};
            Shaded<Real> shaded;
            // The order of the tests matters only to the stencil: both others must pass. If the pixel is open anyway,
            // its colour is not needed.
            const bool stays_open = kept_.is_open(at) && !overwrites_color(state);
            const auto alpha_test = [&] {
                if (waits || !((writes && !stays_open) || state.alpha_test) || outcome != Outcome::kPasses) return;
                shaded = shaders_[piece.draw].template shade<Real>(fragment);
                if (piece.is_smooth) shaded.color[3] = shaded.color[3] * Real(coverage_of(piece, x, y));
                if (state.alpha_test) outcome = alpha_outcome(state, shaded.color[3]);
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
                outcome = std::min({outcome, stencil, of_depth});
            } else {
                if (raster.depth_test) {
                    depth = kept_.depth(fragment);
                    outcome = std::min(outcome, kept_.depth_outcome(raster.depth_func, fragment, depth, at));
                }
                if (outcome != Outcome::kFails) alpha_test();
            }
            if (outcome == Outcome::kFails) return outcome;
            // 4.1.6: without the depth test the depth buffer does not change.
            if (raster.depth_test && raster.depth_mask) kept_.set_depth(at, id, depth, outcome);
            if (!writes) return outcome;
            if (outcome == Outcome::kOpen)
                kept_.open(at);
            else if (waits)
                wait(id, at);
            else if (!stays_open)
                write(state, shaded, x, y);
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
                write(mask, result, x, y);
                if (stored.is_open) kept_.open(at);
                return;
            }
            const bool reads = accumulate.op == kGL_ACCUM || accumulate.op == kGL_LOAD;
            const Channels<Real> color = reads ? resolved(x, y) : Channels<Real>{};
            stored.is_open = (accumulate.op != kGL_LOAD && stored.is_open) || (reads && kept_.is_open(at));
            for (std::size_t i = 0; i < color.size(); ++i) {
                const Real result = accumulated(accumulate, stored.color[i], held(color[i]));
                stored.is_open |= leaves_accumulation(result);
                stored.color[i] = kept_accumulation(result);
            }
        });
    }
    void need_accumulation() {
        if (accumulation_.empty()) accumulation_.resize(window_.count());
    }

    // From now on the pixel has the step's colour, lit later.
    void wait(StepId id, std::size_t at) {
        step_[at] = id;
        kept_.settle(at);
    }

    void write(const FragmentState& state, const Shaded<Real>& source, int x, int y) {
        const std::size_t at = window_.index(x, y);
        Channels<Real> beneath{};
        if (overwrites_color(state))
            kept_.settle(at);
        else  // the fragment uses the colour beneath as the colour buffer stores it
            for (std::size_t i = 0; const Real& channel : resolved(x, y)) beneath[i++] = held(channel);
        if (colors_.empty()) colors_.resize(step_.size());
        colors_[at] = written(state, source.color, beneath);
        step_[at] = kColor;
        if (source.has_choice) kept_.open(at);
    }

  protected:
    static constexpr StepId kColor = std::numeric_limits<StepId>::min();

    // The pixel's colour; lights the step if it was delayed.
    Channels<Real> resolved(int x, int y) {
        const std::size_t at = window_.index(x, y);
        const StepId id = step_[at];
        if (id == kColor) return colors_[at];
        if (id < 0) return channels<Real>(clamped(stages_.clear(id).clear_color));
        const Piece& piece = stages_.piece(id);
        const Shaded<Real> shaded = shaders_[piece.draw].template shade<Real>({&piece, pixel_centre(x, y)});
        if (shaded.has_choice) kept_.open(at);
        return shaded.color;
    }

    const StagedFrame& stages_;
    const std::vector<Shader>& shaders_;
    const PixelRect window_;
    Kept kept_;
    std::vector<StepId> step_;  // the step whose colour it has, or kColor
    struct Accumulated {
        Channels<Real> color{};
        bool is_open = false;
    };
    std::vector<Accumulated> accumulation_;  // empty until it is used
    std::vector<Channels<Real>> colors_;     // valid where the step is kColor; empty until the first
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
