// Vertices of which only those are kept that pieces need: what pictures of fine meshes have.
#include "render/reference/vertices/staged_vertices.h"

#include <gtest/gtest.h>

#include "../small_frames.h"
#include "render/reference/staged_frame.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::staged_vertices_test {
namespace {

using reference::StagedVertices;
using reference::StageVertex;

TEST(StagedVertices, KeepTheirNumbers) {
    std::vector<Vertex> vertices;
    for (int i = 0; i < 200; ++i) vertices.push_back(vertex(i, 0));
    const Draw draw = window_draw(kSize, kSize, kGL_POINTS, vertices);
    const std::vector<StageVertex> all = reference::vertex_stage(draw);
    for (const std::vector<std::size_t>& numbers :
         {std::vector<std::size_t>{0, 1, 63, 64, 127, 130, 199}, std::vector<std::size_t>{128}}) {
        std::vector<bool> needed(vertices.size());
        for (const std::size_t number : numbers) needed[number] = true;
        const StagedVertices staged(draw, needed);
        ASSERT_EQ(staged.kept().size(), numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            EXPECT_EQ(staged.number(i), numbers[i]);
            EXPECT_EQ(staged.place(numbers[i]), i);
            EXPECT_EQ(staged[numbers[i]].position_clip, all[numbers[i]].position_clip);
        }
    }
    EXPECT_EQ(StagedVertices(draw, std::vector<bool>(200, true)).kept().size(), 200u);
    EXPECT_EQ(StagedVertices(draw, std::vector<bool>(200)).kept().size(), 0u);
}

std::size_t pieces_of(const Draw& draw) {
    const Frame frame = frame_of(kSize, kSize, {draw});
    return reference::run_stages(frame, {}).pieces.size();
}

// A triangle whose right angle lies at (x, y).
Draw small_triangle(double x, double y, double side) {
    return window_draw(kSize, kSize, kGL_TRIANGLES, {vertex(x, y), vertex(x + side, y), vertex(x, y + side)});
}

TEST(StagedFrame, HasNoPieceOfAPolygonBetweenThePixelsCentres) {
    EXPECT_EQ(pieces_of(small_triangle(3.6, 3.6, 0.5)), 0u);
    EXPECT_EQ(pieces_of(small_triangle(3.6, 3.2, 0.5)), 0u);  // its row has a centre, its column has none
    EXPECT_EQ(pieces_of(small_triangle(3.4, 3.4, 0.5)), 1u);
    EXPECT_EQ(pieces_of(small_triangle(3.5 + 0.9 / 256, 3.4, 0.5)), 1u);  // a driver may move it to the centre
    EXPECT_EQ(pieces_of(small_triangle(3.5 + 1.1 / 256, 3.4, 0.5)), 0u);
}

// The same with many triangles before it that cover no centre.
Draw behind_small_triangles(const Draw& draw) {
    constexpr std::size_t kTriangles = 100;
    Draw result = draw;
    std::vector<Vertex>& vertices = result.vertices.edit();
    const std::size_t count = 3 * kTriangles;
    vertices.insert(vertices.begin(), count, vertices.front());
    for (std::size_t i = 0; i < count; ++i) vertices[i].color = kBlue;
    for (std::size_t i = 0; i < count; i += 3) vertices[i + 1] = vertices[i + 2] = vertices[i];
    for (VertexColumn& column : result.columns)
        column.values.insert(column.values.begin(), count, glm::dvec4(0.3, 0.2, 0.1, 1));
    return result;
}

TEST(StagedFrame, DrawsTheSameWithFewOfItsVertices) {
    const std::string kTexture =
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_FLOAT, (float[]){1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, "
        "1}); "
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glEnable(GL_TEXTURE_2D); ";
    const std::string kTriangles =
        "glBegin(GL_TRIANGLES); "
        "glColor3f(1, 0, 0); glSecondaryColor3f(0, 0.5, 0); glFogCoordf(0.2); glTexCoord2f(0, 0); "
        "glMultiTexCoord2f(GL_TEXTURE1, 1, 0); glNormal3f(0, 0.6, 0.8); glVertex3f(-0.9, -0.8, 0.1); "
        "glColor3f(0, 1, 0.5); glSecondaryColor3f(0.3, 0, 0); glFogCoordf(0.9); glTexCoord2f(2, 0.5); "
        "glMultiTexCoord2f(GL_TEXTURE1, 0, 1); glNormal3f(0.6, 0, 0.8); glVertex3f(0.9, -0.7, -0.4); "
        "glColor3f(0.5, 0, 1); glSecondaryColor3f(0, 0, 0.4); glFogCoordf(0.4); glTexCoord2f(1, 1.5); "
        "glMultiTexCoord2f(GL_TEXTURE1, 0.5, 0.5); glNormal3f(0, 0, 1); glVertex3f(0.1, 0.9, 0.3); glEnd();";
    const std::string kLit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); ";
    for (const std::string& state :
         {std::string(), std::string("glShadeModel(GL_FLAT); "), std::string("glEnable(GL_COLOR_SUM); "), kLit,
          kLit + "glShadeModel(GL_FLAT); ", kLit + "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); glFrontFace(GL_CW); ",
          kLit + "glEnable(GL_COLOR_MATERIAL); ", kTexture, kTexture + "glActiveTexture(GL_TEXTURE1); " + kTexture,
          std::string("glEnable(GL_FOG); glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD); "),
          std::string("glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); ")}) {
        const CommandList commands = read_scene(state + kTriangles, "scene.gl", "scene");
        const Frame few = make_frame(commands, {.width = kSize, .height = kSize});
        Frame many = few;
        for (Draw* draw : many.editable_draws()) *draw = behind_small_triangles(*draw);
        for (const Shading shading : {Shading::kFlat, Shading::kGouraud, Shading::kPhong}) {
            const reference::Options options{{.shading = shading}};
            EXPECT_EQ(reference::render(many, options).pixels, reference::render(few, options).pixels) << state;
            EXPECT_EQ(reference::allowed_difference(many, options).ranges,
                      reference::allowed_difference(few, options).ranges)
                << state;
        }
    }
}

}  // namespace
}  // namespace twinlight::staged_vertices_test
