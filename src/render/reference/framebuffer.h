// The picture: a framebuffer of numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/reference/fragment_loop.h"

namespace twinlight::reference {

// The state of a pixel besides its colour: one depth and one stencil value. Nothing is ever open.
class DrawnPixels {
  public:
    using Real = double;

    DrawnPixels(const StagedFrame& stages, const PixelRect& window) : stages_(stages), depth_(window.count()) {}

    // All points of a surface are drawn with its first piece.
    template <class Visit>
    void for_each_fragment(StepId id, const PixelRect& within, const Visit& visit) const {
        const Piece& piece = stages_.piece(id);
        if (!piece.rays)
            for_each_pixel(piece, within, [&](int x, int y) { visit(id, x, y, Outcome::kPasses, nullptr); });
        else if (piece.point == 0)
            for_each_point(piece, within, [&](int x, int y, int number, const RayPoint& point) {
                visit(id + number, x, y, Outcome::kPasses, &point);
            });
    }
    static double depth(const Fragment& fragment) {
        return fragment.point ? fragment.point->depth : depth_at(*fragment.piece, fragment.position_window);
    }
    Outcome depth_outcome(Enum depth_func, const Fragment&, double depth, std::size_t at) const {
        return compares(depth_func, depth, depth_[at]) ? Outcome::kPasses : Outcome::kFails;
    }
    void set_depth(std::size_t at, StepId, double depth, Outcome) { depth_[at] = depth; }
    void clear_stencil(const Clear& clear, std::size_t at) { stencil(at) = byte(cleared_stencil(clear, stencil(at))); }
    Outcome stencil_outcome(const StencilFace& face, std::size_t at) {
        return passes_stencil(face, stencil(at)) ? Outcome::kPasses : Outcome::kFails;
    }
    void set_stencil(const StencilFace& face, Outcome, Outcome of_stencil, Outcome of_depth, std::size_t at) {
        const Enum operation = of_stencil == Outcome::kFails ? face.fail
                               : of_depth == Outcome::kFails ? face.depth_fail
                                                             : face.depth_pass;
        stencil(at) = byte(stencil_after(face, operation, stencil(at)));
    }
    void open_stencil(std::size_t) {}
    double depth(std::size_t at) const { return depth_[at]; }
    std::uint8_t stencil(std::size_t at) const { return stencil_.empty() ? std::uint8_t{0} : stencil_[at]; }
    static bool is_open(std::size_t) { return false; }
    static bool is_unknown(std::size_t) { return false; }
    void open(std::size_t, Whys) {}
    void open_to_any(std::size_t, Whys) {}
    void leave_undefined(std::size_t) {}
    static Whys why(std::size_t) { return 0; }
    static bool is_undefined(std::size_t) { return false; }
    void settle(std::size_t) {}

  private:
    static std::uint8_t byte(int value) { return static_cast<std::uint8_t>(value); }
    std::uint8_t& stencil(std::size_t at) {
        if (stencil_.empty()) stencil_.resize(depth_.size());
        return stencil_[at];
    }

    const StagedFrame& stages_;
    std::vector<double> depth_;
    std::vector<std::uint8_t> stencil_;  // empty until it is used
};

// The colour in the type of pictures.
inline Rgba rgba(const Channels<double>& color) {
    return {static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]),
            static_cast<float>(color[3])};
}

class Framebuffer : public FragmentLoop<DrawnPixels> {
  public:
    using FragmentLoop::FragmentLoop;

    // The colours of all pixels, row by row from y0 up, before the last rounding to the bits of the colour buffer.
    std::vector<Channels<double>> colors();

    double depth(int x, int y) const { return kept_.depth(window_.index(x, y)); }
    int stencil(int x, int y) const { return kept_.stencil(window_.index(x, y)); }

    // The step whose colour the pixel has; nothing if colours were blended.
    std::optional<StepId> step(int x, int y) const;
};

// The depth buffer after the last step, or the stencil buffer in 1/255, as red, green and blue.
Image draw_depths(StagedFrame stages, const Options& options, int width, int height);
Image draw_stencils(StagedFrame stages, const Options& options, int width, int height);

// Draws the pixels `within`, y up, of a picture; others keep their colours.
void draw_pixels(StagedFrame stages, const Options& options, const PixelRect& within, Image& image);

}  // namespace twinlight::reference
