// Exported shaders as GLSL for Vulkan: uniforms in blocks, a number for each binding and location, and Vulkan's clip coordinates.
#pragma once

#include <string>

#include "render/webgpu/blocks.h"

namespace twinlight::webgpu {

std::string vulkan_vertex_shader(const Kind& kind, const Blocks& blocks);
std::string vulkan_fragment_shader(const Kind& kind, const Blocks& blocks);

}  // namespace twinlight::webgpu
