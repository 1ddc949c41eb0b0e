// The variants that every case runs with: the shaders' tiers and shadings, and the reference's number types.
#pragma once

#include <string>
#include <vector>

#include "render/programmable/numbers/shader_options.h"
#include "render/reference/vertices/reference_options.h"

namespace twinlight::check {

// A name and the options: the planner omits nothing, and the lecture's variants are on.
template <class Options>
struct Variant {
    std::string name;
    Options options;
};
using ShaderVariant = Variant<programmable::Options>;
using ReferenceVariant = Variant<reference::Options>;

ShaderVariant plain();  // with uniforms
ReferenceVariant long_double();

// Those that the current context supports.
std::vector<ShaderVariant> shader_variants();
std::vector<ReferenceVariant> reference_variants();

}  // namespace twinlight::check
