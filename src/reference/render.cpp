// The picture.
#include "reference/framebuffer.h"
#include "reference/reference.h"

namespace twinlight::reference {

namespace {

Rgba rgba(const glm::dvec4& color) {
    return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b),
            static_cast<float>(color.a)};
}

}  // namespace

Image render(const Frame& frame, const RenderOptions& options) {
    const Stages stages = run_stages(frame, options);
    const std::vector<Shader> shaders = make_shaders(stages, options);
    Image image(frame.width, frame.height);
    for_each_band(frame.height, [&](int y0, int y1) {
        const Framebuffer framebuffer(stages, shaders, frame.width, y0, y1);
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < frame.width; ++x) image.at(x, frame.height - 1 - y) = rgba(framebuffer.color(x, y));
    });
    return image;
}

}  // namespace twinlight::reference
