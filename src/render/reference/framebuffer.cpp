#include "render/reference/framebuffer.h"

#include "render/reference/reference.h"

namespace twinlight::reference {

std::optional<StepId> Framebuffer::step(int x, int y) const {
    const StepId id = step_[window_.index(x, y)];
    return id == kColor ? std::nullopt : std::optional(id);
}

// Those that wait are lit Draw by Draw, all at once.
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

// ---- The picture ----

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

std::vector<int> seen_shapes(const Frame& frame, const Options& options) {
    const StagedFrame stages = run_stages(frame, options);
    const std::vector<int> numbers = shape_numbers(stages);
    std::vector<int> seen(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), -1);
    draw_in_bands<Framebuffer>(stages, frame, options, [&](const Framebuffer& framebuffer, const PixelRect& band) {
        for_each(band, [&](int x, int y) {
            const std::optional<StepId> step = framebuffer.step(x, y);
            if (!step || *step < 0) return;
            const std::size_t row = static_cast<std::size_t>(frame.height - 1 - y);
            seen[row * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x)] =
                numbers[stages.piece(*step).draw];
        });
    });
    return seen;
}

Image render(const Frame& frame, const Options& options) {
    Image image(frame.width, frame.height);
    const StagedFrame stages = run_stages(frame, options);
    draw_in_bands<Framebuffer>(stages, frame, options, [&](Framebuffer& framebuffer, const PixelRect& band) {
        const std::vector<Channels<double>> colors = framebuffer.colors();
        for_each(band, [&](int x, int y) { image.at(x, frame.height - 1 - y) = rgba(colors[band.index(x, y)]); });
    });
    return image;
}

}  // namespace twinlight::reference
