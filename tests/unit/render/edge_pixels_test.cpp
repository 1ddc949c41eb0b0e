// The edge mask: where two correct rasterisers may choose different triangles (docs/edges.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../small_frames.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

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

// A triangle that covers all of the window to the left of x.
Draw left_of(double x, const glm::dvec4& color = kRed) {
    return window_draw(kSize, kSize, kGL_TRIANGLES,
                       {vertex(x, -100, color), vertex(x, 300, color), vertex(-300, 100, color)});
}
Draw right_of(double x, const glm::dvec4& color = kGreen) {
    return window_draw(kSize, kSize, kGL_TRIANGLES,
                       {vertex(x, 300, color), vertex(x, -100, color), vertex(300, 100, color)});
}

// 3.5.1 samples at the centre, and a rasteriser moves a border by 1/256 of a pixel.
TEST(EdgePixels, AreWhereTheBorderPassesBesideTheCentre) {
    EXPECT_EQ(marked(edges({left_of(8.5)})), rectangle(8, 0, 9, 16));
    EXPECT_EQ(marked(edges({left_of(8.5 + 0.9 / 256)})), rectangle(8, 0, 9, 16));
    EXPECT_EQ(marked(edges({left_of(8.5 - 0.9 / 256)})), rectangle(8, 0, 9, 16));
    EXPECT_TRUE(marked(edges({left_of(8.5 + 1.1 / 256)})).empty());
    EXPECT_TRUE(marked(edges({left_of(8.5 - 1.1 / 256)})).empty());
    Pixels found = marked(edges({quad(2.5, 3.5, 10.5, 11.5)}));
    EXPECT_TRUE(found.count({4, 5}));    // the diagonal from (2.5, 3.5) to (10.5, 11.5)
    EXPECT_TRUE(found.count({4, 9}));    // the other diagonal: either cut is correct
    EXPECT_FALSE(found.count({6, 4}));   // inside, away from both diagonals
    EXPECT_FALSE(found.count({13, 5}));  // the background
}

TEST(EdgePixels, AreNotTheRimOfTheViewport) {
    EXPECT_TRUE(marked(edges({without_diagonal(deep_quad(kRed, 0.5))})).empty());
}

TEST(EdgePixels, AreNotWhereHiddenThingsHaveTheirBorders) {
    const Draw front = without_diagonal(deep_quad(kRed, 0.25));
    Draw behind = quad(2.5, 3.5, 10.5, 9.5, kGreen, -0.5);
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
    // Their depths are equal at x = 16 (0.19 = 0.48 - 0.29): move that to x = 8.5.
    for (Vertex& v : falling.vertices.edit()) v.position_object.z += 2 * 7.5 / 400;
    EXPECT_EQ(marked(edges({rising, falling})), rectangle(8, 0, 9, 16));
}

TEST(EdgePixels, AreAllOfTwoSurfacesThatLieInEachOther) {
    Draw other = without_diagonal(deep_quad(kGreen, 0.5, kGL_LEQUAL));
    other.vertices.edit()[1].position_object.x += 10;  // another triangle in the same plane
    EXPECT_EQ(marked(edges({without_diagonal(deep_quad(kRed, 0.5)), other})), rectangle(0, 0, 16, 16));
}

// Two steps of the buffer; and both depths are floats, rounded at the corners and at the pixel.
TEST(EdgePixels, AreThoseOfDepthsThatFloatsMayMakeEqual) {
    const auto is_open = [](double steps) {
        Draw other = without_diagonal(deep_quad(kGreen, 0.5 + steps * 0x1p-24, kGL_LEQUAL));
        other.vertices.edit()[1].position_object.x += 10;
        return !marked(edges({without_diagonal(deep_quad(kRed, 0.5)), other})).empty();
    };
    EXPECT_TRUE(is_open(3.9));
    EXPECT_FALSE(is_open(4.1));
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
            return difference.channels(static_cast<std::size_t>((kSize - 1 - y) * kSize + x))[0];
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
    Frame frame = frame_of(kSize, kSize, {quad(2.5, 3.5, 10.5, 9.5)});
    frame.items.emplace_back(Clear{.color = true});
    EXPECT_TRUE(marked(reference::allowed_difference(frame).edge).empty());
}

// 3.8.8 asks for no filter: of three texels in a row the next level has one, which may be any mean of them. Of two it is the mean.
TEST(AllowedDifference, OfGeneratedLevelsIsAnyMeanWhereASideIsOdd) {
    const auto allowed_of = [](int texels) {
        const std::string text = fmt::format(
            "glTexParameteri(GL_TEXTURE_1D, GL_GENERATE_MIPMAP, GL_TRUE);\n"
            "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);\n"
            "glTexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE, {}, 0, GL_LUMINANCE, GL_FLOAT, (GLfloat[]){{0, 0.2, 1}});\n"
            "glEnable(GL_TEXTURE_1D); glBegin(GL_QUADS); glTexCoord1f(0); glVertex2f(-1, -1); glTexCoord1f(400);\n"
            "glVertex2f(1, -1); glVertex2f(1, 1); glTexCoord1f(0); glVertex2f(-1, 1); glEnd();",
            texels);
        const AllowedDifference allowed = reference::allowed_difference(
            make_frame(read_scene(text, "scene.gl", "scene"), {.width = kSize, .height = kSize}));
        return allowed.channels(allowed.index(kSize / 2, kSize / 2))[0];
    };
    EXPECT_EQ(allowed_of(2), 0);
    EXPECT_NEAR(allowed_of(3), 1, 1e-6);
}

// Drivers find rho by differences between pixels. Where the polygon is narrow and its w changes much from side to side, these may be
// more than twice the derivative: here they reach the next level, which is white.
TEST(AllowedDifference, OfCubeMapsHoldsDifferencesBetweenPixels) {
    const auto allowed_of = [](const std::string& triangle, int x, int y) {
        std::string text = "glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n";
        for (Enum face = kGL_TEXTURE_CUBE_MAP_POSITIVE_X; face < kGL_TEXTURE_CUBE_MAP_POSITIVE_X + 6; ++face)
            for (const int level : {0, 1, 2})
                text += fmt::format(
                    "glTexImage2D({}, {}, GL_LUMINANCE, {}, {}, 0, GL_LUMINANCE, GL_FLOAT, (GLfloat[16]){{{}}});\n",
                    face, level, 4 >> level, 4 >> level, level == 0 ? "0" : "1, 1, 1, 1");
        text +=
            "glFrustum(-1, 0, -1, 0, 1, 10); glTexGenfv(GL_R, GL_EYE_PLANE, (GLfloat[]){0, 0, 1, 0});\n"
            "glEnable(GL_TEXTURE_GEN_R); glEnable(GL_TEXTURE_CUBE_MAP); glBegin(GL_TRIANGLES);\n" +
            triangle + "glEnd();";
        const AllowedDifference allowed = reference::allowed_difference(
            make_frame(read_scene(text, "scene.gl", "scene"), {.width = 64, .height = 64}));
        EXPECT_TRUE(allowed.drawn[allowed.index(x, y)]);
        EXPECT_FALSE(allowed.edge[allowed.index(x, y)]);
        return allowed.channels(allowed.index(x, y))[0];
    };
    const std::string end = "glTexCoord4f(0, 1, 0, 0.9); glVertex3f(-2, 0, -6.4);";
    EXPECT_GT(allowed_of("glVertex3f(-3, -6, -9); glVertex3f(-0.5, 1, -2);" + end, 43, 18), 7.0F / 255)
        << "llvmpipe's fixed function has 7 here, and its shaders 0";
    EXPECT_EQ(allowed_of("glVertex3f(-6, -6, -6.4); glVertex3f(1, 1, -6.4);" + end, 40, 17), 0);
}

// The same triangle has the same offset depths (appendix A), but in another state a driver may find another slope.
TEST(AllowedDifference, OfTwoOffsetsIsOpenWhereTheStatesDiffer) {
    const auto is_edge = [](const std::string& state) {
        const std::string triangle =
            "glBegin(GL_TRIANGLES); glVertex3f(-1, -1, -0.5); glVertex3f(1, -1, 0.5); glVertex3f(0, 1, 0.2); "
            "glEnd();\n";
        const std::string text = "glEnable(GL_DEPTH_TEST); glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset(1, 0);\n" +
                                 triangle + "glDepthFunc(GL_NOTEQUAL); glColor3f(1, 0, 0);" + state + triangle;
        const AllowedDifference allowed = reference::allowed_difference(
            make_frame(read_scene(text, "scene.gl", "scene"), {.width = kSize, .height = kSize}));
        return static_cast<bool>(allowed.edge[allowed.index(kSize / 2, kSize / 2)]);
    };
    EXPECT_TRUE(is_edge("glEnable(GL_POLYGON_STIPPLE);"));
    EXPECT_TRUE(is_edge("glPolygonOffset(1, 0.5);"));
    EXPECT_FALSE(is_edge("glPolygonOffset(3, 0);")) << "twice the slope is more than a driver may be off";
    EXPECT_FALSE(is_edge("glDisable(GL_POLYGON_OFFSET_FILL);"));
}

// ---- The colours that an edge pixel may have ----

using Ranges = std::vector<AllowedRange>;

Ranges ranges_at(int x, int y, std::initializer_list<Draw> draws) {
    const AllowedDifference allowed = reference::allowed_difference(frame_of(kSize, kSize, draws));
    const auto found = allowed.ranges.find(static_cast<std::size_t>((kSize - 1 - y) * kSize + x));
    return found == allowed.ranges.end() ? Ranges{} : found->second;
}
Rgba rgba(const glm::dvec4& c) {
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), static_cast<float>(c.a)};
}
// Whether the ranges are exactly these colours, in any order.
testing::AssertionResult are(const Ranges& ranges, std::initializer_list<glm::dvec4> colors) {
    for (const AllowedRange& range : ranges) {
        const bool is_expected = std::ranges::any_of(colors, [&](const glm::dvec4& color) {
            return range == AllowedRange{rgba(color), rgba(color)};
        });
        if (!is_expected)
            return testing::AssertionFailure()
                   << "red " << range.low[0] << " to " << range.high[0] << ", green " << range.low[1] << " to "
                   << range.high[1] << ", alpha " << range.low[3] << " to " << range.high[3];
    }
    if (ranges.size() == colors.size()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << ranges.size() << " colours";
}

TEST(EdgeColors, OfAnOutlineAreTheSurfaceAndWhatIsBehind) {
    EXPECT_TRUE(are(ranges_at(8, 5, {left_of(8.5)}), {kRed, kNothingDrawn}));
    EXPECT_TRUE(are(ranges_at(8, 5, {without_diagonal(deep_quad(kBlue, 0.5)), left_of(8.5)}), {kRed, kBlue}));
    EXPECT_TRUE(ranges_at(7, 5, {left_of(8.5)}).empty()) << "no edge";
}

TEST(EdgeColors, OfTwoFacetsAreThoseOfBoth) {
    EXPECT_TRUE(are(ranges_at(8, 5, {without_diagonal(deep_quad(kBlue, 0.5)), left_of(8.5), right_of(8.5)}),
                    {kRed, kGreen, kBlue}));
    // A T-junction: the end of a border on another.
    Draw upper = right_of(8.5, kWhite);
    upper.vertices.edit()[1] = vertex(8.5, 5.5, kWhite);
    upper.vertices.edit()[2] = vertex(300, 5.5, kWhite);
    Draw lower = right_of(8.5);
    lower.vertices.edit()[0] = vertex(8.5, 5.5, kGreen);
    lower.vertices.edit()[2] = vertex(300, 5.5, kGreen);
    EXPECT_TRUE(are(ranges_at(8, 5, {left_of(8.5), upper, lower}), {kRed, kGreen, kWhite, kNothingDrawn}));
}

TEST(EdgeColors, OfCoplanarSurfacesAreBoth) {
    Draw other = without_diagonal(deep_quad(kGreen, 0.5, kGL_LEQUAL));
    other.vertices.edit()[1].position_object.x += 10;
    EXPECT_TRUE(are(ranges_at(3, 4, {without_diagonal(deep_quad(kRed, 0.5)), other}), {kRed, kGreen}));
}

TEST(EdgeColors, OfALineAreThatAndWhatIsBehind) {
    Draw line = window_draw(kSize, kSize, kGL_LINES, {vertex(3.5, 6.5, kRed), vertex(8.5, 6.5, kRed)});
    EXPECT_TRUE(are(ranges_at(5, 6, {line}), {kRed, kNothingDrawn}));
    EXPECT_TRUE(are(ranges_at(5, 7, {line}), {kRed, kNothingDrawn})) << "its neighbour";
    EXPECT_TRUE(are(ranges_at(5, 8, {line}), {}));
    // Red falls by a fifth at each pixel. What is half a pixel away counts.
    line.vertices.edit()[1].color = {0, 0, 0, 1};
    const Ranges ranges = ranges_at(5, 6, {line});
    ASSERT_EQ(ranges.size(), 2u);
    const AllowedRange& own = ranges[0].high[3] > 0 ? ranges[0] : ranges[1];
    EXPECT_NEAR(own.low[0], 0.5, 1e-6);
    EXPECT_NEAR(own.high[0], 0.7, 1e-6);
}

TEST(EdgeColors, OfBlendingAreMixedWithEachColorBeneath) {
    Draw glass = without_diagonal(deep_quad({0, 0, 1, 0.5}, 0.5));
    glass.raster.depth_test = false;
    glass.fragment.blend = true;
    glass.fragment.blend_src = glass.fragment.blend_src_alpha = kGL_SRC_ALPHA;
    glass.fragment.blend_dst = glass.fragment.blend_dst_alpha = kGL_ONE_MINUS_SRC_ALPHA;
    const Ranges over = ranges_at(8, 5, {right_of(0.25, kGreen), left_of(8.5), glass});
    ASSERT_EQ(over.size(), 2u);
    for (const AllowedRange& range : over) {
        constexpr float kCode = 1.0F / 255;  // products in 8 bits
        EXPECT_TRUE((range.high[0] < 2 * kCode && range.low[1] > 0.5F - 2 * kCode) ||
                    (range.low[0] > 0.5F - 2 * kCode && range.high[1] < 2 * kCode))
            << "half red, or half green, never both";
        for (std::size_t c = 0; c < 3; ++c) EXPECT_LT(range.high[c] - range.low[c], 4 * kCode);
    }
    // Its own border: with it, or without.
    Draw half = left_of(8.5, {0, 0, 1, 0.5});
    half.fragment = glass.fragment;
    EXPECT_EQ(ranges_at(8, 5, {right_of(0.25, kGreen), half}).size(), 2u);
}

TEST(EdgeColors, OfTheAlphaTestAreWithTheFragmentAndWithout) {
    Draw surface = without_diagonal(deep_quad({1, 0, 0, 0.5}, 0.5));
    surface.fragment.alpha_test = true;
    surface.fragment.alpha_func = kGL_GREATER;
    surface.fragment.alpha_ref = 0.5;
    surface.vertices.edit()[1].color.a = 0.5001;
    const Ranges ranges = ranges_at(8, 5, {right_of(0.25, kGreen), surface});
    ASSERT_EQ(ranges.size(), 2u);
    EXPECT_NE(ranges[0].low[0], ranges[1].low[0]);
}

TEST(EdgeColors, OfWhatOnlyAStencilDecidesAreBoth) {
    Draw mark = left_of(8.5);
    mark.fragment.color_mask = {false, false, false, false};
    StencilFace face;
    face.func = kGL_ALWAYS;
    face.ref = 1;
    face.depth_pass = kGL_REPLACE;
    mark.fragment.stencil = StencilTest{face, face};
    Draw marked_only = without_diagonal(deep_quad(kGreen, 0.5));
    face.func = kGL_EQUAL;
    face.depth_pass = kGL_KEEP;
    marked_only.fragment.stencil = StencilTest{face, face};
    EXPECT_TRUE(are(ranges_at(8, 5, {mark, marked_only}), {kGreen, kNothingDrawn}));
    EXPECT_TRUE(ranges_at(7, 5, {mark, marked_only}).empty());
}

// A fan of narrow facets in one pixel: what is kept are eight ranges, which hold all of their colours.
TEST(EdgeColors, OfMoreThanEightSurfacesAreTheirHull) {
    Frame frame = frame_of(kSize, kSize, {});
    for (int i = 0; i < 20; ++i) frame.items.emplace_back(left_of(8.5, {i / 20.0, 1 - i / 20.0, 0, 1}));
    const Ranges ranges = reference::allowed_difference(frame).ranges.at((kSize - 1 - 5) * kSize + 8);
    EXPECT_LE(ranges.size(), 8u);
    for (int i = 0; i < 20; ++i) {
        const auto red = static_cast<float>(i / 20.0);
        EXPECT_TRUE(std::ranges::any_of(ranges, [&](const AllowedRange& range) {
            return range.low[0] <= red && red <= range.high[0];
        })) << i;
    }
    for (const AllowedRange& range : ranges) EXPECT_LT(range.high[0] - range.low[0], 0.3F) << "the nearest are joined";
}

// A facet that is much smaller than a pixel has only the colours between its vertices. Its plane would have others a little farther.
TEST(EdgeColors, OfATinyFacetAreBetweenItsVertices) {
    const double least = 1e-4;
    const Draw tiny = window_draw(kSize, kSize, kGL_TRIANGLES,
                                  {vertex(8.5, 5.5, {0.4, 0, 0, 1}), vertex(8.5 + least, 5.5, {0.5, 0, 0, 1}),
                                   vertex(8.5, 5.5 + least, {0.6, 0, 0, 1})});
    const Ranges ranges = ranges_at(8, 5, {tiny});
    ASSERT_EQ(ranges.size(), 2u);
    const AllowedRange& own = ranges[0].high[3] > 0 ? ranges[0] : ranges[1];
    EXPECT_NEAR(own.low[0], 0.4, 1e-6);
    EXPECT_NEAR(own.high[0], 0.6, 1e-6);
}

}  // namespace
}  // namespace twinlight::edge_pixels_test
