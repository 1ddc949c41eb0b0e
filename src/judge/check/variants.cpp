#include "judge/check/variants.h"

#include "render/programmable/precise/precise.h"

namespace twinlight::check {

namespace {

template <class Change>
RenderOptions with(Change change) {
    RenderOptions options;
    options.budget = 0;
    change(options);
    return options;
}

}  // namespace

Variant plain() {
    return {"uniform", with([](RenderOptions&) {})};
}

Variant long_double() {
    return {"long double", with([](RenderOptions& o) { o.arithmetic.number = Number::kLongDouble; })};
}

std::vector<Variant> shader_variants() {
    std::vector<Variant> variants = {
        plain(),
        {"baked", with([](RenderOptions& o) { o.tier = Tier::kBaked; })},
        {"precise", with([](RenderOptions& o) { o.precise = true; })},
        {"flat", with([](RenderOptions& o) { o.shading = Shading::kFlat; })},
        {"phong", with([](RenderOptions& o) { o.shading = Shading::kPhong; })},
        {"baked phong", with([](RenderOptions& o) {
             o.tier = Tier::kBaked;
             o.shading = Shading::kPhong;
         })},
    };
    if (!programmable::has_precise()) std::erase_if(variants, [](const Variant& v) { return v.options.precise; });
    return variants;
}

// Powers from a table, the accuracy study's third choice, are off by design.
std::vector<Variant> reference_variants() {
    return {
        long_double(),
        {"double", with([](RenderOptions&) {})},
        {"float", with([](RenderOptions& o) { o.arithmetic.number = Number::kFloat; })},
        {"double, squaring", with([](RenderOptions& o) { o.arithmetic.powers = Powers::kSquaring; })},
    };
}

}  // namespace twinlight::check
