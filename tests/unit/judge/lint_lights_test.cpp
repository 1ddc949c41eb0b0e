// What programs leave of a light at its initial values.
#include <gtest/gtest.h>

#include <string>

#include "judge/lint/watch.h"
#include "lint_warnings.h"

namespace twinlight::lint_lights_test {
namespace {

using lint_test::names, lint_test::warnings_of;
using Names = std::set<std::string>;

// Table 2.10: GL_LIGHT0 starts white, in the direction (0, 0, 1).
TEST(LintLights, FindsALight0OfWhichOnlyTheAmbientColorIsSet) {
    const auto with = [](const std::string& calls) {
        return names(warnings_of(std::string(lint::view_lines()) + calls +
                                 "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glutSolidSphere(1.5, 40, 20);"));
    };
    const std::string ambient = "glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){0.3, 0.3, 0.3, 1});";
    EXPECT_EQ(with(ambient), Names{"light0-initial"});
    EXPECT_EQ(with(ambient + "glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1);"), Names{"attenuation-directional"});
    // A lamp at the viewer's head.
    EXPECT_EQ(with(""), Names{});
    EXPECT_EQ(with(ambient + "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});"), Names{});
    EXPECT_EQ(with(ambient + "glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});"), Names{});
    // Another light starts black: it is ambient light only.
    EXPECT_EQ(with("glLightfv(GL_LIGHT1, GL_AMBIENT, (GLfloat[]){0.3, 0.3, 0.3, 1}); glEnable(GL_LIGHT1);"), Names{});
}

TEST(LintLights, SaysWhetherThePositionOfAnAttenuatedLightWasSet) {
    const std::string attenuated = std::string(lint::view_lines()) +
                                   "glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1); glEnable(GL_LIGHTING);"
                                   "glEnable(GL_LIGHT0); glutSolidSphere(1.5, 40, 20);";
    const auto message = [](const std::string& text) { return warnings_of(text).at(0).message; };
    EXPECT_EQ(
        message(attenuated),
        "the attenuation of GL_LIGHT0 has no effect, because its position is never set, and the initial one (0, 0, 1, "
        "0) has w = 0");
    EXPECT_EQ(message("glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});" + attenuated),
              "the attenuation of GL_LIGHT0 has no effect, because its position has w = 0");
}

}  // namespace
}  // namespace twinlight::lint_lights_test
