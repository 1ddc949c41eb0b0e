// The window's shaders as coloured text.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "app/session/shader_view.h"
#include "render/programmable/export/shader_text.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::session::session_shader_view_test {
namespace {

using enum Ink;
using Line = std::vector<InkedText>;

Line line(const std::string& glsl) { return inked_lines(glsl).at(0); }

TEST(SessionShaderView, ColoursWordsByWhatTheyAre) {
    const std::string glsl = "    vec3 n = 2.5e-3 * normalize (v_normal); // unit";
    EXPECT_EQ(line(glsl), (Line{{kPlain, "    "},
                                {kType, "vec3"},
                                {kPlain, " n = "},
                                {kNumber, "2.5e-3"},
                                {kPlain, " * "},
                                {kCall, "normalize"},
                                {kPlain, " (v_normal); "},
                                {kComment, "// unit"}}));
}

TEST(SessionShaderView, KnowsKeywordsTypesAndDirectives) {
    EXPECT_EQ(line("uniform mat4x3 m;"),
              (Line{{kKeyword, "uniform"}, {kPlain, " "}, {kType, "mat4x3"}, {kPlain, " m;"}}));
    EXPECT_EQ(line("#version 330 // core")[0], (InkedText{kDirective, "#version 330 "}));
    EXPECT_EQ(line("#version 330 // core")[1], (InkedText{kComment, "// core"}));
    // Names that only begin like a type.
    EXPECT_EQ(line("vec5 = vector3 + mat4y3;")[0].ink, kPlain);
}

TEST(SessionShaderView, FollowsCommentsOverLines) {
    const std::string glsl = "a /* b\nc */ d\n";
    const auto lines = inked_lines(glsl);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0], (Line{{kPlain, "a "}, {kComment, "/* b"}}));
    EXPECT_EQ(lines[1], (Line{{kComment, "c */"}, {kPlain, " d"}}));
}

Scene report() { return make_scene(load_commands("report"), {}); }

// No letter of a real shader is lost.
TEST(SessionShaderView, ShowsEveryLetter) {
    const std::string source = programmable::shader_source(report().frame, {});
    std::string text;
    for (const Line& pieces : inked_lines(source)) {
        for (const InkedText& piece : pieces) text += piece.text;
        text += "\n";
    }
    EXPECT_EQ(text, source);
}

TEST(SessionShaderView, SplitsTheProgramsOfAScene) {
    const Scene scene = report();
    const auto shaders = shown_shaders(programmable::shader_source(scene.frame, {}));
    ASSERT_FALSE(shaders.empty());
    const auto plans = explain_draws(scene.frame, {});
    for (const ShownShader& shader : shaders) {
        EXPECT_EQ(shader.title.find("draw " + std::to_string(shader.draw) + ", "), 0u) << shader.title;
        EXPECT_NE(shader.glsl.find("void main()"), std::string::npos);
        EXPECT_EQ(shader.glsl.find("// ==== Draw"), std::string::npos);
        EXPECT_NE(plan_of(plans, shader.draw), nullptr);
    }
    for (const ShownShader& shader : shaders) {
        const std::string_view rest = without_reasons(shader.glsl);
        EXPECT_TRUE(shader.glsl.ends_with(rest));
        EXPECT_EQ(rest.find("// Left out"), std::string::npos);
        EXPECT_NE(rest.find("// Uniform values:"), std::string::npos);
    }
    EXPECT_EQ(without_reasons("#version 330\n// Uniform values:\n"), "#version 330\n// Uniform values:\n");
    EXPECT_EQ(shaders[0].draw, 1);
    EXPECT_EQ(plan_of(plans, 0), nullptr);
    EXPECT_TRUE(shown_shaders("").empty());
}

}  // namespace
}  // namespace twinlight::session::session_shader_view_test
