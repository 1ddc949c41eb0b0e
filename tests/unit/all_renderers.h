// Tests that draw small scenes with every renderer, in a context of their own.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/fixed/replay.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight {

inline std::shared_ptr<const CommandList> list_of(const std::string& text) {
    return std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
}

class AllRenderers : public testing::Test {
  protected:
    explicit AllRenderers(int side) : side_(side), context_(make_offscreen_context(side, side)) {}

    Scene scene_of(const std::string& text) const {
        return make_scene(list_of(text), {.width = side_, .height = side_});
    }

    struct Picture {
        const char* name;
        Image image;
    };
    // By the reference first, then by all others.
    std::vector<Picture> pictures(const Scene& scene) {
        std::vector<Picture> all;
        all.push_back({"reference", reference::render(scene.frame, {})});
        all.push_back({"fixed", fixed::render(scene)});
        fixed::Replay(scene.frame, {}).draw();
        all.push_back({"replayed", read_pixels(side_, side_)});
        all.push_back({"shaders", renderer_.render(scene.frame, {})});
        programmable::Options kept;
        kept.tier = programmable::Tier::kAuto;
        all.push_back({"shaders, kept", renderer_.render(scene.frame, kept)});
        return all;
    }

    const int side_;  // of the square picture
    std::unique_ptr<OffscreenContext> context_;
    programmable::Renderer renderer_;
};

}  // namespace twinlight
