// A frame for WebGL 2: programs in GLSL ES 3.00, vertices as points, lines and triangles, and the state that page/gl.js sets. What
// OpenGL ES lacks is done here or in the shaders, or is named.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/effect/plan.h"
#include "scene/state/frame.h"

namespace twinlight::web {

struct WebglFrame {
    // JSON. Enumerants are GL's numbers; [first, count] are places in `words`:
    //   {"width", "height",
    //    "programs": [{"vertex", "fragment", "attributes": [4, ...]}],
    //    "textures": [{"target", "format": "rgba8" | "rgba32f" | "depth", "levels", "images": [[face, level, width, height, depth,
    //        first]], "parameters": [[name, value]]}],
    //    "items": [{"clear": ...} | {"accumulate": ...} | {"program", "vertices", "parts": [[mode, first, count]], "uniforms",
    //        "textures": [[unit, sampler, texture]], ...}],
    //    "missing": [{"line", "column", "message"}]}
    std::string header;
    std::vector<std::uint32_t> words;  // vertices, indices and texels
};

// The frame must not show copied pixels: reference::drawable() fills them in.
WebglFrame webgl_frame(const Frame& frame, const PlanOptions& options);

}  // namespace twinlight::web
