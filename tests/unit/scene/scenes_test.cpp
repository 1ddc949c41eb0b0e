// The built-in scenes: each is a valid scene, compiles as C, and has the numbers of the lecture that it comes from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "base/image/delta_e.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/scenes/images.h"
#include "scene/scenes/load.h"
#include "scene/scenes/meshes.h"
#include "scene/spectrum/spectrum.h"
#include "scene/state/state.h"

namespace twinlight::scenes_test {
namespace {

std::string name_of(const EmbeddedFile& file) { return std::string(file.name.substr(0, file.name.rfind(".gl"))); }

CommandList read(std::string_view name) {
    for (const EmbeddedFile& file : kSceneFiles) {
        if (name_of(file) == name) return read_built_in(file);
    }
    ADD_FAILURE() << "there is no scene " << name;
    return {};
}

Frame frame_of(CommandList scene) { return make_frame(std::move(scene), StateOptions{}); }

std::vector<Draw> draws(const Frame& frame) {
    std::vector<Draw> result;
    for (const auto& item : frame.items) {
        if (const Draw* draw = std::get_if<Draw>(&item)) result.push_back(*draw);
    }
    return result;
}

TEST(Scenes, BeginWithACommentThatSaysWhatTheyAre) {
    for (const EmbeddedFile& file : kSceneFiles) {
        EXPECT_TRUE(file.text.starts_with("// ")) << file.name;
        EXPECT_NE(file.text.substr(0, file.text.find('\n')).find(' ', 3), std::string_view::npos) << file.name;
    }
}

// The scene, or all its steps.
std::vector<CommandList> read_steps(const EmbeddedFile& file) {
    std::vector<CommandList> steps{read_built_in(file)};
    for (std::size_t step = 2; step <= steps[0].steps.size(); ++step)
        steps.push_back(read_built_in(file, {.step = std::to_string(step)}));
    return steps;
}

std::vector<CommandList> all_steps() {
    std::vector<CommandList> all;
    for (const EmbeddedFile& file : kSceneFiles)
        for (CommandList& step : read_steps(file)) all.push_back(std::move(step));
    return all;
}

TEST(Scenes, RaiseNoErrorAndAreDrawnWhole) {
    for (const CommandList& scene : all_steps()) {
        const Frame frame = frame_of(scene);
        EXPECT_FALSE(draws(frame).empty()) << scene.title();
        for (const Unsupported& missing : frame.unsupported) {
            ADD_FAILURE() << missing.first.str() << ": " << missing.name << " is not drawn by every renderer";
        }
    }
}

TEST(Scenes, ReadAlikeAfterPrinting) {
    for (const CommandList& scene : all_steps()) {
        const CommandList again =
            read_scene(print_scene(scene), "printed.gl", scene.name, images_built_in, {.load_mesh = meshes_built_in});
        EXPECT_EQ(again.commands, scene.commands) << scene.title();
    }
}

// Each scene compiles as the body of a C function.
TEST(Scenes, CompileAsC) {
    if (std::system("command -v cc >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no C compiler";
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string path = testing::TempDir() + "twinlight_" + name_of(file) + ".c";
        std::ofstream(path) << "#define GL_GLEXT_PROTOTYPES\n#include <GL/freeglut.h>\n#include <math.h>\nvoid "
                               "draw(void);\nvoid draw(void) {\n"
                            << file.text << "\n}\n";
        const std::string compile =
            "cc -std=c99 -pedantic-errors -Wall -Werror -Wno-unknown-pragmas -fsyntax-only " + path;
        EXPECT_EQ(std::system(compile.c_str()), 0) << compile;
        std::remove(path.c_str());
    }
}

// Whether all three renderers support a command and a built-in scene can use it. The fixed function has only eight
// lights.
constexpr bool is_drawn_by_all(std::string_view effect) {
    return !effect.starts_with("driver_only") && effect != "extra_light";
}

constexpr bool kDrawnByAll[] = {
#define GL_COMMAND(name, effect, ...) is_drawn_by_all(#effect),
#define SHAPE_COMMAND(name, effect, ...) true,
#define QUADRIC_COMMAND(name, effect, ...) true,
#define PRAGMA_COMMAND GL_COMMAND
#include "scene/command/commands.def"
};

TEST(BuiltInScenes, UseEveryCommandThatAllRenderersCarryOut) {
    std::set<CommandId> used;
    const std::set<std::string> scenes{"commands", "legacy", "buffers", "fragments", "spectral", "report", "tutorial"};
    for (const EmbeddedFile& file : kSceneFiles) {
        if (!scenes.contains(name_of(file))) continue;
        for (const CommandList& step : read_steps(file))
            for (const Command& command : step.commands) used.insert(command.id);
    }
    for (std::size_t i = 0; i < signatures().size(); ++i) {
        EXPECT_TRUE(!kDrawnByAll[i] || used.contains(static_cast<CommandId>(i))) << signatures()[i].name;
    }
}

TEST(SceneCommands, UsesEveryPrimitiveTypeAndEveryWord) {
    std::set<Enum> modes;
    std::set<Word> used;
    for (const Command& command : read("commands").commands) {
        if (command.id == CommandId::glBegin) modes.insert(command.enumerant(0));
        if (command.sig().family != Family::kPragma) continue;
        if (command.sig().parameters.front().kind == Kind::kWord) used.insert(command.word(0));
    }
    EXPECT_EQ(modes.size(), 10u);
    for (const NamedValue& word : words()) {
        // The scene `spectral` uses some of these.
        if (find_illuminant(word.name) || find_reflectance(word.name) || word.name == "srgb") continue;
        EXPECT_TRUE(used.contains(static_cast<Word>(word.value))) << word.name;
    }
}

// The four parts of a rod are drawn with red, green and blue, with 3, 9 and 81 samples.
TEST(SceneSpectral, HasFourKindsOfColorUnderDaylightAndALamp) {
    std::map<std::pair<std::string, std::string_view>, std::set<int>> samples;  // by the light and the material
    for (const Draw& draw : draws(frame_of(read("spectral")))) {
        const LightingState& lighting = draw.lighting;
        const Spectrum* light = lighting.lights[0].diffuse_illuminant.spectrum;
        const Spectrum* patch = lighting.front.reflectances.diffuse;
        ASSERT_TRUE(light && patch);
        samples[{std::string(light->name), patch->name}].insert(
            lighting.light_model.spectrum ? lighting.light_model.spectrum->count() : 0);
        const auto color = lighting.lights[0].diffuse * lighting.front.diffuse;
        EXPECT_LT(std::max({color.r, color.g, color.b}), 1) << "no colour is brighter than a display can show";
    }
    EXPECT_EQ(samples.size(), 6U);
    for (const auto& [what, counts] : samples) EXPECT_EQ(counts, (std::set<int>{0, 3, 9, 81}));
}

// What its comment asks the reader to notice.
TEST(SceneSpectral, ShowsBordersOnlyUnderTheLamp) {
    const Image picture =
        reference::render(make_frame(read("spectral"), {.width = 320, .height = 240}), {{.shading = Shading::kPhong}});
    const auto lab = [](const Rgba& code) { return lab_from_srgb_codes({code[0], code[1], code[2]}); };
    // Delta E 2000 of a rod's part from that with 81 samples; `rod` counts from the top, `part` from the left.
    const auto difference = [&](bool is_lamp, int rod, int part) {
        const auto color = [&](int one) { return picture.at(29 + 34 * one + (is_lamp ? 160 : 0), 42 + 78 * rod); };
        return delta_e_2000(lab(color(part)), lab(color(3)));
    };
    for (int rod = 0; rod < 3; ++rod) {
        for (int part = 0; part < 3; ++part) EXPECT_LT(difference(false, rod, part), 0.5) << rod << " " << part;
        EXPECT_LT(difference(true, rod, 2), 1) << rod;
        EXPECT_GT(difference(true, rod, 0), 3) << rod;
    }
    EXPECT_GT(difference(true, 0, 0), difference(true, 1, 0));
    EXPECT_GT(difference(true, 0, 0), difference(true, 2, 0));
}

void expect_reach_of_50(const LightSource& light) {
    EXPECT_EQ(light.constant_attenuation, 1);
    EXPECT_EQ(light.linear_attenuation, static_cast<double>(0.09f));
    EXPECT_EQ(light.quadratic_attenuation, static_cast<double>(0.032f));
}

int enabled_lights(const LightingState& lighting) {
    int count = 0;
    for (const LightSource& light : lighting.lights) count += light.enabled ? 1 : 0;
    return count;
}

TEST(SceneReport, HasTheReportsNumbers) {
    const std::vector<Draw> all = draws(frame_of(read("report")));
    bool coral_cube = false;
    for (const Draw& draw : all) {
        if (!draw.lighting.enabled) continue;  // the small cubes at the lights
        const LightingState& lighting = draw.lighting;
        EXPECT_EQ(lighting.light_model.specular, Word::reflection);
        EXPECT_EQ(lighting.light_model.light_ambient, Word::unattenuated);
        EXPECT_EQ(lighting.light_model.ambient, glm::dvec4(0.1f, 0.1f, 0.1f, 1));
        EXPECT_EQ(enabled_lights(lighting), 2);
        for (const int i : {0, 1}) {
            EXPECT_EQ(lighting.lights[static_cast<std::size_t>(i)].diffuse, glm::dvec4(0.8f, 0.8f, 0.8f, 1));
            EXPECT_EQ(lighting.lights[static_cast<std::size_t>(i)].specular, glm::dvec4(1));
            EXPECT_EQ(lighting.lights[static_cast<std::size_t>(i)].position_eye.w, 1);
            expect_reach_of_50(lighting.lights[static_cast<std::size_t>(i)]);
        }
        EXPECT_EQ(lighting.front.ambient, lighting.front.diffuse);
        EXPECT_EQ(lighting.front.shininess, draw.texture.texture ? 8 : 32);  // the floor is textured
        coral_cube |= lighting.front.diffuse == glm::dvec4(1, 0.5f, 0.31f, 1) &&
                      lighting.front.specular == glm::dvec4(0.5, 0.5, 0.5, 1) && draw.count() == 36;
    }
    EXPECT_TRUE(coral_cube);
}

TEST(SceneLab, HasOneDirectionalLightSixPointLightsAndASpotlightAtTheCamera) {
    const std::vector<Draw> all = draws(frame_of(read("lab")));
    const LightingState& lighting = all.back().lighting;
    EXPECT_EQ(enabled_lights(lighting), 8);
    EXPECT_EQ(lighting.light_model.ambient, glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(lighting.front.ambient, lighting.front.diffuse);
    EXPECT_EQ(lighting.front.shininess, 32);
    EXPECT_EQ(lighting.lights[0].position_eye.w, 0);
    std::set<std::array<double, 3>> colors;
    for (std::size_t i = 1; i <= 6; ++i) {
        const LightSource& point = lighting.lights[i];
        EXPECT_EQ(point.position_eye.w, 1);
        EXPECT_EQ(point.spot_cutoff_deg, 180);
        expect_reach_of_50(point);
        colors.insert({point.diffuse.r, point.diffuse.g, point.diffuse.b});
        // Its terms are its colour times 0.05, 0.8 and 1, written with four digits.
        constexpr double kWritten = 0.5e-4;
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(point.ambient[channel], 0.05 * point.specular[channel], 2 * kWritten);
            EXPECT_NEAR(point.diffuse[channel], 0.8 * point.specular[channel], 2 * kWritten);
        }
    }
    EXPECT_EQ(colors.size(), 6u);
    const LightSource& spot = lighting.lights[7];
    EXPECT_EQ(spot.position_eye, glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(spot.spot_direction_eye, glm::dvec3(0, 0, -1));
    ASSERT_TRUE(spot.smooth_cone.has_value());
    EXPECT_LT(spot.smooth_cone->inner_deg, spot.smooth_cone->outer_deg);
    EXPECT_EQ(spot.smooth_cone->outer_deg,
              spot.spot_cutoff_deg);  // GL's hard cone ends where the smooth cone ends
}

}  // namespace
}  // namespace twinlight::scenes_test
