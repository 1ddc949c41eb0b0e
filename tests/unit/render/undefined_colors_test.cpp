// Where the specification gives a vertex no colour, a difference is no error, and it is said why.
#include "render/reference/undefined_colors.h"

#include <gtest/gtest.h>

#include "../compare_three_ways.h"
#include "judge/report/words.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"

namespace twinlight::reference::undefined_colors_test {
namespace {

const std::string kLit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n";
const std::string kTriangle =
    "glBegin(GL_TRIANGLES); glVertex3f(-1, -1, 0); glVertex3f(1, -1, 0); glVertex3f(0, 1, 0); glEnd();\n";
const std::string kPositional = "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 1});\n";

Scene scene_of(const std::string& text) {
    return make_scene(std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene")),
                      {.width = 32, .height = 32});
}

TEST(UndefinedColors, AreFoundWhereSomethingIsDividedByZero) {
    const auto of = [](const std::string& text) { return first_undefined_color(scene_of(text).frame); };
    EXPECT_EQ(of(kLit + kTriangle), std::nullopt);
    EXPECT_EQ(of(kLit + "glScalef(1, 1, 0);" + kTriangle), Undefined::kNormalMatrix);
    EXPECT_EQ(of("glScalef(1, 1, 0);" + kTriangle), std::nullopt);
    EXPECT_EQ(of("glEnable(GL_LIGHTING); glScalef(1, 1, 0);" + kTriangle), std::nullopt) << "no light needs a normal";
    EXPECT_EQ(of(kLit + "glNormal3f(0, 0, 0);" + kTriangle), std::nullopt) << "n . VP is 0";
    EXPECT_EQ(of(kLit + "glNormal3f(0, 0, 0); glEnable(GL_NORMALIZE);" + kTriangle), Undefined::kNormal);
    const std::string no_k0 = "glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0);\n";
    EXPECT_EQ(of(kLit + no_k0 + kTriangle), std::nullopt) << "a directional light has no attenuation";
    EXPECT_EQ(of(kLit + kPositional + no_k0 + kTriangle), Undefined::kAttenuation);
    EXPECT_EQ(of(kLit + kPositional + no_k0 + "glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1);" + kTriangle),
              std::nullopt);
    EXPECT_EQ(of(kLit + "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 1, 0, 1});" + kTriangle),
              Undefined::kLightDirection);
    EXPECT_EQ(of(kLit + "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 0, 0});" + kTriangle),
              Undefined::kLightDirection);
    const std::string spot = "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, 0, 0});" + kPositional;
    EXPECT_EQ(of(kLit + spot + kTriangle), std::nullopt) << "without a cutoff there is no cone";
    EXPECT_EQ(of(kLit + spot + "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);" + kTriangle), Undefined::kSpotDirection);
}

// The pixels of the triangle, but not those that something else certainly hides; blending shows them.
TEST(UndefinedColors, AreWhereTheyMayBeSeen) {
    const auto is_undefined = [](const std::string& after) {
        const AllowedDifference allowed = allowed_difference(
            scene_of("glPushMatrix(); " + kLit + "glScalef(1, 1, 0);" + kTriangle + "glPopMatrix();" + after).frame);
        return allowed.is_undefined(allowed.index(16, 24));
    };
    const std::string plain = "glDisable(GL_LIGHTING); glColor4f(1, 0, 0, 0.5); glRectf(-1, -1, 1, 1);";
    EXPECT_TRUE(is_undefined(""));
    EXPECT_FALSE(is_undefined(plain));
    EXPECT_TRUE(is_undefined("glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);" + plain));
    EXPECT_TRUE(is_undefined("glAccum(GL_LOAD, 1); glClear(GL_COLOR_BUFFER_BIT); glAccum(GL_RETURN, 1);"));
    EXPECT_FALSE(is_undefined("glClear(GL_COLOR_BUFFER_BIT);"));
}

TEST(UndefinedColors, AreNoErrorsAndHaveTheirReason) {
    const Scene scene = scene_of(kLit + kPositional + "glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0);" + kTriangle);
    const compare::Comparison comparison = compare_three_ways(scene);
    const auto of_fixed = std::ranges::find(comparison.pairs, 2U, &compare::Pair::b);
    EXPECT_EQ(of_fixed->difference.beyond_allowed.differing, 0U);
    EXPECT_TRUE(comparison.within_tolerance());
    if (of_fixed->difference.undefined == 0) GTEST_SKIP() << "this driver follows the same rule";
    EXPECT_EQ(comparison.verdict(), compare::Verdict::kUnjudged);
    const std::vector<std::string> sentences = report::answer(comparison).sentences();
    EXPECT_TRUE(sentences[0].starts_with("The pictures differ only where OpenGL leaves the colour undefined"));
    EXPECT_NE(std::ranges::find_if(sentences,
                                   [](const std::string& sentence) {
                                       return sentence.find("the attenuation of a light divides by 0 (2.14.1)") !=
                                              std::string::npos;
                                   }),
              sentences.end());
}

}  // namespace
}  // namespace twinlight::reference::undefined_colors_test
