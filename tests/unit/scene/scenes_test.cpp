// The built-in scenes: each is a valid scene, compiles as C, and has the numbers of the lecture that it comes from.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "scene/command/text.h"
#include "scene/scenes/images.h"
#include "scene/scenes/load.h"
#include "scene/scenes/meshes.h"
#include "scene/spectrum/spectrum.h"
#include "scene/state/state.h"

namespace twinlight {
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
    for (const char* scene : {"commands", "legacy", "spectral", "report", "tutorial"}) {
        for (const Command& command : read(scene).commands) used.insert(command.id);
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
        if (find_illuminant(word.name) || find_reflectance(word.name) || word.name == "srgb") continue;  // below
        EXPECT_TRUE(used.contains(static_cast<Word>(word.value))) << word.name;
    }
}

TEST(SceneSpectral, HasEveryPatchOnceUnderOneKindOfLamp) {
    std::map<std::string_view, int> patches;
    std::set<std::string_view> lamps;
    for (const Command& command : read("spectral").commands) {
        if (command.id == CommandId::pragma_reflectance) ++patches[word_name(command.word(2))];
        if (command.id == CommandId::pragma_illuminant) lamps.insert(word_name(command.word(2)));
    }
    EXPECT_EQ(patches.size(), 24U);
    for (const auto& [name, count] : patches) EXPECT_EQ(count, 1) << name;
    EXPECT_EQ(lamps, std::set<std::string_view>{"A"});
    // No colour is clamped: white under both lamps together is within the range of a display.
    const std::vector<Draw> all = draws(frame_of(read("spectral")));
    double red = 0;
    for (const LightSource& light : all.front().lighting.lights)
        if (light.enabled) red += light.diffuse.r;
    EXPECT_LT(red * rgb_of_reflectance(find_reflectance("white_9_5")->lines).x, 1);
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
}  // namespace twinlight
