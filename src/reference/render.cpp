// The picture.
#include "reference/framebuffer.h"
#include "reference/reference.h"

namespace twinlight::reference {

namespace {

Rgba rgba(const glm::dvec4& color) {
    return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b),
            static_cast<float>(color.a)};
}

// By Draw.
std::vector<int> shape_numbers(const Stages& stages) {
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

// Calls visit(framebuffer, x, y, row) for every pixel once all is drawn: x and y as GL counts, row from the top.
template <class Visit>
void draw(const Stages& stages, const Frame& frame, const RenderOptions& options, const Visit& visit) {
    const std::vector<Shader> shaders = make_shaders(stages, options);
    for_each_band(frame.height, [&](int y0, int y1) {
        const Framebuffer framebuffer(stages, shaders, frame.width, y0, y1);
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < frame.width; ++x) visit(framebuffer, x, y, frame.height - 1 - y);
    });
}

}  // namespace

std::vector<int> seen_shapes(const Frame& frame, const RenderOptions& options) {
    const Stages stages = run_stages(frame, options);
    const std::vector<int> numbers = shape_numbers(stages);
    std::vector<int> seen(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), -1);
    draw(stages, frame, options, [&](const Framebuffer& framebuffer, int x, int y, int row) {
        const std::optional<StepId> step = framebuffer.step(x, y);
        if (!step || *step < 0) return;
        seen[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x)] =
            numbers[stages.piece(*step).draw];
    });
    return seen;
}

Image render(const Frame& frame, const RenderOptions& options) {
    Image image(frame.width, frame.height);
    draw(run_stages(frame, options), frame, options, [&](const Framebuffer& framebuffer, int x, int y, int row) {
        image.at(x, row) = rgba(framebuffer.color(x, y));
    });
    return image;
}

}  // namespace twinlight::reference
