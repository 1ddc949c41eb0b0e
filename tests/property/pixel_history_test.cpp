// The fragments that `twinlight explain --pixel` lists end with exactly the colour of the picture.
#include "render/reference/pixel_history.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "../unit/effort.h"
#include "judge/fuzz/fuzzer.h"
#include "render/reference/reference.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::reference::pixel_history_test {
namespace {

constexpr StateOptions kSize{.width = 64, .height = 64};

// Numbers of pixels with a blended fragment, with a failing one, and with several that pass.
struct Seen {
    int blended = 0, failing = 0, several = 0;
};

Rgba rounded(const glm::dvec4& color) {
    return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b),
            static_cast<float>(color.a)};
}

// Whether the colours change after the Draw: by a clear, or by glAccum(GL_RETURN). Its index counts only Draws.
bool is_replaced_after(const Frame& frame, std::size_t draw) {
    std::size_t draws = 0;
    for (const auto& item : frame.items) {
        const Accumulate* accumulate = std::get_if<Accumulate>(&item);
        const bool replaces = std::holds_alternative<Clear>(item) || (accumulate && accumulate->op == kGL_RETURN);
        if (replaces && draws > draw) return true;
        draws += std::holds_alternative<Draw>(item);
    }
    return false;
}

// At random pixels of the picture.
void expect_the_pictures(const Frame& frame, const Options& options, std::mt19937& random, int pixels, Seen& seen) {
    const Image picture = render(frame, options);
    for (int i = 0; i < pixels; ++i) {
        const int x = static_cast<int>(random() % 64), y = static_cast<int>(random() % 64);
        SCOPED_TRACE(fmt::format("pixel {},{}", x, y));
        const PixelHistory history = pixel_history(frame, options, x, frame.height - 1 - y);
        ASSERT_EQ(history.color, picture.at(x, y));
        std::optional<Rgba> last;
        std::size_t last_draw = 0;
        int passing = 0;
        bool failing = false, blended = false;
        for (const PixelFragment& fragment : history.fragments) {
            failing = failing || !fragment.passes;
            if (!fragment.passes) continue;
            ++passing;
            last = rounded(fragment.after);
            last_draw = fragment.draw;
            blended = blended || fragment.after != fragment.color;
        }
        if (last && !is_replaced_after(frame, last_draw)) {
            ASSERT_EQ(*last, picture.at(x, y));
        }
        seen.several += passing > 1;
        seen.failing += failing;
        seen.blended += blended;
    }
}

TEST(PixelHistory, EndsInThePicturesColorInTheBuiltInScenes) {
    std::mt19937 random(15);
    Seen seen;
    for (const char* name : {"commands", "lab", "legacy", "report", "spectral"}) {
        const Frame frame = make_frame(*load_commands(name), kSize);
        for (const std::optional<Shading> shading : {std::optional<Shading>(), std::optional(Shading::kFlat),
                                                     std::optional(Shading::kPhong), std::optional(Shading::kExact)}) {
            SCOPED_TRACE(fmt::format("{}, shading {}", name, shading ? static_cast<int>(*shading) : -1));
            Options options;
            options.shading = shading;
            const bool is_varied = std::string_view(name) == "legacy" || std::string_view(name) == "commands";
            expect_the_pictures(frame, options, random, rounds(is_varied ? 100 : 10), seen);
        }
    }
    EXPECT_GT(seen.blended, least_found(5));
    EXPECT_GT(seen.failing, least_found(20));
    EXPECT_GT(seen.several, least_found(50));
}

// Scenes of the fuzzer: alpha test, blending, masks, scissors, polygon modes, textures and fog, in all combinations.
TEST(PixelHistory, EndsInThePicturesColorInRandomScenes) {
    std::mt19937 random(16);
    Seen seen;
    for (std::uint64_t picture = 0; picture < 200; ++picture) {
        const std::uint64_t state =
            picture * fuzz::kPicturesPerStructure * fuzz::kPictureEvery + fuzz::kPictureEvery - 1;
        SCOPED_TRACE(fmt::format("seed 20, state {}", state));
        const CommandList scene = fuzz::random_scene({{.seed = 20}}, state);
        Options options;
        if (picture % 3 == 2) options.shading = Shading::kPhong;
        expect_the_pictures(make_frame(scene, kSize), options, random, 30, seen);
    }
    EXPECT_GT(seen.blended, 100);
    EXPECT_GT(seen.failing, 100);
    EXPECT_GT(seen.several, 100);
}

}  // namespace
}  // namespace twinlight::reference::pixel_history_test
