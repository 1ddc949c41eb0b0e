// The picture.
#include <algorithm>
#include <variant>

#include "render/reference/framebuffer.h"
#include "render/reference/reference.h"

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

// Calls visit(framebuffer, y0, y1) for bands of rows once all of them is drawn; y as GL counts.
template <class Visit>
void draw(const Stages& stages, const Frame& frame, const Options& options, const Visit& visit) {
    const std::vector<Shader> shaders = make_shaders(stages, options);
    for_each_band(frame.height,
                  [&](int y0, int y1) { visit(Framebuffer(stages, shaders, frame.width, y0, y1), y0, y1); });
}

}  // namespace

std::vector<int> seen_shapes(const Frame& frame, const Options& options) {
    const Stages stages = run_stages(frame, options);
    const std::vector<int> numbers = shape_numbers(stages);
    std::vector<int> seen(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), -1);
    draw(stages, frame, options, [&](const Framebuffer& framebuffer, int y0, int y1) {
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < frame.width; ++x) {
                const std::optional<StepId> step = framebuffer.step(x, y);
                if (!step || *step < 0) continue;
                const std::size_t row = static_cast<std::size_t>(frame.height - 1 - y);
                seen[row * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x)] =
                    numbers[stages.piece(*step).draw];
            }
    });
    return seen;
}

bool has_quadrilaterals(const Frame& frame) {
    return std::ranges::any_of(frame.items, [](const auto& item) {
        const Draw* draw = std::get_if<Draw>(&item);
        return draw && (draw->mode == kGL_QUADS || draw->mode == kGL_QUAD_STRIP);
    });
}

Image render(const Frame& frame, const Options& options) {
    Image image(frame.width, frame.height);
    const Stages stages = run_stages(frame, options);
    draw(stages, frame, options, [&](const Framebuffer& framebuffer, int y0, int y1) {
        const std::vector<glm::dvec4> colors = framebuffer.colors();
        auto color = colors.begin();
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < frame.width; ++x) image.at(x, frame.height - 1 - y) = rgba(*color++);
    });
    return image;
}

}  // namespace twinlight::reference
