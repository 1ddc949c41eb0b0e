// Tests of what one pixel shows. All renderers must give it the same colour.
#pragma once

#include <array>
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

    // The colour at a pixel (y up), which the reference and the fixed function must agree on.
    Rgba color_without_shaders(const Scene& scene, int x, int y, const std::string& text) {
        EXPECT_TRUE(scene.frame.unsupported.empty()) << text;
        const Rgba expected = at(reference::render(scene.frame, {}), x, y);
        expect_color("fixed", at(fixed::render(scene), x, y), expected, text);
        return expected;
    }
    // The same for all renderers.
    Rgba color(const Scene& scene, int x, int y, const std::string& text) {
        const Rgba expected = color_without_shaders(scene, x, y, text);
        fixed::Replay(scene.frame, {}).draw();
        expect_color("replayed", read_at(x, y), expected, text);
        expect_color("shaders", at(renderer_.render(scene.frame, {}), x, y), expected, text);
        return expected;
    }
    // `shaders`: whether to make a program.
    Rgba color(const std::string& text, int x = 8, int y = 8, bool shaders = true) {
        const Scene scene = scene_of(text);
        if (!shaders) return color_without_shaders(scene, x, y, text);
        const Rgba expected = color(scene, x, y, text);
        fixed::Replay(scene.frame, {.scrub = fixed::Scrub::kState}).draw();
        expect_color("replayed, scrubbed", read_at(x, y), expected, text);
        return expected;
    }
    // The same as 8-bit values, and as what is uploaded once.
    using Codes = std::array<int, 4>;
    Codes codes(const Scene& scene, int x, int y, const std::string& text) {
        const Rgba expected = color(scene, x, y, text);
        renderer_.draw(programmable::UploadedFrame(scene.frame, {}));
        expect_color("uploaded", read_at(x, y), expected, text);
        Codes result{};
        for (std::size_t i = 0; i < 4; ++i) result[i] = channel_code(expected[i]);
        return result;
    }
    Codes codes(const std::string& text, int x = 8, int y = 8) { return codes(scene_of(text), x, y, text); }

  private:
    static Rgba at(const Image& image, int x, int y) { return image.at(x, kSide - 1 - y); }
    static Rgba read_at(int x, int y) { return at(read_pixels(kSide, kSide), x, y); }
};

}  // namespace twinlight
