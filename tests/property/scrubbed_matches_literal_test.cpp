// The fixed function draws the same picture with scrubbed state as with all commands: for the built-in scenes and for
// random states.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "judge/compare/comparison.h"
#include "judge/compare/departures.h"
#include "judge/fuzz/fuzzer.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "render/effect/scrubbed_state.h"
#include "render/fixed/fixed.h"
#include "render/fixed/replay.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::scrubbed_matches_literal_test {
namespace {

// A comparison whose first pair is scrubbed ~ literal, and whose second is scrubbed ~ reference.
compare::Comparison compare_scrubbed(const Scene& scene, double budget) {
    const compare::Renderers renderers = {
        .fixed = [budget](const Scene& s,
                          const fixed::Options& options) { return fixed::render_scrubbed(s, options.shading, budget); },
        .programmable = [&](const Frame&,
                            const programmable::Options& options) { return fixed::render(scene, {options.shading}); },
        .reference = reference::render,
        .allowed_difference = reference::allowed_difference,
    };
    return compare::compare_scene(scene, {.per_vertex_only = true}, renderers);
}

void expect_within(const compare::Comparison& comparison, std::size_t pair_number, double budget) {
    const compare::Pair& pair = comparison.pairs.at(pair_number);
    const RegionDifference& beyond = pair.difference.beyond_allowed;
    // The budget changes a channel before it is rounded, and rounding can add 1/255.
    EXPECT_LE(beyond.max, comparison.tolerance.max + budget) << fmt::format(
        "{}: {}, pair {}: {} of {} interior pixels differ, the worst at {},{}", comparison.scene,
        comparison.pairs.size(), pair_number, beyond.differing, beyond.pixels, beyond.worst_x, beyond.worst_y);
}

constexpr std::size_t kLiteral = 0, kReference = 1;

TEST(Scrubbed, DrawsTheBuiltInScenesAsLiterally) {
    constexpr int kSide = 256;
    for (const EmbeddedFile& file : kSceneFiles) {
        const auto scene = std::make_shared<const CommandList>(read_built_in(file));
        const Scene made = make_scene(scene, {.width = kSide, .height = kSide});
        const auto context = make_offscreen_context(kSide, kSide);
        for (const double budget : {0.0, PlanOptions{}.budget}) {
            const compare::Comparison comparison = compare_scrubbed(made, budget);
            expect_within(comparison, kLiteral, budget);
            if (budget != 0) continue;
            const ImageDifference& difference = comparison.pairs[kLiteral].difference;
            fmt::print("{}: {} of {} interior pixels differ, {} beyond what is allowed; {} of {} at edges\n", file.name,
                       difference.interior.differing, difference.interior.pixels, difference.beyond_allowed.differing,
                       difference.edge.differing, difference.edge.pixels);
            EXPECT_LT(difference.beyond_allowed.differing_share(), comparison.tolerance.differing_share);
        }
    }
}

// In double precision: skipped effects add exactly 0, but a value may round to the next step of 1/255.
TEST(Scrubbed, IsTheSameToTheReference) {
    constexpr int kSide = 256;
    for (const EmbeddedFile& file : kSceneFiles) {
        SCOPED_TRACE(file.name);
        const auto scene = std::make_shared<const CommandList>(read_built_in(file));
        const Frame frame = make_frame(*scene, {.width = kSide, .height = kSide});
        for (const std::optional<Shading> shading : {std::optional<Shading>(), std::optional(Shading::kPhong)}) {
            const PlanOptions options{{.shading = shading}, 0};
            const Image whole = reference::render(frame, reference::Options{options});
            const Image scrubbed = reference::render(scrubbed_frame(frame, options), reference::Options{options});
            std::size_t differing = 0;
            float worst = 0;
            for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
                differing += whole.pixels[i] != scrubbed.pixels[i];
                for (std::size_t c = 0; c < 4; ++c)
                    worst = std::max(worst, std::abs(whole.pixels[i][c] - scrubbed.pixels[i][c]));
            }
            EXPECT_LE(worst, 1.001F / 255);
            EXPECT_LT(differing, whole.pixels.size() / 10'000);
        }
    }
}

TEST(Scrubbed, DrawsRandomStatesAsLiterally) {
    constexpr int kSide = 64;
    const fuzz::Options options{{.seed = 7}};
    const auto context = make_offscreen_context(kSide, kSide);
    std::size_t compared = 0, departures = 0, pixels = 0, differing = 0;
    for (std::uint64_t i = 0; i < 96; ++i) {
        // Every other state is one of fragments; their structures are far apart.
        const std::uint64_t state = i * 97 * fuzz::kPictureEvery + (i % 2 == 0 ? fuzz::kPictureEvery - 1 : i % 31);
        const auto scene = std::make_shared<const CommandList>(fuzz::random_scene(options, state));
        const Scene made = make_scene(scene, {.width = kSide, .height = kSide});
        if (compare::DeparturesOfScene(*scene, current_driver(), {}).in(made.frame)) {
            ++departures;
            continue;
        }
        SCOPED_TRACE(fmt::format("twinlight fuzz --seed 7 --first {} --count 1\n{}", state, print_scene(*scene)));
        const double budget = i % 4 < 2 ? 0 : PlanOptions{}.budget;
        const compare::Comparison comparison = compare_scrubbed(made, budget);
        expect_within(comparison, kLiteral, budget);
        expect_within(comparison, kReference, budget);
        ++compared;
        if (budget != 0) continue;
        pixels += comparison.pairs[kLiteral].difference.beyond_allowed.pixels;
        differing += comparison.pairs[kLiteral].difference.beyond_allowed.differing;
    }
    fmt::print("{} compared, {} skipped for known bugs of the driver; {} of {} interior pixels differ\n", compared,
               departures, differing, pixels);
    EXPECT_GT(compared, departures);
    EXPECT_LT(static_cast<double>(differing), compare::Tolerance{}.differing_share * static_cast<double>(pixels));
}

}  // namespace
}  // namespace twinlight::scrubbed_matches_literal_test
