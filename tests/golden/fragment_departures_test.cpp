// Where the driver leaves the text on the way from vertices to pixels: one small scene for each name that stands in
// golden/known_differences, drawn by the driver and by the reference.
#include "fragment_departures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../unit/compare_three_ways.h"
#include "judge/compare/departures.h"
#include "known_differences.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "render/fixed/fixed.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::fragment_departures_test {

namespace {

constexpr int kWindow = 64;

// What all scenes start from.
constexpr const char* kStart = R"(
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    GLubyte green[] = {0, 255, 0, 255};
    GLubyte reds[] = {255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255};
    GLfloat white[] = {1, 1, 1, 1}, black[] = {0, 0, 0, 1};
)";

// How many interior pixels differ by more than a rounding and the allowed difference.
int differing_pixels(const FragmentCase& shown) {
    const auto scene = std::make_shared<const CommandList>(
        read_scene(std::string(kStart) + shown.scene, "case.gl", std::string(shown.name)));
    StateOptions options;
    options.width = options.height = kWindow;
    const Scene made = make_scene(scene, options);
    const Frame& frame = made.frame;
    EXPECT_TRUE(frame.unsupported.empty());
    const Image driver = fixed::render(made), reference = reference::render(frame, {});
    const AllowedDifference allowed = reference::allowed_difference(frame);
    int differing = 0;
    for (std::size_t i = 0; i < driver.pixels.size(); ++i) {
        if (allowed.edge[i]) continue;
        bool differs = false;
        for (std::size_t c = 0; c < 4; ++c) {
            const int codes = std::abs(channel_code(driver.pixels[i][c]) - channel_code(reference.pixels[i][c]));
            differs = differs || codes > 1 + 255.0 * static_cast<double>(allowed.channels(i)[c]);
        }
        differing += differs;
    }
    return differing;
}

TEST(Departures, OfFragmentsAreStillThere) {
    const auto context = make_offscreen_context(kWindow, kWindow);
    for (const FragmentCase& shown : fragment_cases()) expect_as_listed(shown.name, differing_pixels(shown) > 0);
}

// Left the colour sum in fog, which the driver gets wrong; right a highlight of shininess 0 with attenuation, which it gets right where
// n.VP is 1.
TEST(Departures, AreNamedOnlyWhereTheirDrawsDiffer) {
    const auto scene = std::make_shared<const CommandList>(read_scene(std::string(kStart) + R"(
        glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
        GLfloat grey[] = {0.3, 0.3, 0.3, 1};
        glMaterialfv(GL_FRONT, GL_DIFFUSE, white); glMaterialfv(GL_FRONT, GL_SPECULAR, white);
        glMaterialf(GL_FRONT, GL_SHININESS, 8);
        glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_START, 0); glFogf(GL_FOG_END, 1);
        glFogfv(GL_FOG_COLOR, black); glNormal3f(0, 0, 1);
        glBegin(GL_TRIANGLES); glVertex3f(-0.9, -0.9, -0.5); glVertex3f(-0.1, -0.9, -0.5); glVertex3f(-0.1, 0.9, -0.5);
        glEnd();
        glDisable(GL_FOG); glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 2);
        glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1e6, 1});
        glMaterialf(GL_FRONT, GL_SHININESS, 0); glMaterialfv(GL_FRONT, GL_DIFFUSE, grey);
        glMaterialfv(GL_FRONT, GL_SPECULAR, grey);
        glBegin(GL_TRIANGLES); glVertex3f(0.1, -0.9, 0); glVertex3f(0.9, -0.9, 0); glVertex3f(0.9, 0.9, 0); glEnd();)",
                                                                      "case.gl", "case"));
    const compare::Comparison comparison = compare_three_ways(make_scene(scene, {.width = kWindow, .height = kWindow}));
    if (!comparison.is_listed_driver) GTEST_SKIP() << "no bugs of this driver are listed";
    ASSERT_EQ(comparison.known_departures.size(), 1u);
    EXPECT_TRUE(comparison.known_departures.front().starts_with("the colour sum in fog"));
}

}  // namespace
}  // namespace twinlight::fragment_departures_test

namespace twinlight {

const std::vector<FragmentCase>& fragment_cases() {
    static const std::vector<FragmentCase> cases = {
        // The near plane, z = 1, cuts the triangle at x = 0: 2.12 draws the edge that this adds.
        {"clipped polygons as lines and points", R"(
            glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glLineWidth(5);
            glBegin(GL_TRIANGLES);
            glVertex3f(-0.9, -0.9, -0.1); glVertex3f(0.9, -0.9, -1.9); glVertex3f(-0.9, 0.9, -0.1); glEnd();)"},
        // Cut at x = -0.5 in eye coordinates, which is a quarter of the window; the driver cuts at x = -1.
        {"clip planes under a projection without an inverse", R"(
            glMatrixMode(GL_PROJECTION); glScalef(0.5, 0.5, 0); glMatrixMode(GL_MODELVIEW);
            glClipPlane(GL_CLIP_PLANE0, (GLdouble[]){1, 0, 0, 0.5}); glEnable(GL_CLIP_PLANE0);
            glBegin(GL_TRIANGLES); glVertex2f(-2, -2); glVertex2f(2, -2); glVertex2f(-2, 2); glEnd();)"},
        // A square of 16 pixels about the corner of the viewport.
        {"attenuated points beyond the viewport", R"(
            glPointSize(32); glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (GLfloat[]){4, 0, 0});
            glViewport(20, 20, 24, 24); glBegin(GL_POINTS); glVertex2f(1, 1); glEnd();)"},
        // A back face, whose stencil test fails.
        {"two-sided stencil of polygons as lines and points", R"(
            glEnable(GL_STENCIL_TEST); glStencilFuncSeparate(GL_BACK, GL_NEVER, 0, 255);
            glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glLineWidth(8); glBegin(GL_TRIANGLES);
            glVertex2f(-0.8, -0.8); glVertex2f(-0.8, 0.8); glVertex2f(0.8, -0.8); glEnd();)"},
        // Half of white.
        {"the alpha of smooth points", R"(
            glEnable(GL_POINT_SMOOTH); glPointSize(20); glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE);
            glColor4f(1, 1, 1, 0.5); glBegin(GL_POINTS); glVertex2f(0, 0); glEnd();)"},
        // All edges of a strip are boundary edges, whatever the flags say.
        {"edge flags of strips and fans", R"(
            glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glLineWidth(8);
            glBegin(GL_TRIANGLE_STRIP); glEdgeFlag(0);
            glVertex2f(-0.8, -0.8); glVertex2f(0.8, -0.8); glVertex2f(-0.8, 0.8); glEnd();)"},
        // A front face in FILL without offset, then a back face as LINE with one that takes it behind a wall.
        {"polygon offset of one of two polygon modes", R"(
            glEnable(GL_DEPTH_TEST);
            glBegin(GL_TRIANGLES); glVertex3f(-4, -4, 0); glVertex3f(4, -4, 0); glVertex3f(0, 8, 0); glEnd();
            glColor3f(1, 0, 0); glPolygonMode(GL_BACK, GL_LINE); glLineWidth(8);
            glEnable(GL_POLYGON_OFFSET_LINE); glPolygonOffset(0, 1e6);
            glBegin(GL_TRIANGLES);
            glVertex3f(-0.9, -0.9, 0.5); glVertex3f(-0.5, -0.9, 0.5); glVertex3f(-0.9, -0.5, 0.5);
            glVertex3f(-0.6, 0.7, -0.01); glVertex3f(0.7, 0.7, -0.01); glVertex3f(0.7, -0.6, -0.01); glEnd();)"},
        // Offset by half of the depth range the farther half of a line is behind it, and fails against the cleared buffer.
        {"polygon offset that leaves the depth range", R"(
            glEnable(GL_DEPTH_TEST); glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glLineWidth(8);
            glEnable(GL_POLYGON_OFFSET_LINE); glPolygonOffset(0, 8e6);
            glBegin(GL_TRIANGLES);
            glVertex3f(-0.8, -0.8, -0.9); glVertex3f(0.8, -0.8, 0.9); glVertex3f(-0.8, 0.8, 0.9); glEnd();)"},
        // The same, filled; with a stipple that leaves nothing out, as llvmpipe is right without one since Mesa 26.0.
        {"polygon offset that leaves the depth range", R"(
            glEnable(GL_POLYGON_STIPPLE); glEnable(GL_DEPTH_TEST); glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset(0, 8e6);
            glBegin(GL_TRIANGLES);
            glVertex3f(-0.8, -0.8, -0.9); glVertex3f(0.8, -0.8, 0.9); glVertex3f(-0.8, 0.8, 0.9); glEnd();)"},
        // Filled, so not offset: nearer than the cleared buffer.
        {"polygon offset of only lines or points", R"(
            glEnable(GL_DEPTH_TEST); glEnable(GL_POLYGON_OFFSET_LINE); glPolygonOffset(0, 16e6);
            glBegin(GL_TRIANGLES); glVertex3f(-0.8, -0.8, 0.5); glVertex3f(0.8, -0.8, 0.5); glVertex3f(-0.8, 0.8, 0.5);
            glEnd();)"},
        // White.
        {"glColor right before glPopAttrib", R"(
            glPushAttrib(GL_CURRENT_BIT); glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 1, 0, 1});
            glColor3f(0, 0.8, 0.5); glPopAttrib();
            glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(0, 1); glEnd();)"},
        // A front face, filled and opaque, and a back face.
        {"polygons as smooth lines", R"(
            glPolygonMode(GL_BACK, GL_LINE); glEnable(GL_LINE_SMOOTH); glBegin(GL_TRIANGLES);
            glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1);
            glVertex2f(0, 0); glVertex2f(0, 1); glVertex2f(1, 0); glEnd();)"},
        // The object is white.
        {"glGenerateMipmap before a framebuffer object draws", R"(
            glBindTexture(GL_TEXTURE_2D, 60);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            glBindFramebuffer(GL_FRAMEBUFFER, 1);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 60, 0);
            glGenerateMipmap(GL_TEXTURE_2D);
            glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(3, -1); glVertex2f(-1, 3); glEnd();
            glBindFramebuffer(GL_FRAMEBUFFER, 0); glEnable(GL_TEXTURE_2D);
            glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(3, -1); glVertex2f(-1, 3); glEnd();)"},
        // The lowest of each 32 rows.
        {"polygon stipple after a framebuffer object", R"(
            glPolygonStipple((GLubyte[128]){255, 255, 255, 255}); glEnable(GL_POLYGON_STIPPLE);
            glBindTexture(GL_TEXTURE_2D, 60);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            glBindFramebuffer(GL_FRAMEBUFFER, 1);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 60, 0);
            glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(0, 1); glEnd();
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(0, 1); glEnd();)"},
        // No texture, because the cube map has no images.
        {"an incomplete texture of a higher dimension", R"(
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, reds);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glEnable(GL_TEXTURE_2D); glEnable(GL_TEXTURE_CUBE_MAP); glBegin(GL_TRIANGLES);
            glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(0, 1); glEnd();)"},
        // rho is 1 and lambda the bias: the second level, which is green.
        {"level of detail of points", R"(
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, reds);
            glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, green);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1); glEnable(GL_TEXTURE_2D);
            glPointSize(8); glBegin(GL_POINTS); glVertex2f(0, 0); glEnd();)"},
        // r is never less than it is: 0, as alpha of a white triangle.
        {"the mode of copied depths", R"(
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_NEVER);
            glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, 16, 16, 0); glEnable(GL_TEXTURE_2D);
            glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(-1, 1); glEnd();)"},
        // r is less than the depth, and t is more: 1, which is white.
        {"depths in one dimension", R"(
            glTexImage1D(GL_TEXTURE_1D, 0, GL_DEPTH_COMPONENT, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){0.5});
            glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE); glEnable(GL_TEXTURE_1D);
            glTexCoord3f(0.5, 0.9, 0.1);
            glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(-1, 1); glEnd();)"},
        // White and a white highlight are white, and half of it in black fog is grey.
        {"the colour sum in fog", R"(
            glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);
            glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
            glMaterialfv(GL_FRONT, GL_DIFFUSE, white); glMaterialfv(GL_FRONT, GL_SPECULAR, white);
            glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_START, 0); glFogf(GL_FOG_END, 1);
            glFogfv(GL_FOG_COLOR, black);
            glNormal3f(0, 0, 1); glBegin(GL_TRIANGLES);
            glVertex3f(-4, -4, -0.5); glVertex3f(4, -4, -0.5); glVertex3f(0, 8, -0.5); glEnd();)"},
        // All of it lies at s = -1. The part that is minified is red; the magnified one is half white, of the border.
        {"GL_CLAMP between a nearest and a linear filter", R"(
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, reds);
            glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, white);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP); glEnable(GL_TEXTURE_2D);
            glMatrixMode(GL_PROJECTION); glFrustum(-1, 1, -1, 1, 1, 10);
            glBegin(GL_TRIANGLES);
            glTexCoord2f(-1, 0); glVertex3f(-3, -7, -7.5); glVertex3f(-6, 5, -7.5);
            glTexCoord2f(-1, 3); glVertex3f(-0.5, 0.5, -4.4); glEnd();)"},
        // The second line of each strip begins 32 pixels after the first one, where the pattern is off.
        {"stippled line strips in a display list", R"(
            glLineWidth(9); glLineStipple(4, 255); glEnable(GL_LINE_STIPPLE); glNewList(1, GL_COMPILE);
            glBegin(GL_LINE_STRIP); glVertex2f(-1, 0.5); glVertex2f(0, 0.5); glVertex2f(1, 0.5); glEnd();
            glBegin(GL_LINE_STRIP); glVertex2f(-1, -0.5); glVertex2f(0, -0.5); glVertex2f(1, -0.5); glEnd();
            glEndList(); glCallList(1);)"},
        // One triangle.
        {"a triangle strip in a display list whose first vertices lack attributes", R"(
            glNewList(1, GL_COMPILE); glBegin(GL_TRIANGLE_STRIP); glVertex2f(-1, -1);
            glNormal3f(0, 0, 1); glVertex2f(1, -1); glVertex2f(-1, 1); glEnd(); glEndList(); glCallList(1);)"},
        {"current values after a line loop in GL_COMPILE_AND_EXECUTE", R"(
            glNewList(1, GL_COMPILE_AND_EXECUTE); glBegin(GL_LINE_LOOP); glColor3f(0, 1, 0); glVertex2f(-0.9, -0.9);
            glColor3f(1, 0, 0); glVertex2f(-0.8, -0.9); glVertex2f(-0.8, -0.8); glEnd(); glEndList();
            glRectf(-0.5, -0.5, 0.5, 0.5);)"},
        {"attributes after the last vertex in a display list", R"(
            glNewList(1, GL_COMPILE); glBegin(GL_TRIANGLES); glColor3f(0, 1, 0); glEnd(); glEndList(); glCallList(1);
            glRectf(-0.5, -0.5, 0.5, 0.5);)"},
        // A loop about the window; its fourth vertex is the first that has an edge flag and a colour of its own.
        {"a line loop whose first vertex lacks attributes", R"(
            glLineWidth(8); glBegin(GL_LINE_LOOP);
            glVertex2f(-0.7, -0.7); glVertex2f(0.7, -0.7); glVertex2f(0.8, 0);
            glEdgeFlag(1); glColor3f(1, 0, 0); glVertex2f(0.7, 0.7); glVertex2f(0, 0.9); glVertex2f(-0.7, 0.7); glEnd();)"},
    };
    return cases;
}

}  // namespace twinlight
