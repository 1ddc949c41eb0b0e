// The picture: a framebuffer of numbers.
#pragma once

#include <optional>
#include <vector>

#include "render/reference/fragment_loop.h"

namespace twinlight::reference {

// The state of a pixel besides its colour: one depth. Nothing is ever open.
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
    void open(std::size_t) {}
    static bool is_open(std::size_t) { return false; }
    void settle(std::size_t) {}

  private:
    const StagedFrame& stages_;
    std::vector<double> depth_;
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

    // The step whose colour the pixel has; nothing if colours were blended.
    std::optional<StepId> step(int x, int y) const;
};

// Draws the pixels `within`, y up, of a picture; others keep their colours.
void draw_pixels(StagedFrame stages, const Options& options, const PixelRect& within, Image& image);

}  // namespace twinlight::reference
