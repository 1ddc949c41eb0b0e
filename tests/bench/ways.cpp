#include "ways.h"

#include <memory>
#include <utility>

#include "render/context/gl.h"
#include "render/programmable/programmable.h"

namespace twinlight::bench {

programmable::Options options_for(programmable::Tier tier, bool patches) {
    programmable::Options options;
    options.lecture_variants = false;
    options.tier = tier;
    options.patches = patches;
    return options;
}

Way fixed_way(std::string name, const Frame& frame, fixed::Scrub scrub, bool patches) {
    const auto prepared =
        std::make_shared<fixed::Replay>(frame, fixed::ReplayOptions{.scrub = scrub, .patches = patches});
    return {std::move(name), [prepared] {
                prepared->draw();
                glFinish();
            }};
}

Way shader_way(std::string name, const Frame& frame, const programmable::Options& options) {
    const auto renderer = std::make_shared<programmable::Renderer>();
    const auto prepared = std::make_shared<programmable::UploadedFrame>(frame, options);
    return {std::move(name), [renderer, prepared] {
                renderer->draw(*prepared);
                glFinish();
            }};
}

Way shader_way(std::string name, const Frame& frame, programmable::Tier tier, bool patches,
               const std::optional<Shading>& shading) {
    programmable::Options options = options_for(tier, patches);
    options.shading = shading;
    return shader_way(std::move(name), frame, options);
}

}  // namespace twinlight::bench
