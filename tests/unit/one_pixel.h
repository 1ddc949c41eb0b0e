// Tests of what one pixel shows. All renderers must give it the same colour.
#pragma once

#include <string>

#include "all_renderers.h"

namespace twinlight {

inline constexpr int kSide = 16;  // of the square picture

class OnePixel : public AllRenderers {
  protected:
    OnePixel() : AllRenderers(kSide) {}

    static void expect_color(const char* name, const Rgba& found, const Rgba& expected, const std::string& text) {
        constexpr float kRounding = 0.51F;  // to 8 bits, in 1/255
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(255 * found[i], 255 * expected[i], kRounding) << name << " channel " << i << "\n" << text;
    }

    // The colour at a pixel (y up). `shaders`: whether to make a program.
    Rgba color(const std::string& text, int x = 8, int y = 8, bool shaders = true) {
        const Scene scene = scene_of(text);
        EXPECT_TRUE(scene.frame.unsupported.empty()) << text;
        const auto at = [&](const Image& image) { return image.at(x, kSide - 1 - y); };
        const Rgba expected = at(reference::render(scene.frame, {}));
        expect_color("fixed", at(fixed::render(scene)), expected, text);
        if (!shaders) return expected;
        fixed::Replay(scene.frame, {}).draw();
        expect_color("replayed", at(read_pixels(kSide, kSide)), expected, text);
        fixed::Replay(scene.frame, {.scrub = fixed::Scrub::kState}).draw();
        expect_color("replayed, scrubbed", at(read_pixels(kSide, kSide)), expected, text);
        expect_color("programmable", at(renderer_.render(scene.frame, {}).image), expected, text);
        return expected;
    }
};

}  // namespace twinlight
