// The edge mask: where two correct rasterisers may choose different triangles (docs/edges.md).
#include <gtest/gtest.h>

#include <cmath>

#include "../small_frames.h"

namespace twinlight::edge_pixels_test {
namespace {

PixelMask edges(std::initializer_list<Draw> draws) {
    return reference::allowed_difference(frame_of(kSize, kSize, draws)).edge;
}

Pixels marked(const PixelMask& mask) {
    Pixels pixels;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            if (mask[static_cast<std::size_t>((kSize - 1 - y) * kSize + x)]) pixels.insert({x, y});
    return pixels;
}

Draw without_diagonal(Draw draw) {  // one triangle, cut to a rectangle by the viewport
    draw.mode = kGL_TRIANGLES;
    const Vertex& v = draw.vertices[0];
    const double z = v.position_object.z;
    draw.vertices = {vertex(-100, -100, v.color, z), vertex(300, -100, v.color, z), vertex(-100, 300, v.color, z)};
    return draw;
}

TEST(EdgePixels, AreWhereTheBorderPassesThroughTheSquare) {
    Pixels expected = rectangle(2, 3, 11, 10);
    for (const auto& inner : rectangle(3, 4, 10, 9)) expected.erase(inner);
    Pixels found = marked(edges({quad(2.3, 3.3, 10.3, 9.3)}));
    for (const auto& p : expected) EXPECT_TRUE(found.count(p)) << p.first << ',' << p.second;
    EXPECT_TRUE(found.count({4, 5}));   // the diagonal from (2.3, 3.3) to (10.3, 9.3)
    EXPECT_TRUE(found.count({4, 8}));   // the other diagonal: either cut is correct
    EXPECT_FALSE(found.count({6, 4}));  // inside, away from both diagonals
    EXPECT_FALSE(found.count({3, 6}));
    EXPECT_FALSE(found.count({13, 5}));  // the background
}

TEST(EdgePixels, AreNotTheRimOfTheViewport) {
    EXPECT_TRUE(marked(edges({without_diagonal(deep_quad(kRed, 0.5))})).empty());
}

TEST(EdgePixels, AreNotWhereHiddenThingsHaveTheirBorders) {
    const Draw front = without_diagonal(deep_quad(kRed, 0.25));
    Draw behind = quad(2.3, 3.3, 10.3, 9.3, kGreen, -0.5);
    behind.raster.depth_test = true;
    EXPECT_TRUE(marked(edges({front, behind})).empty());
    EXPECT_TRUE(marked(edges({behind, front})).empty());
    behind.raster.depth_test = false;  // writes no depth: later depths are compared with the clear's
    EXPECT_TRUE(marked(edges({behind, front})).empty());
    EXPECT_FALSE(marked(edges({front, behind})).empty());
    Draw painted = front;
    painted.raster.depth_test = false;
    EXPECT_TRUE(marked(edges({behind, painted})).empty());
}

TEST(EdgePixels, AreWhereSurfacesCutEachOther) {
    Draw rising = without_diagonal(deep_quad(kRed, 0)), falling = without_diagonal(deep_quad(kGreen, 0));
    for (Vertex& v : rising.vertices.edit()) v.position_object.z = -(v.position_object.x + 100) / 400 + 0.1;
    for (Vertex& v : falling.vertices.edit()) v.position_object.z = (v.position_object.x + 100) / 400 - 0.48;
    // Their depths are equal at x = 16 (0.19 = 0.48 - 0.29): move that to x = 8.2.
    for (Vertex& v : falling.vertices.edit()) v.position_object.z += 2 * 7.8 / 400;
    EXPECT_EQ(marked(edges({rising, falling})), rectangle(8, 0, 9, 16));
}

TEST(EdgePixels, AreAllOfTwoSurfacesThatLieInEachOther) {
    Draw other = without_diagonal(deep_quad(kGreen, 0.5, kGL_LEQUAL));
    other.vertices.edit()[1].position_object.x += 10;  // another triangle in the same plane
    EXPECT_EQ(marked(edges({without_diagonal(deep_quad(kRed, 0.5)), other})), rectangle(0, 0, 16, 16));
}

TEST(EdgePixels, AreAllOfWhatLiesInAClipPlane) {
    const auto marked_above = [](double height) {  // a surface at z = -0.5, clipped to z >= height
        Draw surface = without_diagonal(deep_quad(kRed, 0.5));
        surface.raster.clip_planes_eye[0] = glm::dvec4(0, 0, 1, -height);
        return marked(edges({surface})).size();
    };
    EXPECT_EQ(marked_above(-0.5), 256u);
    EXPECT_EQ(marked_above(-0.5 - 1e-9), 256u);  // single precision cannot tell these from -0.5
    EXPECT_EQ(marked_above(-0.5 + 1e-9), 256u);
    EXPECT_EQ(marked_above(-0.49), 0u);
    EXPECT_EQ(marked_above(-0.51), 0u);

    Draw point = without_diagonal(deep_quad(kRed, 0.5));  // 8 pixels wide: only its border is open elsewhere
    point.mode = kGL_POINTS;
    point.vertices = {vertex(8, 8, kRed)};
    point.raster.point_size = 8;
    point.raster.clip_planes_eye[0] = glm::dvec4(1, 0, 0, -7.9);
    EXPECT_FALSE(marked(edges({point})).contains({8, 8}));
    point.raster.clip_planes_eye[0] = glm::dvec4(1, 0, 0, -8 - 1e-9);
    EXPECT_TRUE(marked(edges({point})).contains({8, 8}));
}

TEST(EdgePixels, AreThoseOfAPointBesideAPlaneOfTheViewVolume) {
    const auto is_marked_at = [](double z) {  // in clip coordinates, where 1 is the far plane
        Draw point = window_draw(kSize, kSize, kGL_POINTS, {vertex(8, 8, kRed)});
        point.raster.point_size = 8;  // pixels wide: only its border is open elsewhere
        point.vertices.edit()[0].position_object.z = -(z + 1) / 2;
        return marked(edges({point})).contains({8, 8});
    };
    EXPECT_TRUE(is_marked_at(1 + 5e-8));
    EXPECT_TRUE(is_marked_at(1 - 5e-8));
    EXPECT_TRUE(is_marked_at(-1 - 5e-8));
    EXPECT_FALSE(is_marked_at(1 + 1e-5));
    EXPECT_FALSE(is_marked_at(1 - 1e-5));
    EXPECT_FALSE(is_marked_at(1));  // exactly: it is drawn
}

// A spot above the pixel (8, 8) whose cone ends at the centres of the pixels 3 beside it. Rounding decides whether these are lit.
TEST(AllowedDifference, OfPixelsOnTheBorderOfAConeIsTheLight) {
    Draw surface = without_diagonal(deep_quad(kRed, 0.5));
    for (Vertex& v : surface.vertices.edit()) v.normal_object = {0, 0, 1};
    surface.lighting.enabled = true;
    LightSource& light = surface.lighting.lights[0];
    light.enabled = true;
    light.diffuse = {1, 1, 1, 1};
    light.position_eye = {8.5, 8.5, -0.5 + 3 * std::sqrt(3), 1};
    light.spot_cutoff_deg = 30;
    const auto allowed = [&](Shading shading) {
        const AllowedDifference difference =
            reference::allowed_difference(frame_of(kSize, kSize, {surface}), {{.shading = shading}});
        return [difference](int x, int y) {
            return difference.channels.pixels.at(static_cast<std::size_t>((kSize - 1 - y) * kSize + x))[0];
        };
    };
    const auto per_pixel = allowed(Shading::kPhong);
    EXPECT_GT(per_pixel(11, 8), 0.5);
    EXPECT_GT(per_pixel(8, 5), 0.5);
    EXPECT_EQ(per_pixel(10, 8), 0);
    EXPECT_EQ(per_pixel(12, 8), 0);
    EXPECT_EQ(allowed(Shading::kGouraud)(11, 8), 0);  // only vertices are lit
}

TEST(EdgePixels, AreNotWhereTheSameTriangleIsDrawnAgain) {
    for (const Enum depth_func : {kGL_LESS, kGL_LEQUAL, kGL_EQUAL}) {
        const Draw first = without_diagonal(deep_quad(kRed, 0.5));
        EXPECT_TRUE(marked(edges({first, without_diagonal(deep_quad(kGreen, 0.5, depth_func))})).empty());
    }
}

TEST(EdgePixels, AreLinesWithTheirNeighbours) {
    EXPECT_EQ(marked(edges({window_draw(kSize, kSize, kGL_POINTS, {vertex(5.5, 6.5)})})), rectangle(4, 5, 7, 8));
    EXPECT_EQ(marked(edges({window_draw(kSize, kSize, kGL_LINES, {vertex(3.5, 6.5), vertex(8.5, 6.5)})})),
              rectangle(2, 5, 9, 8));
}

TEST(EdgePixels, ForgetWhatWasCleared) {
    Frame frame = frame_of(kSize, kSize, {quad(2.3, 3.3, 10.3, 9.3)});
    frame.items.emplace_back(Clear{.color = true});
    EXPECT_TRUE(marked(reference::allowed_difference(frame).edge).empty());
}

}  // namespace
}  // namespace twinlight::edge_pixels_test
