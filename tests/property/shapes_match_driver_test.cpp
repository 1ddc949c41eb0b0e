// Shapes drawn by the driver (GLU's shapes by the real GLU): the current values afterwards match State, the picture
// matches the reference.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/image/difference.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::shapes_match_driver_test {
namespace {

const std::vector<std::string> kQuadrics = {
    "gluSphere(q, 1, 12, 8);",
    "gluSphere(q, 1, 5, 9);",
    "gluCylinder(q, 1, 0.4, 1.5, 9, 3);",
    "gluCylinder(q, 0.7, 0.7, 1, 2, 1);",
    "gluDisk(q, 0, 1, 12, 3);",
    "gluDisk(q, 0.5, 1, 12, 3);",
    "gluDisk(q, 1, 1, 12, 3);",
    "gluPartialDisk(q, 0.2, 1, 9, 2, 20, 200);",
};

const std::vector<std::string> kSolids = {
    "Sphere(1, 12, 8)",
    "Cone(0.8, 1, 9, 3)",
    "Cylinder(0.6, 1, 9, 3)",
    "Torus(0.3, 0.7, 8, 12)",
    "Cube(1.2)",
    "Tetrahedron()",
    "Octahedron()",
    "Dodecahedron()",
    "Icosahedron()",
    "Teapot(0.8)",
    "Teacup(1)",
    "Teaspoon(1.5)",
    "RhombicDodecahedron()",
    "SierpinskiSponge(2, (GLdouble[]){0.1, 0, 0}, 1)",
};

std::vector<std::string> all_styles() {
    std::vector<std::string> styles;
    for (const char* normals : {"GLU_SMOOTH", "GLU_FLAT", "GLU_NONE"}) {
        for (const char* orientation : {"GLU_OUTSIDE", "GLU_INSIDE"}) {
            for (const char* style : {"GLU_FILL", "GLU_LINE", "GLU_SILHOUETTE", "GLU_POINT"}) {
                for (const int texture : {0, 1}) {
                    styles.push_back(
                        fmt::format("gluQuadricNormals(q, {}); gluQuadricOrientation(q, {}); "
                                    "gluQuadricDrawStyle(q, {}); gluQuadricTexture(q, {});",
                                    normals, orientation, style, texture));
                }
            }
        }
    }
    return styles;
}

constexpr int kWidth = 160, kHeight = 120;

class ShapesAndTheDriver : public testing::Test {
  protected:
    // The same current normal and texture coordinate afterwards.
    void expect_same_current(const std::string& text) {
        SCOPED_TRACE(text);
        const fixed::InitialState initial(kWidth, kHeight);
        State state({.width = kWidth, .height = kHeight});
        fixed::Executor executor;
        for (const Command& command : read_scene(text, "shape.gl", "shape").commands) {
            state.apply(command);
            executor.execute(command);
        }
        EXPECT_TRUE(state.errors().empty());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        std::array<GLfloat, 4> normal{}, tex_coord{};
        glGetFloatv(GL_CURRENT_NORMAL, normal.data());
        glGetFloatv(GL_CURRENT_TEXTURE_COORDS, tex_coord.data());
        // GLU's floats: an angle up to 2 pi rounded, and a handful of products.
        constexpr double kFloat = 0x1p-24 * (2 * 3.15 * 2 + 6);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(static_cast<double>(normal[static_cast<std::size_t>(i)]),
                        state.attributes().current.normal_object[i], kFloat);
        }
        for (int i = 0; i < 4; ++i) {
            EXPECT_NEAR(static_cast<double>(tex_coord[static_cast<std::size_t>(i)]),
                        answer(state, kGL_CURRENT_TEXTURE_COORDS).at(static_cast<std::size_t>(i)), kFloat);
        }
    }

    // The driver's picture matches the reference.
    void expect_same_picture(const std::string& drawing) {
        SCOPED_TRACE(drawing);
        const std::string text =
            "glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_NORMALIZE);"
            "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3, 0});"
            "glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3, 0.1, 20); glMatrixMode(GL_MODELVIEW);"
            "gluLookAt(1, 2, 3,  0, 0, 0.2,  0, 1, 0); glNormal3f(0, 0, 1);" +
            drawing;
        const auto scene = std::make_shared<const CommandList>(read_scene(text, "shape.gl", "shape"));
        const Scene made = make_scene(scene, {.width = kWidth, .height = kHeight});
        const Frame& frame = made.frame;
        const Image driver = fixed::render(made);
        // The driver may choose how to cut the quadrilaterals of a strip.
        const Image right = nearer_of(driver, reference::render(frame, {{}, reference::QuadCut::kFirstToThird}),
                                      reference::render(frame, {{}, reference::QuadCut::kSecondToFourth}));
        const ImageDifference found = difference(driver, right, reference::allowed_difference(frame).edge);
        EXPECT_LE(found.interior.max, 1.0 / 255) << found.interior.worst_x << "," << found.interior.worst_y;
        // As often as float and double round to different values.
        EXPECT_LE(found.interior.differing_share(), 0.001);
        std::size_t drawn = 0;
        for (const Rgba& pixel : driver.pixels) drawn += pixel[0] > 0 ? 1 : 0;
        EXPECT_GT(drawn, 200U);
    }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(kWidth, kHeight);
};

TEST_F(ShapesAndTheDriver, AgreeOnWhatIsCurrentAfterAQuadric) {
    for (const std::string& style : all_styles()) {
        for (const std::string& quadric : kQuadrics) {
            expect_same_current(
                "glNormal3f(0.6, 0, 0.8); glTexCoord4f(0.25, 0.5, 0.75, 2); GLUquadric* q = gluNewQuadric();" + style +
                quadric);
        }
    }
}

TEST_F(ShapesAndTheDriver, AgreeOnWhatIsCurrentAfterFreeglutsShapes) {
    for (const std::string& solid : kSolids) {
        for (const char* kind : {"glutSolid", "glutWire"}) {
            expect_same_current("glNormal3f(0.6, 0, 0.8); glTexCoord4f(0.25, 0.5, 0.75, 2);" + (kind + solid) + ";");
        }
    }
}

TEST_F(ShapesAndTheDriver, AgreeOnPicturesOfFilledQuadrics) {
    for (const char* normals : {"GLU_SMOOTH", "GLU_FLAT", "GLU_NONE"}) {
        for (const char* orientation : {"GLU_OUTSIDE", "GLU_INSIDE"}) {
            for (const std::string& quadric : kQuadrics) {
                if (quadric == "gluDisk(q, 1, 1, 12, 3);") continue;  // has no area
                expect_same_picture(
                    fmt::format("GLUquadric* q = gluNewQuadric(); gluQuadricNormals(q, {});"
                                "gluQuadricOrientation(q, {}); {}",
                                normals, orientation, quadric));
            }
        }
    }
}

TEST_F(ShapesAndTheDriver, AgreeOnPicturesOfFreeglutsSolids) {
    for (const std::string& solid : kSolids) expect_same_picture("glutSolid" + solid + ";");
}

// The program's arrays and buffer objects are not used and do not change.
TEST_F(ShapesAndTheDriver, LeavesTheProgramsArraysAlone) {
    const fixed::InitialState initial(kWidth, kHeight);
    glClear(GL_COLOR_BUFFER_BIT);
    const std::array<GLfloat, 3> red{1, 0, 0};  // too short for any shape
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(3, GL_FLOAT, 0, red.data());
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glColor3f(0, 1, 0);
    fixed::Executor executor;
    executor.execute(Command{CommandId::glutSolidCube, {1}, {}});
    EXPECT_EQ(read_pixels(kWidth, kHeight).at(kWidth / 2, kHeight / 2), (Rgba{0, 1, 0, 1}));
    GLint bound = 0;
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
    EXPECT_EQ(static_cast<GLuint>(bound), buffer);
    EXPECT_TRUE(glIsEnabled(GL_COLOR_ARRAY));
    EXPECT_FALSE(glIsEnabled(GL_VERTEX_ARRAY));
    EXPECT_FALSE(glIsEnabled(GL_NORMAL_ARRAY));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDisableClientState(GL_COLOR_ARRAY);
    glDeleteBuffers(1, &buffer);
}

// Compiled into a list, and called.
TEST_F(ShapesAndTheDriver, AgreeOnPicturesOfShapesInLists) {
    expect_same_picture(
        "GLUquadric* q = gluNewQuadric(); glNewList(1, GL_COMPILE); gluQuadricNormals(q, GLU_FLAT);"
        "gluCylinder(q, 0.8, 0.4, 1, 9, 2); glutSolidTeapot(0.5); glEndList();"
        "gluQuadricNormals(q, GLU_NONE); glCallList(1); gluDeleteQuadric(q);");
}

}  // namespace
}  // namespace twinlight::shapes_match_driver_test
