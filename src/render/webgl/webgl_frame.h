// A frame for WebGL 2: programs in GLSL ES 3.00, vertices as points, lines and triangles, and the state that gl.js sets. What OpenGL ES
// lacks is done here or in the shaders, or is named. The page for browsers draws such frames, and so does an exported page.
#pragma once

#include <cstdint>
#include <vector>

#include "base/text/json.h"
#include "render/effect/plan.h"
#include "render/programmable/export/export_words.h"
#include "scene/frame/frame.h"

namespace twinlight::webgl {

struct WebglFrame {
    // Enumerants are GL's numbers; [first, count] are places in `words`:
    //   {"width", "height",
    //    "programs": [{"vertex", "fragment", "attributes": [4, ...]}],
    //    "textures": [{"target", "format": "rgba8" | "rgba32f" | "depth", "levels", "images": [[face, level, width, height, depth,
    //        first]], "parameters": [[name, value]]}],
    //    "uniforms": [{name: [number, ...]}],
    //    "items": [{"clear": ...} | {"accumulate": ...} | {"program", "vertices", "parts": [[mode, first, count]],
    //        "passes": [[index into uniforms, ...]], "textures": [[unit, sampler, texture]],
    //        "framebuffer": sampler of the picture before each part,
    //        "sides": each part is drawn once for each face, ...}],
    //    "missing": [{"line", "column", "message"}],
    //    "labels": [{"text", "at": [x, y]}], texts of the scene over the picture, in pixels from its upper left corner; only if there are any,
    //    "middle": [x, y, z], what the camera turns around, in eye coordinates: only for any pose}
    Json header;
    std::vector<std::uint32_t> words;  // vertices, indices and texels
};

// The frame must not show copied pixels: reference::drawable() fills them in. With options.for_any_pose the programs are those of
// programmable/export/kept_code.h, and the uniforms GL's state (kept_values.h), which viewer.js changes as the camera turns.
WebglFrame webgl_frame(const Frame& frame, const PlanOptions& options);
// The header of a frame that shares `words` with others. keeps_shading: no viewer of a frame for any pose switches to flat shading.
Json webgl_header(const Frame& frame, const PlanOptions& options, programmable::ExportWords& words,
                  bool keeps_shading = false);

}  // namespace twinlight::webgl
