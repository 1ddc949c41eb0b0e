// The fuzzer: it finds no unexplained difference in a few thousand random scenes, finds each known bug that is not
// skipped, and reduces failing scenes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "../unit/effort.h"
#include "judge/fuzz/floats.h"
#include "judge/fuzz/fuzzer.h"
#include "judge/fuzz/shrink.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::fuzz::fuzz_test {
namespace {

Driver this_driver() {
    const auto context = make_offscreen_context(1, 1);
    return current_driver();
}

TEST(Fuzz, FindsNoUnexplainedDifference) {
    const Options options{{.count = 2048, .seed = 20}};
    const Summary summary = run(options, {});
    for (const Failure& failure : summary.failures) ADD_FAILURE() << failure_text(failure, options);
    EXPECT_EQ(summary.float_states + summary.picture_states, options.count);
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
        SCOPED_TRACE(kPairNames.at(pair));
        fmt::print("{}: {} vertices, the worst {:.1e} off; {} interior pixels, {} differing\n", kPairNames.at(pair),
                   summary.vertices.at(pair), summary.worst_float.at(pair).value, summary.pixels.at(pair),
                   summary.differing_pixels.at(pair));
        EXPECT_FALSE(summary.too_many_differ(pair));
        // Most vertices must be compared, not skipped. Feedback does not return the secondary colour, so states with
        // one are not compared between fixed and programmable.
        const double share = pair == static_cast<std::size_t>(RendererPair::kFixedProgrammable) ? 0.2 : 0.6;
        EXPECT_GT(static_cast<double>(summary.vertices.at(pair)),
                  share * 3 * static_cast<double>(summary.float_states));
        constexpr double kPixels = 64 * 64;
        // EGL has no accumulation buffer, and pictures that accumulate in a display list are left out.
        const double pixel_share = context_provider() == "EGL" ? 0.55 : 0.6;
        EXPECT_GT(static_cast<double>(summary.pixels.at(pair)),
                  pixel_share * kPixels * static_cast<double>(summary.picture_states));
    }
}

bool filters_anisotropically(const Frame& frame) {
    return std::ranges::any_of(frame.draws(), [](const Draw* draw) {
        bool any = false;
        draw->for_each_unit(
            [&](std::size_t, const TextureUnit& unit) { any = any || unit.texture->max_anisotropy > 1; });
        return any;
    });
}

// Too large an allowed difference would hide everything.
TEST(Fuzz, LeavesLittleOfAPictureOpen) {
    constexpr double kInteriorShare = 0.9, kMeanCodes = 0.15;
    double pixels = 0, interior = 0, codes = 0;
    for (std::uint64_t picture = 0; picture < 150; ++picture) {
        const std::uint64_t state = picture * kPicturesPerStructure * kPictureEvery + kPictureEvery - 1;
        const auto scene = std::make_shared<const CommandList>(random_scene({{.seed = 20}}, state));
        const Frame frame = make_frame(*scene, {.width = 64, .height = 64});
        if (filters_anisotropically(frame)) continue;  // the choice of the filter is the driver's, and leaves much open
        const AllowedDifference allowed = reference::allowed_difference(frame);
        for (std::size_t i = 0; i < allowed.edge.size(); ++i) {
            ++pixels;
            if (allowed.edge[i]) continue;
            ++interior;
            for (const float channel : allowed.channels(i)) codes += 255.0 * static_cast<double>(channel) / 4;
        }
    }
    fmt::print("{:.0f} % of the pixels are interior, with {:.3f} codes allowed on average\n", 100 * interior / pixels,
               codes / interior);
    EXPECT_GT(interior, kInteriorShare * pixels);
    EXPECT_LT(codes, kMeanCodes * interior);
}

TEST(Fuzz, GivesTheSameSceneForTheSameState) {
    for (const std::uint64_t state : {5, 31, 4711}) {
        const CommandList scene = random_scene({{.seed = 3}}, state);
        EXPECT_EQ(scene.commands, random_scene({{.count = 7, .seed = 3, .first = state}}, state).commands);
        EXPECT_NE(scene.commands, random_scene({{.seed = 4}}, state).commands);
        // Read from its file it is the same scene.
        EXPECT_EQ(read_scene(print_scene(scene), "scene.gl", "scene").commands, scene.commands);
    }
}

// The fuzzer finds each known bug that it skips on a driver, if --lift asks for it.
TEST(Fuzz, FindsEachDepartureThatIsLifted) {
    const Driver driver = this_driver();
    if (!compare::is_measured(driver)) GTEST_SKIP() << "another driver may have corrected some";
    if (driver.name == "softpipe") GTEST_SKIP() << "its own known bugs hide most of the others";
    int known = 0;
    for (const compare::Departure& departure : compare::departures()) {
        if (!departure.is_known_on(driver) || !is_tried(known++)) continue;
        SCOPED_TRACE(departure.name);
        // In vertices of several structures, because not every structure shows it; or in pictures.
        Options options{{.count = 64, .seed = 1}, true, false, std::string(departure.name)};
        options.most_failures = 1;
        options.shrinks = false;
        Summary found;
        for (std::uint64_t structure = 0; structure < 4 && found.failures.empty(); ++structure) {
            options.first = structure * kStatesPerStructure;
            found = run(options, {});
        }
        if (found.failures.empty()) {
            options.first = 0;
            options.count = 64 * kPictureEvery;
            options.floats = false;
            options.pictures = true;
            found = run(options, {});
        }
        ASSERT_EQ(found.failures.size(), 1u);
        EXPECT_LT(found.failures[0].pair, kPairs) << found.failures[0].what;
    }
}

TEST(Fuzz, ShrinksAFailureToASceneThatStillFails) {
    if (!compare::is_measured(this_driver())) GTEST_SKIP() << "another driver may not fail";
    Options options{{.count = 16, .seed = 1, .most_failures = 1}};
    options.lifted = "lights after glPopAttrib of GL_ENABLE_BIT";
    const Summary summary = run(options, {});
    ASSERT_EQ(summary.failures.size(), 1u);
    const Failure& failure = summary.failures[0];
    EXPECT_LT(failure.scene.commands.size(), failure.commands_before / 2);
    const std::string text = failure_text(failure, options);
    EXPECT_TRUE(text.starts_with("// twinlight fuzz --seed 1 --first ")) << text;
    EXPECT_NE(text.find("glPopAttrib();"), std::string::npos) << text;
    const auto again = std::make_shared<const CommandList>(read_scene(text, "failure.gl", "failure"));
    Floats floats({options.lifted});
    EXPECT_TRUE(floats.compare(std::span(&again, 1))[0].pairs[failure.pair].fails) << text;
}

TEST(Shrink, KeepsWhatTheFailureNeedsAndNothingElse) {
    const CommandList scene = read_scene(
        "glPushMatrix(); glTranslatef(1, 2, 3); glPushAttrib(GL_FOG_BIT); glEnable(GL_FOG); glPopAttrib(); "
        "glPopMatrix();\n"
        "glNewList(1, GL_COMPILE); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 33.337); glEndList(); glCallList(1);\n"
        "glBegin(GL_POINTS); glVertex3f(0.5, 1.25, 7); glEnd(); glRotatef(34.56, 0, 1, 0);",
        "scene.gl", "scene");
    int questions = 0;
    // A made-up bug: fails for a light's cutoff above 30 and a vertex, in scenes with matching brackets.
    const auto still_fails = [&](const CommandList& candidate) {
        ++questions;
        const std::map<std::string_view, std::string_view> brackets{{"glPushMatrix", "glPopMatrix"},
                                                                    {"glPushAttrib", "glPopAttrib"},
                                                                    {"glBegin", "glEnd"},
                                                                    {"glNewList", "glEndList"}};
        std::vector<std::string_view> open;
        bool cutoff = false, vertex = false;
        for (const Command& command : candidate.commands) {
            const std::string_view name = command.name();
            if (const auto bracket = brackets.find(name); bracket != brackets.end()) open.push_back(bracket->second);
            if (name.starts_with("glPop") || name.starts_with("glEnd")) {
                if (open.empty() || open.back() != name) return false;
                open.pop_back();
            }
            cutoff = cutoff || (name == "glLightf" && command.number(2) > 30);
            vertex = vertex || (name == "glVertex3f" && !open.empty() && open.back() == "glEnd");
        }
        return open.empty() && cutoff && vertex;
    };
    ASSERT_TRUE(still_fails(scene));
    const CommandList smallest = shrink(scene, still_fails);
    EXPECT_EQ(print_scene(smallest),
              "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 33);\nglBegin(GL_POINTS);\nglVertex3f(0, 0, 0);\nglEnd();\n");
    EXPECT_LT(questions, 300);
    questions = 0;
    shrink(scene, still_fails, 10);
    EXPECT_LE(questions, 10);
}

TEST(Fuzz, StopsWhenItIsAsked) {
    int questions = 0;
    Progress progress;
    progress.stop = [&] { return ++questions > 3; };
    const Summary summary = run({{.count = 100000, .seed = 1}}, progress);
    EXPECT_TRUE(summary.broken_off);
    EXPECT_LT(summary.float_states + summary.picture_states, 1000u);
}

}  // namespace
}  // namespace twinlight::fuzz::fuzz_test
