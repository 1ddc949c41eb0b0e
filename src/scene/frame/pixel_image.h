// Pixel rectangles as textures.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "scene/frame/frame.h"

namespace twinlight {

// The colours of vertices that are drawn at `places` as a texture, one texel for each; the first texel is at places[0]. Its
// texels are floats, so no colour is rounded. Null if the places are few, or not all those of a rectangle, row by row from the
// lower left corner: then renderers draw a point for each.
std::shared_ptr<const Texture> image_of_pixels(const std::vector<glm::ivec2>& places, std::span<const Vertex> vertices);

}  // namespace twinlight
