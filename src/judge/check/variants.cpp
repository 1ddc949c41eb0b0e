#include "judge/check/variants.h"

#include "render/context/driver_name.h"
#include "render/programmable/precise_support.h"

namespace twinlight::check {

namespace {

using programmable::Tier;

ShaderVariant shaders(std::string name, const std::optional<Shading>& shading, Tier tier = Tier::kUniform,
                      bool precise = false) {
    return {std::move(name), {{{.shading = shading}, 0}, tier, precise}};
}

ReferenceVariant numbers(std::string name, Arithmetic arithmetic) {
    return {std::move(name), {{}, reference::QuadCut::kFirstToThird, arithmetic}};
}

}  // namespace

ShaderVariant plain() { return shaders("uniform", {}); }

ReferenceVariant long_double() { return numbers("long double", {Number::kLongDouble}); }

std::vector<ShaderVariant> shader_variants() {
    std::vector<ShaderVariant> variants = {
        plain(),
        shaders("baked", {}, Tier::kBaked),
        shaders("precise", {}, Tier::kUniform, true),
        shaders("flat", Shading::kFlat),
        shaders("phong", Shading::kPhong),
        shaders("baked phong", Shading::kPhong, Tier::kBaked),
    };
    // The arithmetic of --precise is that of Mesa's fixed function. It needs an inversesqrt that is exact to the last bit, which
    // GLSL does not require.
    if (!programmable::has_precise() || !current_driver().version.starts_with("Mesa"))
        std::erase_if(variants, [](const ShaderVariant& v) { return v.options.precise; });
    return variants;
}

// Powers from a table, the accuracy study's third choice, are missing: they are inaccurate by design.
std::vector<ReferenceVariant> reference_variants() {
    return {
        long_double(),
        numbers("double", {}),
        numbers("float", {Number::kFloat}),
        numbers("double, squaring", {Number::kDouble, Powers::kSquaring}),
    };
}

}  // namespace twinlight::check
