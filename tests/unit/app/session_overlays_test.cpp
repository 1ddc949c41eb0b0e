// The overlays: which lines, marks and labels belong to a frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "app/session/overlays.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session::session_overlays_test {
namespace {

// Positions are stored as floats near 1.
constexpr float kFloat = 1e-6F;

Frame frame_of(const std::string& text) {
    return make_frame(read_scene(text, "test.gl", "test"), StateOptions{.width = 200, .height = 100});
}

OverlayPicture picture_of(const std::string& text, const Overlays& overlays) {
    return overlays_of(frame_of(text), overlays, PlanOptions{});
}

void expect_place(const glm::vec4& actual, const glm::vec4& expected) {
    EXPECT_LT(glm::distance(actual, expected), kFloat)
        << actual.x << ", " << actual.y << ", " << actual.z << ", " << actual.w;
}

// Vertex i is at (i/10, (i mod 2)/2, 0).
std::string vertices(const std::string& mode, int count) {
    std::string text = "glBegin(" + mode + ");\n";
    for (int i = 0; i < count; ++i)
        text += "glVertex2d(" + std::to_string(i) + " * 0.1, " + std::to_string(i % 2) + " * 0.5);\n";
    return text + "glEnd();\n";
}
int vertex_at(const glm::vec4& position) { return static_cast<int>(std::lround(position.x * 10)); }

const std::string kTriangle = "glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();\n";

constexpr Overlays kWires{.wireframe = Wireframe::kOver};
constexpr Overlays kNormals{.normals = true};
constexpr Overlays kProvoking{.provoking_vertices = true};
constexpr Overlays kBackFaces{.back_faces = true};
constexpr Overlays kAboveOne{.above_one = true};
constexpr Overlays kKeptLights{.kept_lights = true};

TEST(SessionOverlays, AWireframeHasTheBordersOfPrimitives) {
    const OverlayPicture square = picture_of("glEnable(GL_DEPTH_TEST); glRectf(0, 0, 1, 1);", kWires);
    ASSERT_EQ(square.draws.size(), 1u);
    EXPECT_TRUE(square.draws[0].hides);
    ASSERT_EQ(square.draws[0].faces_clip.size(), 6u);
    // Not the cut from corner to corner, which both triangles have.
    EXPECT_EQ(std::ranges::count(square.draws[0].edges, 1), 4);
    for (std::size_t i = 0; i < 6; ++i) {
        const glm::vec4 from = square.draws[0].faces_clip[i];
        const glm::vec4 to = square.draws[0].faces_clip[i / 3 * 3 + (i + 1) % 3];
        EXPECT_EQ(square.draws[0].edges[i] == 1, from.x == to.x || from.y == to.y);
    }
    const OverlayPicture lines = picture_of(vertices("GL_LINE_STRIP", 4), kWires);
    EXPECT_EQ(lines.draws[0].lines.size(), 6u);
    EXPECT_EQ(picture_of(vertices("GL_POINTS", 4), kWires).draws[0].points.size(), 4u);
    EXPECT_TRUE(
        picture_of("glEnable(GL_CULL_FACE); glFrontFace(GL_CW);" + kTriangle, kWires).draws[0].faces_clip.empty());
    EXPECT_FALSE(picture_of(kTriangle, kWires).draws[0].hides);  // no depth test
    EXPECT_EQ(picture_of("glClearColor(0.25, 0.5, 1, 0); glClear(GL_COLOR_BUFFER_BIT);" + kTriangle, kWires).background,
              glm::vec4(0.25F, 0.5F, 1, 0));
}

TEST(SessionOverlays, NormalsAreAsLongAsLightingSeesThem) {
    // The triangle's box has the half diagonal sqrt(1/2).
    const float length = static_cast<float>(std::sqrt(0.5) / 30);
    const std::string text = "glEnable(GL_LIGHTING); glNormal3f(0, 2, 0);";
    const OverlayPicture twice = picture_of(text + kTriangle, kNormals);
    ASSERT_EQ(twice.draws[0].lines.size(), 6u);
    expect_place(twice.draws[0].lines[0].position_clip, {0, 0, 0, 1});
    expect_place(twice.draws[0].lines[1].position_clip, {0, 2 * length, 0, 1});
    ASSERT_EQ(twice.labels.size(), 1u);
    EXPECT_EQ(twice.labels[0].text, "normals 2 long");
    EXPECT_TRUE(twice.labels[0].is_warning);

    const OverlayPicture one = picture_of("glEnable(GL_NORMALIZE);" + text + kTriangle, kNormals);
    expect_place(one.draws[0].lines[1].position_clip, {0, length, 0, 1});
    EXPECT_TRUE(one.labels.empty());
    EXPECT_NE(one.draws[0].lines[0].color, twice.draws[0].lines[0].color);
    // Of unlit shapes only where nothing is lit.
    const OverlayPicture mixed = picture_of(kTriangle + "glEnable(GL_LIGHTING);" + kTriangle, kNormals);
    EXPECT_TRUE(mixed.draws[0].lines.empty());
    EXPECT_FALSE(mixed.draws[1].lines.empty());
    EXPECT_FALSE(picture_of(kTriangle, kNormals).draws[0].lines.empty());

    // A scale by 2 halves normals (2.11.3).
    const OverlayPicture half = picture_of(
        "glEnable(GL_LIGHTING); glScalef(2, 2, 2); glTranslatef(-0.25, -0.25, 0);"
        "glNormal3f(0, 1, 0); glScalef(0.5, 0.5, 0.5); glScalef(2, 2, 2);" +
            kTriangle,
        kNormals);
    EXPECT_EQ(half.labels.at(0).text, "normals 0.5 long");
}

TEST(SessionOverlays, ProvokingVerticesAreThoseOfTable2_12) {
    const auto provoking = [](const std::string& mode, int count) {
        const OverlayPicture picture = picture_of(vertices(mode, count), kProvoking);
        std::vector<int> found;
        for (std::size_t i = 0; i < picture.draws[0].marks.size(); i += 3)
            found.push_back(vertex_at(picture.draws[0].marks[i].position_clip));
        for (const OverlayVertex& point : picture.draws[0].points) found.push_back(vertex_at(point.position_clip));
        return found;
    };
    using Vertices = std::vector<int>;  // counted from 0
    EXPECT_EQ(provoking("GL_TRIANGLES", 6), (Vertices{2, 5}));
    EXPECT_EQ(provoking("GL_TRIANGLE_STRIP", 5), (Vertices{2, 3, 4}));
    EXPECT_EQ(provoking("GL_TRIANGLE_FAN", 4), (Vertices{2, 3}));
    EXPECT_EQ(provoking("GL_QUADS", 8), (Vertices{3, 7}));
    EXPECT_EQ(provoking("GL_QUAD_STRIP", 6), (Vertices{3, 3, 5, 5}));  // the cut ends there: two triangles each
    EXPECT_EQ(provoking("GL_POLYGON", 5), (Vertices{0, 0, 0}));        // the corner's three triangles
    EXPECT_EQ(provoking("GL_LINES", 4), (Vertices{1, 3}));
    EXPECT_EQ(provoking("GL_LINE_LOOP", 3), (Vertices{1, 2, 0}));
    EXPECT_EQ(provoking("GL_POINTS", 2), (Vertices{0, 1}));
}

TEST(SessionOverlays, BackFacesAreTinted) {
    const auto tints = [](const std::string& text) { return picture_of(text, kBackFaces).draws[0].tints.size(); };
    EXPECT_EQ(tints(kTriangle), 0u);  // counterclockwise
    EXPECT_EQ(tints("glFrontFace(GL_CW);" + kTriangle), 3u);
    EXPECT_EQ(tints("glScalef(-1, 1, 1);" + kTriangle), 3u);
    EXPECT_EQ(tints("glFrontFace(GL_CW); glEnable(GL_CULL_FACE);" + kTriangle), 0u);
    // A triangle with one vertex behind the eye: what is visible of it keeps its orientation.
    const std::string behind =
        "glBegin(GL_TRIANGLES); glVertex3f(-1, -1, -2); glVertex3f(1, -1, -2); glVertex3f(0, -1, 4); glEnd();";
    const std::string projection =
        "glMatrixMode(GL_PROJECTION); glFrustum(-1, 1, -1, 1, 1, 10); glMatrixMode(GL_MODELVIEW);";
    EXPECT_EQ(tints(projection + behind), 3u);  // seen from above, it is clockwise
    EXPECT_EQ(tints(projection + "glFrontFace(GL_CW);" + behind), 0u);
}

TEST(SessionOverlays, ChannelsAbove1AreFound) {
    const auto brightness = [](const std::string& emission, const std::string& more = "") {
        // The light model's ambient light 0.2 times the material's 0.2 adds 0.04.
        return picture_of("glEnable(GL_LIGHTING); glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){" + emission + "});" +
                              more + kTriangle,
                          kAboveOne)
            .draws[0]
            .brightness;
    };
    EXPECT_TRUE(brightness("0, 0.95, 0, 1").empty());
    const auto above = brightness("0, 1.46, 0, 1");  // 1.5
    ASSERT_EQ(above.size(), 3u);
    EXPECT_NEAR(above[0].color.a, 0.75, 1e-6);
    EXPECT_EQ(brightness("9, 0, 0, 1").at(0).color.a, 1);
    // A back face has its own colours only under two-sided lighting.
    const std::string back = "glFrontFace(GL_CW);";
    EXPECT_EQ(brightness("9, 0, 0, 1", back).size(), 3u);
    EXPECT_TRUE(brightness("9, 0, 0, 1", back + "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);").empty());
    // One vertex has 1.54, the others 0.04.
    const auto one = picture_of(
        "glEnable(GL_LIGHTING); glColorMaterial(GL_FRONT, GL_EMISSION); glEnable(GL_COLOR_MATERIAL);"
        "glBegin(GL_TRIANGLES); glColor3f(1.5, 0, 0); glVertex2f(0, 0); glColor3f(0, 0, 0);"
        "glVertex2f(1, 0); glVertex2f(0, 1); glEnd();",
        kAboveOne);
    ASSERT_EQ(one.draws[0].brightness.size(), 3u);
    EXPECT_NEAR(one.draws[0].brightness[0].color.a, 0.77, 1e-6);
    EXPECT_NEAR(one.draws[0].brightness[1].color.a, 0.02, 1e-6);
}

TEST(SessionOverlays, AHighlightBetweenVerticesIsFoundForLightingPerPixel) {
    // The light is near the middle of a square, whose corners it hardly reaches.
    const Frame frame = frame_of(
        "glMatrixMode(GL_PROJECTION); glOrtho(-1, 1, -1, 1, -1, 1); glMatrixMode(GL_MODELVIEW);"
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);"
        "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 0.1, 1});"
        "glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 4);"
        "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});"
        "glNormal3f(0, 0, 1); glRectf(-1, -1, 1, 1);");
    PlanOptions options;
    EXPECT_TRUE(overlays_of(frame, kAboveOne, options).draws[0].brightness.empty());
    options.shading = Shading::kPhong;
    // At a distance r from the middle: 0.04 + 0.1 / sqrt(r^2 + 0.01) / (1 + 4 r^2 + 0.04) exceeds 1 for r below 0.0072.
    const auto found = overlays_of(frame, kAboveOne, options).draws[0].brightness;
    EXPECT_TRUE(std::ranges::all_of(found, [](const OverlayVertex& vertex) {
        const bool above = vertex.color.a > 0.5F;
        return above == (std::hypot(vertex.position_clip.x, vertex.position_clip.y) < 0.0072F);
    }));
    // 200 pixels by 100: the diagonal of 224 pixels has 18 parts, so one vertex is in the middle.
    EXPECT_TRUE(std::ranges::any_of(found, [](const OverlayVertex& vertex) { return vertex.color.a > 0.5F; }));
}

TEST(SessionOverlays, KeptLightsAreThoseOfThePlan) {
    // GL_LIGHT1 is black; GL_LIGHT3 is off. The label is at the middle of the box: (0.5, 0.5), in 200 by 100 pixels.
    const std::string lit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT1);";
    const std::string white = ", GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});";
    const auto text = [](const std::string& scene) {
        return picture_of(scene + kTriangle, kKeptLights).labels.at(0).text;
    };
    const OverlayPicture picture = picture_of(lit + kTriangle, kKeptLights);
    ASSERT_EQ(picture.labels.size(), 1u);
    EXPECT_EQ(picture.labels[0].text, "light 0; not 1");
    EXPECT_EQ(picture.labels[0].place, glm::dvec2(150, 25));
    EXPECT_EQ(text("glEnable(GL_LIGHTING); glEnable(GL_LIGHT1);"), "no light; not 1");
    EXPECT_EQ(text("glEnable(GL_LIGHTING);"), "no light");
    EXPECT_EQ(text(lit + "glLightfv(GL_LIGHT1" + white), "lights 0, 1");
    std::string most = lit;
    for (const char* number : {"2", "3", "4", "6", "7"})
        most += "glEnable(GL_LIGHT" + std::string(number) + "); glLightfv(GL_LIGHT" + number + white;
    EXPECT_EQ(text(most), "lights 0, 2 to 4, 6, 7; not 1");
    EXPECT_TRUE(picture_of(kTriangle, kKeptLights).labels.empty());                                   // unlit
    EXPECT_TRUE(picture_of("glTranslatef(3, 0, 0);" + lit + kTriangle, kKeptLights).labels.empty());  // outside
}

TEST(SessionOverlays, LabelsDoNotCoverEachOther) {
    const std::string lit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);";
    // The second is at the same place and says the same; the third is beside the first, and the fourth says something else.
    const OverlayPicture picture = picture_of(
        lit + kTriangle + kTriangle + "glTranslatef(-0.25, 0, 0);" + kTriangle + "glEnable(GL_LIGHT1);" + kTriangle,
        kKeptLights);
    ASSERT_EQ(picture.labels.size(), 3u);
    EXPECT_EQ(picture.labels[0].place, glm::dvec2(150, 25));
    EXPECT_EQ(picture.labels[1].place, glm::dvec2(125, 43));
    EXPECT_EQ(picture.labels[2].place, glm::dvec2(125, 61));
    EXPECT_EQ(picture.labels[2].text, "light 0; not 1");
}

TEST(SessionOverlays, NothingIsOnAtFirst) {
    EXPECT_FALSE(any(Overlays{}));
    EXPECT_TRUE(any(kKeptLights));
}

}  // namespace
}  // namespace twinlight::session::session_overlays_test
