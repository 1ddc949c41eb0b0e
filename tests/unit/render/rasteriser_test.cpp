// The reference's rasteriser: coverage, interpolation, facing, clipping, depth (GL 2.1 sections 2.12, 3.3
// to 3.5, 4.1.5).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../small_frames.h"
#include "render/reference/geometry/coverage.h"
#include "render/reference/staged_frame.h"

namespace twinlight::rasteriser_test {
namespace {

constexpr double kFloat = 1.0 / (1 << 23);  // an Image stores floats

// ---- Triangles (3.5.1) ----

TEST(Coverage, TakesThePixelsWhoseCentresAreInside) {
    EXPECT_EQ(drawn(draw_window({quad(2.4, 3.4, 6.6, 5.6)})), rectangle(2, 3, 7, 6));
    EXPECT_EQ(drawn(draw_window({quad(2.6, 3.6, 6.4, 5.4)})), rectangle(3, 4, 6, 5));
}

TEST(Coverage, GivesCentresOnTheLeftAndBottomEdgesToThePolygon) {  // as in llvmpipe; see docs/driver.md
    EXPECT_EQ(drawn(draw_window({quad(2.5, 3.5, 6.5, 8.5)})), rectangle(2, 3, 6, 8));
}

TEST(Coverage, DoesNotDependOnTheDirectionOfTheVertices) {
    Draw clockwise = quad(2.5, 3.5, 6.5, 8.5);
    std::swap(clockwise.vertices.edit()[1], clockwise.vertices.edit()[3]);
    EXPECT_EQ(drawn(draw_window({clockwise})), rectangle(2, 3, 6, 8));
}

TEST(Coverage, CountsEveryCentreOnceAmongTrianglesThatShareEdges) {
    // Fans around random points, half of them on pixel centres, fill the window.
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(0, kSize);
    std::uniform_int_distribution<int> pixel_number(0, kSize - 1);
    for (int round = 0; round < 200; ++round) {
        const glm::dvec2 hub = round % 2 ? glm::dvec2(anywhere(random), anywhere(random))
                                         : reference::pixel_centre(pixel_number(random), pixel_number(random));
        const glm::dvec2 rim[] = {{0, 0}, {anywhere(random), 0}, {kSize, 0}, {kSize, kSize}, {0, kSize}, {0, 7.5}};
        std::vector<int> count(kSize * kSize);
        for (int i = 0; i < 6; ++i) {
            reference::Piece piece;
            piece.shape = reference::Shape::kTriangle;
            piece.corners = reference::Corners({{hub}, {rim[i]}, {rim[(i + 1) % 6]}});
            reference::for_each_pixel(piece, {0, 0, kSize, kSize}, [&](int x, int y) { ++count[y * kSize + x]; });
        }
        for (const int n : count) ASSERT_EQ(n, 1) << "round " << round << ", hub " << hub.x << ' ' << hub.y;
    }
}

TEST(Coverage, LeavesOutTrianglesWithoutArea) {
    EXPECT_TRUE(drawn(draw_window({window_draw(kSize, kSize, kGL_TRIANGLES,
                                               {vertex(0.5, 0.5), vertex(5.5, 5.5), vertex(10.5, 10.5)})}))
                    .empty());
}

TEST(Coverage, StaysInsideTheViewport) {
    Draw draw = quad(-100, -100, 100, 100);
    draw.raster.viewport = {3, 4, 5, 6};
    EXPECT_EQ(drawn(draw_window({draw})), rectangle(3, 4, 8, 10));
}

TEST(Coverage, DoesNotDependOnTheNumberOfBands) {
    // 40 rows are three bands; row 15 ends the first one inside the triangle.
    const Frame frame = frame_of(
        kSize, 40,
        {window_draw(kSize, 40, kGL_TRIANGLES, {vertex(1, 1, kRed), vertex(15, 3, kGreen), vertex(7, 39, kBlue)})});
    const Image once = reference::render(frame, {}), again = reference::render(frame, {});
    EXPECT_EQ(once.pixels, again.pixels);
    EXPECT_EQ(drawn(once).count({7, 15}), 1u);
    EXPECT_EQ(drawn(once).count({7, 16}), 1u);
}

// ---- Quadrilaterals and polygons: the ruling on their diagonals ----

// White at corners 1 and 3, black at the others: the centre shows which two the diagonal joins.
double centre_of_checkered(Enum mode, std::array<int, 4> order,
                           reference::QuadCut cut = reference::QuadCut::kFirstToThird) {
    const glm::dvec2 around[] = {{0, 0}, {16, 0}, {16, 16}, {0, 16}};
    std::vector<Vertex> vertices;
    for (const int i : order)
        vertices.push_back(vertex(around[i].x, around[i].y, i % 2 ? kWhite : glm::dvec4(0, 0, 0, 1)));
    reference::Options options;
    options.quad_cut = cut;
    // The mean of two pixels on either side of both diagonals is the value at their crossing, within half a pixel.
    const Image image = draw_window({window_draw(kSize, kSize, mode, vertices)}, options);
    return (pixel(image, 7, 7).r + pixel(image, 8, 8).r + pixel(image, 7, 8).r + pixel(image, 8, 7).r) / 4;
}

TEST(Diagonal, OfAQuadJoinsItsFirstAndThirdVertex) {
    EXPECT_LT(centre_of_checkered(kGL_QUADS, {0, 1, 2, 3}), 0.1);
    EXPECT_GT(centre_of_checkered(kGL_QUADS, {1, 2, 3, 0}), 0.9);
}

TEST(Diagonal, OfAQuadMayJoinTheOtherTwo) {
    EXPECT_GT(centre_of_checkered(kGL_QUADS, {0, 1, 2, 3}, reference::QuadCut::kSecondToFourth), 0.9);
    EXPECT_GT(centre_of_checkered(kGL_QUAD_STRIP, {0, 1, 3, 2}, reference::QuadCut::kSecondToFourth), 0.9);
    EXPECT_LT(centre_of_checkered(kGL_POLYGON, {0, 1, 2, 3}, reference::QuadCut::kSecondToFourth), 0.1);
}

TEST(Diagonal, OfAPolygonStartsAtItsFirstVertex) {
    EXPECT_LT(centre_of_checkered(kGL_POLYGON, {0, 1, 2, 3}), 0.1);
    EXPECT_GT(centre_of_checkered(kGL_POLYGON, {1, 2, 3, 0}), 0.9);
}

TEST(Diagonal, OfAQuadStripJoinsItsFirstAndFourthVertex) {
    EXPECT_LT(centre_of_checkered(kGL_QUAD_STRIP, {0, 1, 3, 2}), 0.1);
    EXPECT_GT(centre_of_checkered(kGL_QUAD_STRIP, {1, 0, 2, 3}), 0.9);
}

// ---- Interpolation ----

TEST(Interpolation, IsLinearInTheWindowWithoutPerspective) {
    const Image image = draw_window(
        {window_draw(kSize, kSize, kGL_TRIANGLES, {vertex(0, 0, kRed), vertex(16, 0, kGreen), vertex(0, 16, kBlue)})});
    const double x = 4.5 / 16, y = 6.5 / 16;
    const glm::dvec4 color = pixel(image, 4, 6);
    EXPECT_NEAR(color.r, 1 - x - y, kFloat);
    EXPECT_NEAR(color.g, x, kFloat);
    EXPECT_NEAR(color.b, y, kFloat);
    EXPECT_EQ(color.a, 1);
}

// A wall from depth 1 at the window's left to depth 3 at its right, in perspective: at a fraction s of the window, the
// fraction of the wall is t = (s / 3) / ((1 - s) / 1 + s / 3) (3.5.1).
Draw slanted_wall() {
    Draw wall;
    wall.mode = kGL_QUADS;
    wall.raster.viewport = {0, 0, kSize, kSize};
    wall.clip_from_eye = glm::frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0);
    for (const auto& [x, y, z] : {std::array{-1.0, -1.0, -1.0}, {3.0, -3.0, -3.0}, {3.0, 3.0, -3.0}, {-1.0, 1.0, -1.0}})
        wall.vertices.edit().push_back({.position_object = {x, y, z, 1}, .color = z == -1 ? kRed : kGreen});
    return wall;
}

TEST(Interpolation, IsPerspectiveCorrect) {
    const Image image = draw_window({slanted_wall()});
    for (int x = 0; x < kSize; ++x) {
        const double s = (x + 0.5) / kSize, t = s / 3 / (1 - s + s / 3);
        EXPECT_NEAR(pixel(image, x, 5).g, t, kFloat) << x;
        EXPECT_NEAR(pixel(image, x, 5).r, 1 - t, kFloat) << x;
    }
}

TEST(Interpolation, OfALineIsPerspectiveCorrect) {
    Draw wall = slanted_wall();
    wall.mode = kGL_LINES;
    wall.vertices = {wall.vertices[0], wall.vertices[1]};
    for (Vertex& v : wall.vertices.edit()) v.position_object.y = 0;
    const Image image = draw_window({wall});
    const double s = 6.5 / kSize, t = s / 3 / (1 - s + s / 3);
    EXPECT_NEAR(pixel(image, 6, 7).g, t, kFloat);  // y is 8 exactly: the line is moved down by e (3.4.1)
}

TEST(Interpolation, IsNotChangedByClipping) {
    // The same wall with its left part behind the eye: the visible part keeps its colours.
    const Draw wall = slanted_wall();
    Draw longer = slanted_wall();
    for (Vertex& v : longer.vertices.edit())  // from t = 0 back to t = -2: depth -3
        if (v.color == kRed) v.position_object = {-9, v.position_object.y < 0 ? 3 : -3, 3, 1};
    // Vertex colours are clamped before clipping (2.14.6): compare the depth, which is not.
    const reference::StagedFrame a = reference::run_stages(frame_of(kSize, kSize, {wall}), {});
    const reference::StagedFrame b = reference::run_stages(frame_of(kSize, kSize, {longer}), {});
    ASSERT_FALSE(b.pieces.empty());
    for (int x = 0; x < kSize; ++x) {
        const glm::dvec2 p = reference::pixel_centre(x, 8);
        EXPECT_NEAR(reference::depth_at(a.pieces[0], p), reference::depth_at(b.pieces[0], p), 1e-14) << x;
    }
}

// ---- Clipping (2.12) ----

TEST(Clipping, CutsAtTheNearAndFarPlanes) {
    // Depth runs from -0.5 at x = 0 to 1.5 at x = 16: inside between x = 4 and x = 12.
    Draw slope = quad(0, 0, 16, 16);
    for (Vertex& v : slope.vertices.edit()) v.position_object.z = 0.5 - 2 * v.position_object.x / 16;
    EXPECT_EQ(drawn(draw_window({slope})), rectangle(4, 0, 12, 16));
}

TEST(Clipping, KeepsColoursLinear) {
    Draw slope = quad(0, 0, 16, 16);
    for (Vertex& v : slope.vertices.edit()) {
        v.color = v.position_object.x == 0 ? kRed : kGreen;
        v.position_object.z = 0.5 - 2 * v.position_object.x / 16;
    }
    const Image image = draw_window({slope});
    EXPECT_NEAR(pixel(image, 4, 3).g, 4.5 / 16, kFloat);
    EXPECT_NEAR(pixel(image, 11, 3).g, 11.5 / 16, kFloat);
}

TEST(Clipping, LeavesNothingOfWhatIsBehindTheEye) {
    Draw wall = slanted_wall();
    for (Vertex& v : wall.vertices.edit()) v.position_object.z = -v.position_object.z;
    EXPECT_TRUE(drawn(draw_window({wall})).empty());
}

TEST(Clipping, OfPositionsWithoutAWindowPlaceIsQuiet) {
    Draw draw = quad(0, 0, 16, 16);
    for (Vertex& v : draw.vertices.edit()) v.position_object = {0, 0, 0, 0};
    EXPECT_TRUE(drawn(draw_window({draw})).empty());
}

TEST(Clipping, DropsPointsWhoseCentreIsOutside) {
    EXPECT_EQ(drawn(draw_window({window_draw(kSize, kSize, kGL_POINTS, {vertex(-0.1, 3), vertex(3.5, 3.5)})})),
              (Pixels{{3, 3}}));
}

// ---- Facing, culling, polygon mode ----

TEST(Facing, FollowsTheSignOfTheWindowAreaAndFrontFace) {
    Draw draw = quad(0, 0, 16, 16);
    draw.raster.cull_enabled = true;  // GL_BACK
    EXPECT_FALSE(drawn(draw_window({draw})).empty());
    draw.raster.front_face = kGL_CW;
    EXPECT_TRUE(drawn(draw_window({draw})).empty());
    draw.raster.cull_face = kGL_FRONT;
    EXPECT_FALSE(drawn(draw_window({draw})).empty());
    draw.raster.cull_face = kGL_FRONT_AND_BACK;
    EXPECT_TRUE(drawn(draw_window({draw})).empty());
}

TEST(Facing, IsAlwaysFrontForPointsAndLines) {
    Draw draw = window_draw(kSize, kSize, kGL_LINES, {vertex(12.2, 3.5), vertex(2.2, 3.5)});
    draw.raster.cull_enabled = true;
    draw.raster.cull_face = kGL_FRONT_AND_BACK;
    EXPECT_EQ(drawn(draw_window({draw})).size(), 10u);
}

TEST(TwoSide, LightsTheBackWithItsMaterialAndTheNormalReversed) {
    Draw draw = quad(0, 0, 16, 16);
    draw.lighting.enabled = true;
    draw.lighting.light_model.ambient = {0, 0, 0, 1};
    draw.lighting.lights[0].enabled = true;  // along +z
    draw.lighting.front.diffuse = kRed;
    draw.lighting.back.diffuse = kGreen;
    draw.lighting.light_model.two_side = true;
    for (const std::optional<Shading> shading : {std::optional<Shading>(), {Shading::kPhong}}) {
        const reference::Options options{{.shading = shading}};
        EXPECT_EQ(pixel(draw_window({draw}, options), 5, 5), kRed);
        Draw back = draw;
        std::swap(back.vertices.edit()[1], back.vertices.edit()[3]);
        EXPECT_EQ(pixel(draw_window({back}, options), 5, 5), (glm::dvec4{0, 0, 0, 1}));  // -n faces away
        for (Vertex& v : back.vertices.edit()) v.normal_object = {0, 0, -1};
        EXPECT_EQ(pixel(draw_window({back}, options), 5, 5), kGreen);
        back.lighting.light_model.two_side = false;  // both faces then have the front's colour
        EXPECT_EQ(pixel(draw_window({back}, options), 5, 5), (glm::dvec4{0, 0, 0, 1}));
    }
}

TEST(PolygonMode, LineDrawsTheBorderWithoutInnerDiagonals) {
    Draw draw = quad(2.3, 3.3, 10.3, 9.3);
    reference::Options other_cut;
    other_cut.quad_cut = reference::QuadCut::kSecondToFourth;
    draw.raster.polygon_mode_front = kGL_LINE;
    Pixels border = rectangle(2, 3, 11, 10);
    for (const auto& inner : rectangle(3, 4, 10, 9)) border.erase(inner);
    EXPECT_EQ(drawn(draw_window({draw})), border);
    EXPECT_EQ(drawn(draw_window({draw}, other_cut)), border);
}

TEST(PolygonMode, LineDrawsTheEdgesThatClippingAdds) {  // 2.12: they are boundary edges
    Draw draw = quad(2.3, 3.3, 10.3, 13.3);
    for (Vertex& v : draw.vertices.edit())
        v.position_object.z = v.position_object.y > 5 ? -2 : 0;  // the far plane cuts it in half
    draw.raster.polygon_mode_front = kGL_LINE;
    EXPECT_EQ(drawn(draw_window({draw})).count({6, 8}), 1u);
}

TEST(PolygonMode, PointDrawsTheVertices) {
    Draw draw = quad(2.3, 3.3, 10.3, 9.3);
    draw.raster.polygon_mode_front = kGL_POINT;
    EXPECT_EQ(drawn(draw_window({draw})), (Pixels{{2, 3}, {10, 3}, {10, 9}, {2, 9}}));
}

TEST(PolygonMode, IsChosenByTheFace) {
    Draw draw = quad(2.3, 3.3, 10.3, 9.3);
    draw.raster.polygon_mode_back = kGL_POINT;
    EXPECT_EQ(drawn(draw_window({draw})), rectangle(2, 3, 10, 9));
    draw.raster.front_face = kGL_CW;
    EXPECT_EQ(drawn(draw_window({draw})).size(), 4u);
}

// ---- Lines and points (3.3, 3.4.1) ----

Pixels line(double x0, double y0, double x1, double y1) {
    return drawn(draw_window({window_draw(kSize, kSize, kGL_LINES, {vertex(x0, y0), vertex(x1, y1)})}));
}

TEST(Line, LeavesTheDiamondItStartsInAndNotTheOneItEndsIn) {
    EXPECT_EQ(line(1.5, 8.5, 6.5, 8.5), rectangle(1, 8, 6, 9));
    EXPECT_EQ(line(14.5, 2.5, 10.5, 2.5), rectangle(11, 2, 15, 3));
    EXPECT_EQ(line(3.5, 2.5, 3.5, 9.5), rectangle(3, 2, 4, 9));
    EXPECT_TRUE(line(4.4, 4.5, 4.6, 4.5).empty());  // never leaves its diamond
}

TEST(Line, OnABorderIsMovedToTheLeftAndDown) {
    EXPECT_EQ(line(1, 1, 6, 1), rectangle(1, 0, 6, 1));
    EXPECT_EQ(line(3, 3, 3, 8), rectangle(2, 3, 3, 8));
}

TEST(Line, OfADiagonalTouchesOnePixelAColumn) {
    EXPECT_EQ(line(1.5, 1.5, 5.5, 5.5), (Pixels{{1, 1}, {2, 2}, {3, 3}, {4, 4}}));
}

TEST(Point, FillsThePixelThatHoldsIt) {
    EXPECT_EQ(drawn(draw_window({window_draw(kSize, kSize, kGL_POINTS, {vertex(5.99, 5.01), vertex(8, 9.5)})})),
              (Pixels{{5, 5}, {8, 9}}));
}

// ---- Depth and clearing (4.1.5, 4.2.3) ----

TEST(Depth, FunctionsCompareTheIncomingWithTheStoredValue) {
    const struct {
        Enum func;
        bool nearer, equal, farther;  // whether it passes
    } cases[] = {{kGL_NEVER, false, false, false}, {kGL_LESS, true, false, false},    {kGL_EQUAL, false, true, false},
                 {kGL_LEQUAL, true, true, false},  {kGL_GREATER, false, false, true}, {kGL_NOTEQUAL, true, false, true},
                 {kGL_GEQUAL, false, true, true},  {kGL_ALWAYS, true, true, true}};
    for (const auto& c : cases) {
        const auto passes = [&](double depth) {
            return pixel(draw_window({deep_quad(kRed, 0.5), deep_quad(kGreen, depth, c.func)}), 5, 5) == kGreen;
        };
        EXPECT_EQ(passes(0.25), c.nearer) << std::hex << c.func;
        EXPECT_EQ(passes(0.5), c.equal) << std::hex << c.func;
        EXPECT_EQ(passes(0.75), c.farther) << std::hex << c.func;
    }
}

TEST(Depth, WithoutTheTestIsPaintersOrderAndWritesNothing) {
    Draw over = deep_quad(kGreen, 0.9);
    over.raster.depth_test = false;
    EXPECT_EQ(pixel(draw_window({deep_quad(kRed, 0.5), over}), 5, 5), kGreen);
    EXPECT_EQ(pixel(draw_window({over, deep_quad(kRed, 0.95)}), 5, 5), kRed);
}

TEST(Depth, MaskKeepsTheStoredValue) {
    Draw unwritten = deep_quad(kGreen, 0.25);
    unwritten.raster.depth_mask = false;
    EXPECT_EQ(pixel(draw_window({unwritten, deep_quad(kRed, 0.5)}), 5, 5), kRed);
}

TEST(Depth, OfTwoPlanesThatCutEachOtherChangesOverWhereTheyMeet) {
    Draw rising = deep_quad(kRed, 0), falling = deep_quad(kGreen, 0);
    for (Vertex& v : rising.vertices.edit()) v.position_object.z = -v.position_object.x / 16;
    for (Vertex& v : falling.vertices.edit()) v.position_object.z = v.position_object.x / 16 - 1;
    const Image image = draw_window({rising, falling});
    EXPECT_EQ(pixel(image, 7, 4), kRed);
    EXPECT_EQ(pixel(image, 8, 4), kGreen);
}

TEST(Clear, FillsTheWholeWindowAndForgetsDepth) {
    Frame frame = frame_of(kSize, kSize, {deep_quad(kRed, 0.25)});
    frame.items.emplace_back(Clear{.color = true, .depth = true, .clear_color = {2, 0.5, 0, 1}});
    EXPECT_EQ(pixel(reference::render(frame, {}), 5, 5), (glm::dvec4{1, 0.5, 0, 1}));
    frame.items.emplace_back(deep_quad(kGreen, 0.75));
    EXPECT_EQ(pixel(reference::render(frame, {}), 5, 5), kGreen);
}

TEST(Clear, OfTheDepthAloneKeepsColours) {
    Frame frame = frame_of(kSize, kSize, {deep_quad(kRed, 0.25)});
    frame.items.emplace_back(Clear{.depth = true, .clear_depth = 0});
    frame.items.emplace_back(deep_quad(kGreen, 0.1));
    EXPECT_EQ(pixel(reference::render(frame, {}), 5, 5), kRed);
}

}  // namespace
}  // namespace twinlight::rasteriser_test
