#include "scene/frame/pixel_image.h"

#include <utility>

namespace twinlight {

namespace {

constexpr Enum kRgba32f = 0x8814;  // GL_RGBA32F (GL 3.0, table 3.16)
constexpr std::size_t kFewPixels = 64;

// 0 x 0 if there is no such rectangle.
glm::ivec2 size_of_rectangle(const std::vector<glm::ivec2>& places) {
    const glm::ivec2 size = places.back() - places.front() + 1;
    if (size.x < 1 || size.y < 1 ||
        static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) != places.size())
        return {0, 0};
    glm::ivec2 at{0, 0};
    for (const glm::ivec2& place : places) {
        if (place != places.front() + at) return {0, 0};
        if (++at.x == size.x) at = {0, at.y + 1};
    }
    return size;
}

}  // namespace

std::shared_ptr<const Texture> image_of_pixels(const std::vector<glm::ivec2>& places,
                                               std::span<const Vertex> vertices) {
    if (places.size() < kFewPixels) return nullptr;
    const glm::ivec2 size = size_of_rectangle(places);
    if (size.x == 0) return nullptr;
    TextureImage image{.width = size.x, .height = size.y, .internal_format = kRgba32f};
    image.texels.reserve(vertices.size());
    for (const Vertex& vertex : vertices) image.texels.emplace_back(vertex.color);
    Texture texture{
        .min_filter = kGL_NEAREST, .mag_filter = kGL_NEAREST, .wrap_s = kGL_CLAMP_TO_EDGE, .wrap_t = kGL_CLAMP_TO_EDGE};
    texture.levels.push_back(std::move(image));
    return std::make_shared<const Texture>(std::move(texture));
}

}  // namespace twinlight
