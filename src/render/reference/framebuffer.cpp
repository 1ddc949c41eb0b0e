#include "render/reference/framebuffer.h"

#include <utility>

namespace twinlight::reference {

std::optional<StepId> Framebuffer::step(int x, int y) const {
    const StepId id = step_[window_.index(x, y)];
    return id == kColor ? std::nullopt : std::optional(id);
}

// Lights delayed pixels Draw by Draw, many at once.
std::vector<Channels<double>> Framebuffer::colors() {
    std::vector<Channels<double>> colors(step_.size());
    struct Waiting {
        std::vector<Fragment> fragments;
        std::vector<std::size_t> places;
    };
    std::vector<Waiting> by_draw(shaders_.size());
    for_each(window_, [&](int x, int y) {
        const std::size_t at = window_.index(x, y);
        const StepId id = step_[at];
        if (id < 0) {
            colors[at] = resolved(x, y);
            return;
        }
        const Piece& piece = stages_.piece(id);
        by_draw[piece.draw].fragments.push_back({&piece, pixel_centre(x, y)});
        by_draw[piece.draw].places.push_back(at);
    });
    for (std::size_t draw = 0; draw < by_draw.size(); ++draw) {
        const Waiting& waiting = by_draw[draw];
        const std::vector<Channels<double>> lit = shaders_[draw].colors(waiting.fragments);
        for (std::size_t i = 0; i < lit.size(); ++i) colors[waiting.places[i]] = lit[i];
    }
    return colors;
}

namespace {

// value_of(framebuffer, x, y) as red, green and blue.
template <class ValueOf>
Image draw_values(StagedFrame stages, const Options& options, int width, int height, const ValueOf& value_of) {
    Image image(width, height);
    draw_in_bands<Framebuffer>(stages, make_color_shaders(stages, options), {0, 0, width, height},
                               [&](const Framebuffer& framebuffer, const PixelRect& band) {
                                   for_each(band, [&](int x, int y) {
                                       const auto value = static_cast<float>(value_of(framebuffer, x, y));
                                       image.at(x, height - 1 - y) = {value, value, value, 1};
                                   });
                               });
    return image;
}

}  // namespace

Image draw_depths(StagedFrame stages, const Options& options, int width, int height) {
    return draw_values(std::move(stages), options, width, height,
                       [](const Framebuffer& framebuffer, int x, int y) { return framebuffer.depth(x, y); });
}

Image draw_stencils(StagedFrame stages, const Options& options, int width, int height) {
    return draw_values(std::move(stages), options, width, height, [](const Framebuffer& framebuffer, int x, int y) {
        return framebuffer.stencil(x, y) / static_cast<double>(kMaxStencil);
    });
}

void draw_pixels(StagedFrame stages, const Options& options, const PixelRect& within, Image& image) {
    if (within.is_empty()) return;
    draw_in_bands<Framebuffer>(
        stages, make_color_shaders(stages, options), within, [&](Framebuffer& framebuffer, const PixelRect& band) {
            const std::vector<Channels<double>> colors = framebuffer.colors();
            for_each(band, [&](int x, int y) { image.at(x, image.height - 1 - y) = rgba(colors[band.index(x, y)]); });
        });
}

}  // namespace twinlight::reference
