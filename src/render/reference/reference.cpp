// Renders the picture of a frame, and finds its shapes.
#include "render/reference/reference.h"

#include <optional>
#include <utility>

#include "render/reference/copied_pixels.h"
#include "render/reference/framebuffer.h"

namespace twinlight::reference {

namespace {

// By Draw.
std::vector<int> shape_numbers(const StagedFrame& stages) {
    std::vector<int> numbers;
    const Draw* last = nullptr;
    for (const StagedDraw& staged : stages.draws) {
        const Draw& draw = *staged.draw;
        const bool is_same = last && are_one_shape(*last, draw);
        numbers.push_back(numbers.empty() ? 0 : numbers.back() + (is_same ? 0 : 1));
        last = &draw;
    }
    return numbers;
}

}  // namespace

namespace {

// number_of(piece) for the piece that shows at each pixel; -1 where none does.
template <class NumberOf>
std::vector<int> seen(const Frame& frame, const Options& options, StagedFrame stages, const NumberOf& number_of) {
    std::vector<int> seen(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), -1);
    const PixelRect window{0, 0, frame.width, frame.height};
    draw_in_bands<Framebuffer>(stages, make_color_shaders(stages, options), window,
                               [&](const Framebuffer& framebuffer, const PixelRect& band) {
                                   for_each(band, [&](int x, int y) {
                                       const std::optional<StepId> step = framebuffer.step(x, y);
                                       if (!step || *step < 0) return;
                                       const std::size_t row = static_cast<std::size_t>(frame.height - 1 - y);
                                       seen[row * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x)] =
                                           number_of(stages.piece(*step));
                                   });
                               });
    return seen;
}

}  // namespace

std::vector<int> seen_shapes(const Frame& frame, const Options& options) {
    const DrawableFrame whole = drawable(frame, options);
    StagedFrame stages = run_stages(*whole, options);
    const std::vector<int> numbers = shape_numbers(stages);
    return seen(frame, options, std::move(stages), [&](const Piece& piece) { return numbers[piece.draw]; });
}

std::vector<int> seen_draws(const Frame& frame, const Options& options) {
    const DrawableFrame whole = drawable(frame, options);
    return seen(frame, options, run_stages(*whole, options),
                [](const Piece& piece) { return static_cast<int>(piece.draw); });
}

Image render(const Frame& frame, const Options& options) {
    const DrawableFrame whole = drawable(frame, options);
    Image image(frame.width, frame.height);
    draw_pixels(run_stages(*whole, options), options, {0, 0, frame.width, frame.height}, image);
    return image;
}

}  // namespace twinlight::reference
