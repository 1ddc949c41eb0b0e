// A texture for WebGL 2. OpenGL ES lacks border colours (GL 2.1, section 3.8.7): a rim of one texel around the image takes their place.
// OpenGL ES 3.0 filters cube maps across the borders of their faces (3.8.10), OpenGL 2.1 filters each face by itself.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "base/text/json.h"
#include "render/programmable/export/export_words.h"
#include "scene/frame/frame.h"

namespace twinlight::webgl {

// Not with mipmaps, because the rim of each level would need other coordinates, and not around cube maps.
bool has_rim(const Texture& texture);
// Whether a border shows that no rim can replace.
bool lacks_border(const Texture& texture);

// A cube map whose faces are filtered linearly with the texels of their own edges: coordinates that stay half a texel away from the
// borders give the same.
bool stays_on_faces(const Texture& texture);
// Whether faces are filtered in a way that OpenGL ES cannot: with repeated texels or mipmaps.
bool lacks_faces(const Texture& texture);

// An element of WebglFrame's "textures". Appends the texels, with the rim on the sides that show the border, to the words.
Json texture_json(const Texture& texture, programmable::ExportWords& words);
// The part of s, t and r that is within the rim: N / (N + 2) of N texels, or 1 without a rim. Of a cube map that stays on its faces:
// the part between the middles of the outer texels, (N - 1) / N.
glm::dvec3 part_inside(const Texture& texture);

}  // namespace twinlight::webgl
