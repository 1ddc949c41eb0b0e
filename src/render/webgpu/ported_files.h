// Shaders to keep for WebGPU and Vulkan, with what a porter's program needs to fill their buffers, and the scene as data.
#pragma once

#include <string>
#include <vector>

#include "base/image/named_file.h"
#include "render/look.h"
#include "scene/frame/frame.h"

namespace twinlight::webgpu {

enum class Target { kWgsl, kVulkan };

// kind1.wgsl, ... or kind1.vert, kind1.frag, ...; layout.json, scene.json, scene.bin and README.md; for WebGPU also index.html, which draws
// the scene. The frame must not show copied pixels: reference::drawable() fills them in. Throws std::runtime_error, which names what the
// target lacks.
std::vector<NamedFile> ported_files(const Frame& frame, const Look& look, Target target, const std::string& name);

}  // namespace twinlight::webgpu
