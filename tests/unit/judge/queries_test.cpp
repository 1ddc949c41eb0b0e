// The answers to a scene's queries, beside answers that a driver might give.
#include "judge/compare/queries.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::queries_test {
namespace {

using compare::Query;

std::vector<Query> queries(const std::string& text, const std::vector<std::vector<double>>& driver) {
    const Scene scene =
        make_scene(std::make_shared<CommandList>(read_scene(text + "glutSolidCube(1);", "scene.gl", "scene")), {});
    return compare::queries_of(scene, [&](const Scene&) { return driver; });
}

std::string state_of(const std::string& text) {
    const std::vector<Query> all = queries("GLint i[16]; GLfloat f[16]; GLboolean b[4]; " + text, {});
    return all.size() == 1 ? all[0].state : "not one query";
}

TEST(Queries, AreConvertedToTheirType) {
    // 6.1.2: real numbers are rounded; colours, normals and depths map [-1, 1] to [-2^31, 2^31 - 1].
    EXPECT_EQ(state_of("glLineWidth(2.75); glGetIntegerv(GL_LINE_WIDTH, i);"), "3");
    EXPECT_EQ(state_of("glColor3f(1, -1, 0); glGetIntegerv(GL_CURRENT_COLOR, i);"),
              "2147483647, -2147483648, 0, 2147483647");
    EXPECT_EQ(state_of("glGetLightiv(GL_LIGHT0, GL_AMBIENT, i);"), "0, 0, 0, 2147483647");
    EXPECT_EQ(state_of("glGetLightiv(GL_LIGHT0, GL_POSITION, i);"), "0, 0, 1, 0");
    EXPECT_EQ(state_of("glGetBooleanv(GL_LINE_WIDTH, b);"), "GL_TRUE");
    EXPECT_EQ(state_of("glGetFloatv(GL_FOG_DENSITY, f);"), "1");
}

TEST(Queries, ShowNamesAndWhatIsNotKnown) {
    EXPECT_EQ(state_of("glGetIntegerv(GL_POLYGON_MODE, i);"), "GL_FILL, GL_FILL");
    EXPECT_EQ(state_of("glGetIntegerv(GL_VIEWPORT, i);"), "0, 0, 640, 480");
    EXPECT_EQ(state_of("GLboolean lit = glIsEnabled(GL_DITHER);"), "GL_TRUE");
    EXPECT_EQ(state_of("glGetIntegerv(GL_SUBPIXEL_BITS, i);"), "?");
    EXPECT_EQ(queries("", {}).size(), 0u);
}

TEST(Queries, AreComparedWithTheDrivers) {
    const std::string text = "GLfloat f[4]; glGetLightfv(GL_LIGHT0, GL_POSITION, f);";
    const auto sentence = [&](const std::vector<std::vector<double>>& driver) {
        return compare::sentence_of(queries(text, driver).at(0));
    };
    const std::string start = "scene.gl:1:15: glGetLightfv(GL_LIGHT0, GL_POSITION) returns 0, 0, 1, 0";
    EXPECT_EQ(sentence({{0, 0, 1, 0}}), start + " (driver: the same)");
    EXPECT_EQ(sentence({{0, 0, -1, 0}}), start + " (driver: 0, 0, -1, 0)");
    EXPECT_EQ(sentence({{}}), start);
    EXPECT_TRUE(queries(text, {{0, 0, 1.000001, 0}})[0].agree);
    EXPECT_FALSE(queries(text, {{0, 0, 1.0001, 0}})[0].agree);
    EXPECT_FALSE(queries(text, {{0, 0, 1}})[0].agree);
}

TEST(Queries, AreHundredAtMost) {
    std::string text = "GLfloat f[4]; ";
    for (int i = 0; i < 150; ++i) text += "glGetFloatv(GL_LINE_WIDTH, f);\n";
    EXPECT_EQ(queries(text, {}).size(), compare::kMostQueries);
}

}  // namespace
}  // namespace twinlight::queries_test
