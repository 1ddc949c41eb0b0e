// Border colours of textures (GL 2.1, section 3.8.7), which OpenGL ES lacks: a rim of one texel around the image takes their place.
#pragma once

#include <glm/vec3.hpp>

#include "scene/state/frame.h"

namespace twinlight::webgl {

// Not with mipmaps, because the rim of each level would need other coordinates, and not around cube maps.
bool has_rim(const Texture& texture);
// Whether a border shows that no rim can replace.
bool lacks_border(const Texture& texture);

// The base level with the rim, on the sides that show the border.
Texture with_rim(const Texture& texture);
// The part of s, t and r that is within the rim: N / (N + 2) of N texels, or 1 without a rim.
glm::dvec3 part_inside(const Texture& texture);

}  // namespace twinlight::webgl
