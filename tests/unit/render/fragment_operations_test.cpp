// What happens to fragments in the reference, pixel by pixel of small pictures: clip planes, offsets, widths, tests,
// blending, masks, per-vertex materials.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../small_frames.h"

namespace twinlight::fragment_operations_test {
namespace {

constexpr double kCode = 1.0 / 255;

Draw whole_window(const glm::dvec4& color) { return quad(0, 0, 16, 16, color); }

glm::dvec4 middle(std::initializer_list<Draw> draws) { return pixel(draw_window(draws), 8, 8); }

TEST(Blending, RoundsToTheBufferAtEveryWrite) {
    Draw glass = whole_window({1, 0, 0, 0.5});
    glass.fragment.blend = true;
    glass.fragment.blend_src = glass.fragment.blend_src_alpha = kGL_SRC_ALPHA;
    glass.fragment.blend_dst = glass.fragment.blend_dst_alpha = kGL_ONE_MINUS_SRC_ALPHA;
    const glm::dvec4 once = middle({whole_window(kGreen), glass});
    EXPECT_NEAR(once.r, 0.5, 1e-6);
    EXPECT_NEAR(once.g, 0.5, 1e-6);
    // 0.5 is stored as 128 / 255; the second layer leaves half of that.
    EXPECT_NEAR(middle({whole_window(kGreen), glass, glass}).g, 64 * kCode, 1e-6);
}

TEST(Blending, TakesEachFactorOfTable42) {
    const glm::dvec4 below(0.2, 0.4, 0.6, 0.8);  // stored exactly: 51, 102, 153, 204
    const auto red_with = [&](Enum source, Enum destination) {
        Draw over = whole_window({0.5, 0, 0, 0.4});
        over.fragment.blend = true;
        over.fragment.blend_src = source;
        over.fragment.blend_dst = destination;
        over.fragment.blend_color = {0.25, 0, 0, 0.75};
        return middle({whole_window(below), over}).r;
    };
    const double kAs32Bit = 1e-6;
    EXPECT_NEAR(red_with(kGL_ONE, kGL_ONE), 0.7, kAs32Bit);
    EXPECT_NEAR(red_with(kGL_DST_COLOR, kGL_ZERO), 0.1, kAs32Bit);
    EXPECT_NEAR(red_with(kGL_ONE_MINUS_DST_COLOR, kGL_ZERO), 0.4, kAs32Bit);
    EXPECT_NEAR(red_with(kGL_DST_ALPHA, kGL_ZERO), 0.4, kAs32Bit);
    EXPECT_NEAR(red_with(kGL_SRC_ALPHA_SATURATE, kGL_ZERO), 0.1, kAs32Bit);  // min(0.4, 1 - 0.8)
    EXPECT_NEAR(red_with(kGL_ZERO, kGL_SRC_COLOR), 0.1, kAs32Bit);
    EXPECT_NEAR(red_with(kGL_ZERO, kGL_ONE_MINUS_SRC_ALPHA), 0.12, kAs32Bit);
    EXPECT_NEAR(red_with(kGL_CONSTANT_COLOR, kGL_CONSTANT_ALPHA), 0.125 + 0.15, kAs32Bit);
    EXPECT_NEAR(red_with(kGL_ONE_MINUS_CONSTANT_COLOR, kGL_ONE_MINUS_CONSTANT_ALPHA), 0.375 + 0.05, kAs32Bit);
}

TEST(Blending, TakesEachEquationOfTable41) {
    const auto over = [](Enum equation, Enum of_alpha) {
        Draw draw = whole_window({0.5, 0.2, 0, 0.4});
        draw.fragment.blend = true;
        draw.fragment.blend_src = draw.fragment.blend_src_alpha = kGL_SRC_ALPHA;
        draw.fragment.blend_dst = draw.fragment.blend_dst_alpha = kGL_ONE;
        draw.fragment.blend_equation = equation;
        draw.fragment.blend_equation_alpha = of_alpha;
        return middle({whole_window({0.2, 0.4, 0.6, 0.8}), draw});
    };
    const double kAs32Bit = 1e-6;
    const auto expect_near = [&](const glm::dvec4& found, const glm::dvec4& expected) {
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(found[i], expected[i], kAs32Bit) << i;
    };
    // C_s S is (0.2, 0.08, 0, 0.16), C_d D is (0.2, 0.4, 0.6, 0.8); a difference below 0 is clamped.
    expect_near(over(kGL_FUNC_ADD, kGL_FUNC_SUBTRACT), {0.4, 0.48, 0.6, 0});
    expect_near(over(kGL_FUNC_SUBTRACT, kGL_FUNC_REVERSE_SUBTRACT), {0, 0, 0, 0.64});
    expect_near(over(kGL_FUNC_REVERSE_SUBTRACT, kGL_FUNC_ADD), {0, 0.32, 0.6, 0.96});
    // GL_MIN and GL_MAX ignore the factors.
    expect_near(over(kGL_MIN, kGL_MAX), {0.2, 0.2, 0, 0.8});
    expect_near(over(kGL_MAX, kGL_MIN), {0.5, 0.4, 0.6, 0.4});
}

TEST(AlphaTest, ComparesWhatTheBufferWouldHold) {
    const auto seen = [](Enum func, double alpha, double reference) {
        Draw draw = whole_window({1, 1, 1, alpha});
        draw.fragment.alpha_test = true;
        draw.fragment.alpha_func = func;
        draw.fragment.alpha_ref = reference;
        return middle({draw}) != kNothingDrawn;
    };
    EXPECT_TRUE(seen(kGL_GREATER, 0.6, 0.5));
    EXPECT_FALSE(seen(kGL_GREATER, 0.5, 0.5));
    EXPECT_TRUE(seen(kGL_EQUAL, 0.5, 0.5 + kCode / 4));  // both are 128
    EXPECT_FALSE(seen(kGL_NEVER, 1, 0));
    EXPECT_TRUE(seen(kGL_LESS, 0.1, 0.5));
}

TEST(AlphaTest, LeavesNoDepthOfWhatItTakesAway) {
    Draw hole = deep_quad({1, 0, 0, 0}, 0.2);
    hole.fragment.alpha_test = true;
    hole.fragment.alpha_func = kGL_GREATER;
    EXPECT_EQ(middle({hole, deep_quad(kGreen, 0.5)}), kGreen);
}

TEST(Masks, KeepWhatIsBeneath) {
    Draw red = whole_window(kWhite);
    red.fragment.color_mask = {true, false, false, false};
    EXPECT_EQ(middle({whole_window(kBlue), red}), glm::dvec4(1, 0, 1, 1));
    Draw shallow = deep_quad(kRed, 0.2);
    shallow.raster.depth_mask = false;
    EXPECT_EQ(middle({shallow, deep_quad(kGreen, 0.5)}), kGreen);
}

TEST(Masks, OfAClearAreTheScissorAndTheColors) {
    Frame frame = frame_of(kSize, kSize, {whole_window(kBlue)});
    frame.items.emplace_back(Clear{.color = true,
                                   .scissor = {.enabled = true, .box = {4, 4, 3, 2}},
                                   .color_mask = {true, false, false, false},
                                   .clear_color = kWhite});
    const Image image = reference::render(frame, {});
    EXPECT_EQ(pixel(image, 6, 5), glm::dvec4(1, 0, 1, 1));
    EXPECT_EQ(pixel(image, 7, 5), kBlue);
    EXPECT_EQ(pixel(image, 6, 6), kBlue);
}

TEST(ScissorTest, CutsWhatIsDrawn) {
    Draw draw = whole_window(kWhite);
    draw.fragment.scissor = {.enabled = true, .box = {2, 3, 5, 4}};
    EXPECT_EQ(drawn(draw_window({draw})), rectangle(2, 3, 7, 7));
}

TEST(ClipPlanes, StandInEyeCoordinates) {
    Draw draw = whole_window(kWhite);
    draw.eye_from_object[3] = {4, 0, 0, 1};             // moves the window's square to the right
    draw.raster.clip_planes_eye[5] = {{-1, 0, 0, 10}};  // x <= 10, in eye coordinates
    EXPECT_EQ(drawn(draw_window({draw})), rectangle(4, 0, 10, 16));
}

TEST(PolygonOffset, AddsSlopeAndUnits) {
    // Two equal squares: the second is visible if the offset brings it nearer, by one unit or by its slope.
    const auto second_seen = [](double factor, double units, bool sloped, bool enabled = true) {
        Draw first = deep_quad(kRed, 0.5), second = deep_quad(kGreen, 0.5);
        if (sloped)
            for (Draw* draw : {&first, &second})
                for (Vertex& v : draw->vertices.edit()) v.position_object.z -= v.position_object.x / 64;
        second.raster.polygon_offset = {.factor = factor, .units = units, .fill = enabled};
        return middle({first, second}) == kGreen;
    };
    EXPECT_TRUE(second_seen(0, -1, false));
    EXPECT_FALSE(second_seen(0, -1, false, false));
    EXPECT_FALSE(second_seen(0, 1, false));
    EXPECT_FALSE(second_seen(-1, 0, false));  // it has no slope
    EXPECT_TRUE(second_seen(-1, 0, true));
}

TEST(Widths, AreRoundedToWholePixels) {
    Draw point = window_draw(kSize, kSize, kGL_POINTS, {vertex(8.5, 8.5)});
    point.raster.point_size = 3.4;
    EXPECT_EQ(drawn(draw_window({point})), rectangle(7, 7, 10, 10));
    point.raster.point_size = 0.2;
    EXPECT_EQ(drawn(draw_window({point})), rectangle(8, 8, 9, 9));
    point.vertices = {vertex(8, 8)};
    point.raster.point_size = 4;
    EXPECT_EQ(drawn(draw_window({point})), rectangle(6, 6, 10, 10));
    Draw line = window_draw(kSize, kSize, kGL_LINES, {vertex(2.5, 8.5), vertex(12.5, 8.5)});
    line.raster.line_width = 3;
    EXPECT_EQ(drawn(draw_window({line})), rectangle(2, 7, 12, 10));
}

TEST(VertexMaterials, LightTheirOwnVertices) {
    Draw draw = whole_window(kWhite);
    draw.lighting.enabled = true;
    draw.materials.resize(2);
    draw.materials[0].front.emission = {1, 0, 0, 1};
    draw.materials[1].front.emission = {0, 0, 1, 1};
    draw.lighting.front = draw.materials[0].front;
    for (std::size_t i = 0; i < draw.vertices.size(); ++i)
        draw.vertices.edit()[i].material = draw.vertices.edit()[i].position_object.x > 0;
    const Image image = draw_window({draw});
    // Along x from red to blue, at the pixels' centres. The scene's ambient light adds 0.2 * 0.2 everywhere; values
    // above 1 at the vertices are clamped there (2.14.6).
    const double share = 3.5 / 16;
    EXPECT_NEAR(pixel(image, 3, 8).r, (1 - share) * 1 + share * 0.04, 1e-6);
    EXPECT_NEAR(pixel(image, 3, 8).b, share * 1 + (1 - share) * 0.04, 1e-6);
    EXPECT_NEAR(pixel(image, 3, 8).g, 0.04, 1e-6);
}

TEST(ColorSum, ComesAfterTheTexture) {
    // A black texture removes the diffuse light, but not the separate highlight.
    Texture black;
    black.levels.push_back({.width = 1, .base_format = kGL_RGB, .texels = {glm::vec4(0, 0, 0, 1)}});
    black.min_filter = black.mag_filter = kGL_NEAREST;
    Draw draw = whole_window(kWhite);
    draw.texture.texture = std::make_shared<Texture>(black);
    draw.lighting.enabled = draw.lighting.lights[0].enabled = true;
    draw.lighting.front.specular = {1, 0.5, 0, 1};
    draw.lighting.light_model.color_control = kGL_SEPARATE_SPECULAR_COLOR;
    EXPECT_EQ(middle({draw}), glm::dvec4(1, 0.5, 0, 1));
    draw.lighting.light_model.color_control = kGL_SINGLE_COLOR;
    EXPECT_EQ(middle({draw}), glm::dvec4(0, 0, 0, 1));
}

}  // namespace
}  // namespace twinlight::fragment_operations_test
