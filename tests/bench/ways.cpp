#include "ways.h"

#include <memory>
#include <utility>

#include "render/context/gl.h"
#include "render/programmable/programmable.h"

namespace twinlight::bench {

RenderOptions options_for(Tier tier, bool patches) {
    RenderOptions options;
    options.lecture_variants = false;
    options.tier = tier;
    options.patches = patches;
    return options;
}

Way fixed_way(std::string name, const Frame& frame, fixed::Scrub scrub, bool patches) {
    const auto prepared = std::make_shared<fixed::PreparedFrame>(frame, options_for(Tier::kUniform, patches), scrub);
    return {std::move(name), [prepared] {
                prepared->draw();
                glFinish();
            }};
}

Way shader_way(std::string name, const Frame& frame, const RenderOptions& options) {
    const auto renderer = std::make_shared<programmable::Renderer>();
    const auto prepared = std::make_shared<programmable::UploadedFrame>(frame, options);
    return {std::move(name), [renderer, prepared] {
                renderer->draw(*prepared);
                glFinish();
            }};
}

Way shader_way(std::string name, const Frame& frame, Tier tier, bool patches, const std::optional<Shading>& shading) {
    RenderOptions options = options_for(tier, patches);
    options.shading = shading;
    return shader_way(std::move(name), frame, options);
}

}  // namespace twinlight::bench
