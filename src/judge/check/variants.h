// The shaders' tiers and shadings, and the reference's numbers, that every case is checked with.
#pragma once

#include <string>
#include <vector>

#include "render/programmable/shader_options.h"
#include "render/reference/reference_options.h"

namespace twinlight::check {

// Whole: nothing is left out, and the lecture's variants are in.
template <class Options>
struct Variant {
    std::string name;
    Options options;
};
using ShaderVariant = Variant<programmable::Options>;
using ReferenceVariant = Variant<reference::Options>;

ShaderVariant plain();  // with uniforms
ReferenceVariant long_double();

// As far as the current context has them.
std::vector<ShaderVariant> shader_variants();
std::vector<ReferenceVariant> reference_variants();

}  // namespace twinlight::check
