// Render targets: what they store, and how samples become pixels.
#include "render/context/render_target.h"

#include <gtest/gtest.h>

#include "render/context/gl.h"

namespace twinlight::render_target_test {
namespace {

constexpr int kSide = 4;

constexpr float kRed = 0.29F;  // 73.95 of 255

// Red over the left part of the picture, from 0 to 1.
void draw_left(float part) {
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColor3f(kRed, 0, 0);
    glRectf(-1, -1, 2 * part - 1, 1);
}

TEST(RenderTarget, KeepsFloatsWhereItIsOfFloats) {
    const auto context = make_offscreen_context(kSide, kSide);
    for (const ColorBuffer kind : {ColorBuffer::kUnorm8, ColorBuffer::kFloat}) {
        const RenderTarget target(kSide, kSide, kind);
        target.bind();
        glViewport(0, 0, kSide, kSide);
        draw_left(0.5F);
        target.resolve();
        const Image image = target.read();
        EXPECT_EQ(image.at(0, 0)[0], kind == ColorBuffer::kFloat ? kRed : 74.0F / 255);
        EXPECT_EQ(image.at(kSide - 1, 0)[0], 0);
    }
    // The context's own buffer is current again and unchanged.
    EXPECT_EQ(read_pixels(kSide, kSide).at(0, 0)[0], 0);
}

TEST(RenderTarget, MakesMeansOfSamples) {
    const auto context = make_offscreen_context(kSide, kSide);
    for (const int samples : {2, 4, 8}) {
        const RenderTarget target(kSide, kSide, ColorBuffer::kFloat, samples);
        target.bind();
        glViewport(0, 0, samples * kSide, samples * kSide);
        draw_left(0.375F);  // 1.5 of 4 pixels
        target.resolve();
        const Image image = target.read();
        for (int y = 0; y < kSide; ++y) {
            EXPECT_FLOAT_EQ(image.at(0, y)[0], kRed);
            EXPECT_FLOAT_EQ(image.at(1, y)[0], kRed / 2);
            EXPECT_EQ(image.at(2, y)[0], 0);
        }
    }
}

TEST(RenderTarget, HasRowZeroAtTheTop) {
    const auto context = make_offscreen_context(kSide, kSide);
    const RenderTarget target(kSide, kSide, ColorBuffer::kUnorm8, 2);
    target.bind();
    glViewport(0, 0, 2 * kSide, 2 * kSide);
    draw_left(0);
    glRectf(-1, 0.5F, 1, 1);
    target.resolve();
    const Image image = target.read();
    EXPECT_GT(image.at(0, 0)[0], 0);
    EXPECT_EQ(image.at(0, 1)[0], 0);
}

}  // namespace
}  // namespace twinlight::render_target_test
