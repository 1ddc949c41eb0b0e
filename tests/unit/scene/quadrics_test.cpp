// GLU's quadrics in scenes: reading and printing, State, and properties of all quadrics.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>
#include <variant>

#include "scene/command/text.h"
#include "scene/shape/glu_quadrics.h"
#include "scene/shape/quadric.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::quadrics_test {
namespace {

std::vector<Command> read(std::string_view text) { return read_scene(text, "scene.gl", "scene").commands; }

std::string error_of(std::string_view text) {
    try {
        make_frame(read_scene(text, "scene.gl", "scene"), {});
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

State after(std::string_view text) {
    State state;
    for (const Command& command : read(text)) state.apply(command);
    return state;
}

std::vector<Draw> draws_of(std::string_view text) {
    std::vector<Draw> draws;
    for (const auto& item : after(text).take_frame().items) draws.push_back(std::get<Draw>(item));
    return draws;
}

Command command(CommandId id, std::vector<double> arguments) { return {id, std::move(arguments), {}}; }

// ---- Reading and printing ----

TEST(QuadricReading, NumbersQuadricsAsTheyAreMade) {
    const std::vector<Command> expected = {
        command(CommandId::gluNewQuadric, {1}),
        command(CommandId::gluNewQuadric, {2}),
        command(CommandId::gluSphere, {2, 1, 8, 6}),
        command(CommandId::gluSphere, {1, 1, 8, 6}),
    };
    EXPECT_EQ(read("GLUquadric* a = gluNewQuadric(); GLUquadricObj *b = gluNewQuadric();"
                   "gluSphere(b, 1, 8, 6); gluSphere(a, 1, 8, 6);"),
              expected);
    EXPECT_EQ(read("static GLUquadric *a = NULL, *b; a = gluNewQuadric(); b = gluNewQuadric();"
                   "gluSphere(b, 1, 8, 6); gluSphere(a, 1, 8, 6);"),
              expected);
    EXPECT_EQ(read("GLUquadric *a = 0; GLUquadric* b = a; a = gluNewQuadric(); b = gluNewQuadric();"
                   "gluSphere(b, 1, 8, 6); b = a; gluSphere(b, 1, 8, 6);"),
              expected);
}

TEST(QuadricReading, TakesOneMadeOnTheSpot) {
    EXPECT_EQ(
        read("gluDisk(gluNewQuadric(), 0.5, 1, 8, 2); gluNewQuadric();"),
        (std::vector<Command>{command(CommandId::gluNewQuadric, {1}), command(CommandId::gluDisk, {1, 0.5, 1, 8, 2}),
                              command(CommandId::gluNewQuadric, {2})}));
}

TEST(QuadricReading, TellsMistakes) {
    EXPECT_EQ(error_of("GLUquadric* q;\ngluSphere(q, 1, 8, 6);"),
              "scene.gl:2:11: 'q' has no value here: it was declared without a value; write q = gluNewQuadric();");
    EXPECT_EQ(error_of("GLUquadric* q = NULL;\ngluSphere(q, 1, 8, 6);"),
              "scene.gl:2:11: gluSphere needs a quadric; create one with gluNewQuadric()");
    EXPECT_EQ(error_of("gluSphere(1, 1, 8, 6);"),
              "scene.gl:1:11: expected gluNewQuadric() or the name of a GLUquadric*, found '1'");
    EXPECT_EQ(error_of("GLUquadric* ball = gluNewQuadric(); gluSphere(bal, 1, 8, 6);"),
              "scene.gl:1:47: expected gluNewQuadric() or the name of a GLUquadric*, found 'bal'; did you mean ball?");
    EXPECT_EQ(error_of("GLUquadric* q = gluNewQuadric(); glEnable(q);"),
              "scene.gl:1:43: 'q' is a quadric, but a number is needed here");
    EXPECT_EQ(error_of("GLUquadric q;"),
              "scene.gl:1:12: expected '*' after GLUquadric, as in GLUquadric* name = gluNewQuadric();, found 'q'");
    EXPECT_EQ(error_of("GLUquadric* q = gluNewQuadric(1);"),
              "scene.gl:1:31: expected ')' after the arguments of gluNewQuadric, found '1'");
    EXPECT_EQ(error_of("GLUquadric* q = gluNewQuadric(); gluQuadricNormals(q, GLU_SMOTH);"),
              "scene.gl:1:55: unknown name 'GLU_SMOTH'; did you mean GLU_SMOOTH?");
    EXPECT_EQ(error_of("GLUquadric* q[2];"),
              "scene.gl:1:13: a scene cannot use arrays of quadrics; declare each quadric");
    EXPECT_EQ(error_of("int q = gluNewQuadric();"),
              "scene.gl:1:9: gluNewQuadric returns a quadric; declare 'q' as a GLUquadric*");
    EXPECT_EQ(error_of("GLUquadric* q = gluNewQuadric(); glLightfv(GL_LIGHT0, GL_POSITION, &q);"),
              "scene.gl:1:69: a scene cannot take the address of a GLUquadric*");
}

const char* const kProgram =
    "GLUquadric* ball = gluNewQuadric(), *lid;\n"
    "lid = gluNewQuadric();\n"
    "gluQuadricNormals(ball, GLU_FLAT);\n"
    "gluQuadricOrientation(ball, GLU_INSIDE);\n"
    "gluQuadricDrawStyle(lid, GLU_SILHOUETTE);\n"
    "gluQuadricTexture(lid, GL_TRUE);\n"
    "gluSphere(ball, 1, 8, 6);\n"
    "gluPartialDisk(lid, 0, 0.5, 8, 2, 30, -90);\n"
    "gluCylinder(lid, 1, 0.5, 2, 8, 2);\n"
    "gluDeleteQuadric(ball);\n";

TEST(QuadricPrinting, ReadsBackTheSame) {
    const CommandList scene = read_scene(kProgram, "scene.gl", "scene");
    const std::string text = print_scene(scene);
    EXPECT_EQ(text.substr(0, 82),
              "GLUquadric* quadric1 = gluNewQuadric();\nGLUquadric* quadric2 = gluNewQuadric();\ngl");
    EXPECT_NE(text.find("gluQuadricNormals(quadric1, GLU_FLAT);\n"), std::string::npos);
    EXPECT_EQ(read(text), scene.commands);
}

TEST(QuadricPrinting, CompilesAsC) {
    if (std::system("command -v cc >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no C compiler";
    const std::string path = testing::TempDir() + "twinlight_quadrics.c";
    std::ofstream(path) << print_c_program(read_scene(kProgram, "scene.gl", "scene"));
    const std::string compile = "cc -std=c99 -pedantic-errors -Wall -Werror -fsyntax-only " + path;
    EXPECT_EQ(std::system(compile.c_str()), 0) << compile;
    std::remove(path.c_str());
}

// ---- State ----

TEST(QuadricState, RefusesWhatGluRefuses) {
    const std::string make = "GLUquadric* q = gluNewQuadric();\n";
    EXPECT_EQ(error_of(make + "gluSphere(q, 1, 1, 6);"),
              "scene.gl:2:1: gluSphere needs slices >= 2, stacks >= 1 and radius >= 0 (GLU_INVALID_VALUE)");
    EXPECT_EQ(error_of(make + "gluQuadricDrawStyle(q, GLU_FLAT);"),
              "scene.gl:2:1: gluQuadricDrawStyle is given GLU_FLAT; expected GLU_FILL, GLU_LINE, GLU_SILHOUETTE, "
              "GLU_POINT (GLU_INVALID_ENUM)");
    EXPECT_EQ(error_of(make + "gluDeleteQuadric(q);\ngluSphere(q, 1, 8, 6);"),
              "scene.gl:3:1: gluSphere uses a quadric that gluDeleteQuadric deleted at scene.gl:2:1 "
              "(GL_INVALID_VALUE)");
    EXPECT_NE(error_of(make + "gluCylinder(q, 1, 1, 1, 2000000000, 2000000000);").find("more than 8000000 vertices"),
              std::string::npos);
    EXPECT_NE(error_of(make + "gluDisk(q, 0, 1, 2, 200000);").find("more than 65536 strips and loops"),
              std::string::npos);
    EXPECT_NE(error_of(make + "glBegin(GL_POINTS); gluSphere(q, 1, 8, 6);").find("between glBegin and glEnd"),
              std::string::npos);
}

TEST(QuadricState, LetsQuadricsBeSetBetweenBeginAndEnd) {
    const State state = after("glBegin(GL_POINTS); GLUquadric* q = gluNewQuadric(); gluQuadricTexture(q, 1); glEnd();");
    EXPECT_TRUE(state.errors().empty());
}

TEST(QuadricState, GivesEachQuadricItsOwnSettings) {
    const std::string text =
        "GLUquadric *a = gluNewQuadric(), *b = gluNewQuadric();"
        "gluQuadricDrawStyle(a, GLU_POINT); gluSphere(a, 1, 8, 6); gluSphere(b, 1, 8, 6);";
    const std::vector<Draw> draws = draws_of(text);
    ASSERT_EQ(draws.size(), 1u + 6u);
    EXPECT_EQ(draws[0].mode, kGL_POINTS);
    EXPECT_EQ(draws[1].mode, kGL_TRIANGLE_FAN);
}

TEST(QuadricState, UsesTheCurrentNormalAndTextureCoordinateWhereNoneAreSent) {
    const std::vector<Draw> draws = draws_of(
        "glNormal3f(0, 0.6, 0.8); glTexCoord4f(1, 2, 3, 4); glColor3f(0, 1, 0);"
        "GLUquadric* q = gluNewQuadric(); gluQuadricNormals(q, GLU_NONE); gluDisk(q, 0, 1, 8, 2); glutSolidCube(1);");
    for (const Vertex& v : draws.front().vertices) {
        EXPECT_NEAR(glm::distance(v.normal_object, glm::dvec3(0, 0.6, 0.8)), 0, 1e-7);
        EXPECT_EQ(v.tex_coord, glm::dvec4(1, 2, 3, 4));
        EXPECT_EQ(v.color, glm::dvec4(0, 1, 0, 1));
    }
    for (const Vertex& v : draws.back().vertices) EXPECT_EQ(v.tex_coord, glm::dvec4(1, 2, 3, 4));  // freeglut's cube
}

TEST(QuadricState, LeavesWhatItSentLastCurrent) {
    const std::string before = "glNormal3f(1, 0, 0); glTexCoord2f(0.25, 0.75); ";
    const State quadric =
        after(before + "GLUquadric* q = gluNewQuadric(); gluQuadricTexture(q, 1); gluDisk(q, 0, 2, 8, 2);");
    EXPECT_EQ(quadric.attributes().current.normal_object, glm::dvec3(0, 0, 1));
    // The last strip's last vertex: half the radius, back at +y, in a texture whose centre is (0.5, 0.5).
    const std::vector<double> sent = answer(quadric, kGL_CURRENT_TEXTURE_COORDS);
    EXPECT_NEAR(sent.at(0), 0.5, 1e-15);
    EXPECT_NEAR(sent.at(1), 0.75, 1e-15);
    // The teapot is sent by vertex arrays.
    const State teapot = after(before + "glutSolidTeapot(1);");
    EXPECT_EQ(teapot.attributes().current.normal_object, glm::dvec3(1, 0, 0));
    EXPECT_EQ(answer(teapot, kGL_CURRENT_TEXTURE_COORDS), (std::vector<double>{0.25, 0.75, 0, 1}));
}

// The first vertices of a flat sphere are sent before its first normal.
TEST(QuadricState, OfFlatSpheresStartsWithTheCurrentNormal) {
    const std::vector<Draw> draws = draws_of(
        "glNormal3f(1, 0, 0); GLUquadric* q = gluNewQuadric(); gluQuadricNormals(q, GLU_FLAT); gluSphere(q, 1, 8, 6);");
    EXPECT_EQ(draws[0].vertices[0].normal_object, glm::dvec3(1, 0, 0));
    EXPECT_EQ(draws[0].vertices[1].normal_object, glm::dvec3(1, 0, 0));
    EXPECT_NE(draws[0].vertices[2].normal_object, glm::dvec3(1, 0, 0));
    EXPECT_EQ(draws[1].vertices[0].normal_object, draws[0].vertices.back().normal_object);
}

// A display list holds the calls that GLU made, not the quadric.
TEST(QuadricState, InAListIsTheQuadricAsItWasThen) {
    const std::string text =
        "GLUquadric* q = gluNewQuadric(); glNewList(1, GL_COMPILE);"
        "gluQuadricDrawStyle(q, GLU_POINT); gluSphere(q, 1, 8, 6); gluQuadricDrawStyle(q, GLU_LINE);"
        "glEndList(); gluDeleteQuadric(q); glCallList(1);";
    const std::vector<Draw> draws = draws_of(text);
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].mode, kGL_POINTS);
    EXPECT_EQ(
        error_of("GLUquadric* q = gluNewQuadric();\nglNewList(1, GL_COMPILE);\ngluSphere(q, 1, 1, 6); glEndList();"),
        "scene.gl:3:1: gluSphere needs slices >= 2, stacks >= 1 and radius >= 0 (GLU_INVALID_VALUE)");
}

// ---- Properties of every style ----

struct Style {
    Quadric quadric;
    std::string name;
};

std::vector<Style> styles() {
    std::vector<Style> all;
    for (const Enum normals : {kGLU_SMOOTH, kGLU_FLAT, kGLU_NONE}) {
        for (const Enum orientation : {kGLU_OUTSIDE, kGLU_INSIDE}) {
            for (const Enum style : {kGLU_FILL, kGLU_LINE, kGLU_SILHOUETTE, kGLU_POINT}) {
                for (const bool texture : {false, true}) {
                    all.push_back({{normals, texture, orientation, style},
                                   fmt::format("{} {} {} {}", enum_name(normals), enum_name(orientation),
                                               enum_name(style), texture)});
                }
            }
        }
    }
    return all;
}

std::vector<ShapePart> some_quadrics(const Quadric& q) {
    std::vector<ShapePart> all;
    for (const auto& parts :
         {glu_sphere(q, 1.5, 9, 5), glu_sphere(q, 1, 3, 7), glu_cylinder(q, 1, 0.25, 2, 7, 3),
          glu_cylinder(q, 0, 2, 1, 300, 1), glu_disk(q, 0, 2, 8, 3), glu_disk(q, 0.5, 2, 8, 3), glu_disk(q, 2, 2, 5, 2),
          glu_partial_disk(q, 0.25, 1, 7, 2, -50, 300), glu_partial_disk(q, 0, 1, 7, 2, 1e6, -77)}) {
        all.insert(all.end(), parts.begin(), parts.end());
    }
    return all;
}

constexpr double kRounding = 1e-14;

TEST(Quadrics, HaveTextureCoordinatesFrom0To1IfTheySendThem) {
    for (const Style& style : styles()) {
        SCOPED_TRACE(style.name);
        for (const ShapePart& part : some_quadrics(style.quadric)) {
            EXPECT_EQ(part.sends_tex_coords, style.quadric.texture);
            for (const ShapeVertex& v : part.vertices) {
                for (const double c : {v.tex_coord.s, v.tex_coord.t}) {
                    EXPECT_GE(c, -kRounding);
                    EXPECT_LE(c, 1 + kRounding);
                }
            }
        }
    }
}

// Except for the lines along a cylinder, where GLU ignores the slope of the normals.
TEST(Quadrics, HaveUnitNormalsOrNone) {
    for (const Style& style : styles()) {
        SCOPED_TRACE(style.name);
        const bool lines = style.quadric.draw_style == kGLU_LINE || style.quadric.draw_style == kGLU_SILHOUETTE;
        for (const ShapePart& part : some_quadrics(style.quadric)) {
            EXPECT_TRUE(part.immediate);
            if (style.quadric.normals == kGLU_NONE) {
                EXPECT_EQ(part.first_normal, part.vertices.size());
                continue;
            }
            for (std::size_t i = part.first_normal; i < part.vertices.size(); ++i) {
                const ShapeVertex& v = part.vertices[i];
                if (lines && v.normal_object.z == 0) continue;  // along a cylinder
                EXPECT_NEAR(glm::length(v.normal_object), 1, kRounding);
            }
        }
    }
}

// With GLU_INSIDE the points are the same, and triangles have the opposite orientation.
TEST(Quadrics, TurnWithTheirOrientation) {
    const auto signed_volume = [](const std::vector<ShapePart>& parts) {
        double sum = 0;
        const auto add = [&](const ShapeVertex& a, const ShapeVertex& b, const ShapeVertex& c) {
            sum += glm::dot(a.position_object, glm::cross(b.position_object, c.position_object)) / 6;
        };
        for (const ShapePart& part : parts) {
            const auto& v = part.vertices;
            if (part.mode == kGL_TRIANGLE_FAN) {
                for (std::size_t i = 1; i + 1 < v.size(); ++i) add(v[0], v[i], v[i + 1]);
            } else {
                EXPECT_EQ(part.mode, kGL_QUAD_STRIP);
                for (std::size_t i = 0; i + 3 < v.size(); i += 2) {
                    add(v[i], v[i + 1], v[i + 3]);
                    add(v[i], v[i + 3], v[i + 2]);
                }
            }
        }
        return sum;
    };
    for (const bool texture : {false, true}) {
        for (const Enum orientation : {kGLU_OUTSIDE, kGLU_INSIDE}) {
            const Quadric q{kGLU_SMOOTH, texture, orientation, kGLU_FILL};
            const double sign = orientation == kGLU_OUTSIDE ? 1 : -1;
            // Close to the volume of the sphere.
            EXPECT_NEAR(signed_volume(glu_sphere(q, 1, 200, 200)), sign * 4.18879, 4.18879 * 1e-3);
            // Without its caps at z = 0 and z = height, the sum gives two thirds of the volume of the prism.
            EXPECT_NEAR(signed_volume(glu_cylinder(q, 1, 1, 3, 200, 1)), sign * 2 * 3.14159, 2 * 3.14159 * 1e-3);
        }
    }
}

}  // namespace
}  // namespace twinlight::quadrics_test
