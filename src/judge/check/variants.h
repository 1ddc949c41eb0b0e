// What a case is asked of: the shaders' tiers and shadings, the reference's numbers.
#pragma once

#include <string>
#include <vector>

#include "scene/state/frame.h"

namespace twinlight::check {

struct Variant {
    std::string name;
    RenderOptions options;  // whole, a lecture's variants included
};

Variant plain();  // shaders with uniforms, the reference in double
Variant long_double();

// As far as the current context has them.
std::vector<Variant> shader_variants();
std::vector<Variant> reference_variants();

}  // namespace twinlight::check
