// An exported kind of shaders in WGSL: both stages in one module.
#pragma once

#include <string>

#include "render/webgpu/blocks.h"

namespace twinlight::webgpu {

std::string wgsl_module(const Kind& kind, const Blocks& blocks);

// What in a vertex or fragment shader WebGPU cannot do; empty if it can do all.
std::string why_not_in_wgsl(const Kind& kind);
// The same for Vulkan.
std::string why_not_in_vulkan(const Kind& kind);

}  // namespace twinlight::webgpu
