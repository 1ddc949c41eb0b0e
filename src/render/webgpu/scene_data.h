// What draws an export's picture with its shaders, in WebGPU's words: scene.json and scene.bin.
#pragma once

#include <cstdint>
#include <vector>

#include "base/text/json.h"

namespace twinlight::webgpu {

struct SceneData {
    //   {"width", "height",
    //    "textures": [{"dimension": "2d" | "3d" | "cube", "format": "rgba8" | "rgba32f" | "depth" (the largest word is 1), "levels":
    //        [[width, height, depth or 6 faces, first]], "sampler"}],
    //    "state": [{"FrontMaterial.diffuse": [number, ...], ...}], by the names in layout.json
    //    "pipelines": [{"kind", "primitive", "depthStencil", "target"}], as a GPURenderPipelineDescriptor has them
    //    "items": [{"clearColor", "clearDepth", "clearStencil", "scissor", "writeMask", "stencilWriteMask"} |
    //        {"pipeline", "state": [index, ...], "vertices": first, "indices": [first, count], "viewport", "depthRange",
    //         "textures": [[binding, index]], "scissor", "stencilReference", "blendConstant"}]}
    // Places are counted in 4 bytes of `words`.
    Json json;
    std::vector<std::uint32_t> words;  // vertices, indices and texels
};

// `header`, `words`: a frame for any pose (webgl/webgl_frame.h). Throws std::runtime_error, which says what WebGPU lacks.
// allows_formats: also depth textures and those of floats, which WebGPU does not fill or filter.
SceneData scene_data(const Json& header, const std::vector<std::uint32_t>& words, bool allows_formats);

}  // namespace twinlight::webgpu
