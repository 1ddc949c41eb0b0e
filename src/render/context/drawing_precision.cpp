#include "render/context/drawing_precision.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/context/context.h"
#include "render/context/gl.h"

namespace twinlight {

namespace {

// Draws a triangle whose vertices lie half a step beside the driver's grid. Its red and green are the place in the window. Returns
// how far the colours are from those of the pixels' centres.
double measure_position() {
    constexpr int kSide = 64;
    const auto context = make_offscreen_context(kSide, kSide, ColorBuffer::kFloat);
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    const double half = std::ldexp(0.5, -bits);
    const auto vertex = [&](int x, int y) {
        const double at_x = (x + half) / kSide, at_y = (y + half) / kSide;
        glColor3d(at_x, at_y, 1);
        glVertex2d(2 * at_x - 1, 2 * at_y - 1);
    };
    glBegin(GL_TRIANGLES);
    vertex(1, 1);
    vertex(62, 3);
    vertex(2, 61);
    glEnd();
    const Image image = read_pixels(kSide, kSide);
    double worst = 0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const Rgba& pixel = image.at(x, kSide - 1 - y);
            if (pixel[2] == 0) continue;
            worst = std::max({worst, std::abs(kSide * double{pixel[0]} - (x + 0.5)),
                              std::abs(kSide * double{pixel[1]} - (y + 0.5))});
        }
    }
    // What is left without rounded positions is the error of floats.
    return worst > half / 2 ? worst : 0;
}

// Draws a point for each of many colours near the middle between two codes.
double measure_conversion() {
    constexpr int kSide = 128, kCodes = 255, kEach = 64;  // on both sides of each middle
    constexpr double kLargest = 0.2, kStep = 2 * kLargest / kEach;
    const auto context = make_offscreen_context(kSide, kSide);
    const auto beside = [](int i) { return (i % kEach + 0.5) * kStep - kLargest; };
    const auto color = [&](int i) {
        return static_cast<float>((i / kEach + 0.5 + beside(i)) / 255);
    };  // NOLINT(bugprone-integer-division)
    glDisable(GL_DITHER);
    glBegin(GL_POINTS);
    for (int i = 0; i < kCodes * kEach; ++i) {
        glColor3f(color(i), color(i), color(i));
        glVertex2d((2 * (i % kSide) + 1.0) / kSide - 1,
                   (2 * (i / kSide) + 1.0) / kSide - 1);  // NOLINT(bugprone-integer-division)
    }
    glEnd();
    const Image image = read_pixels(kSide, kSide);
    double worst = 0;
    for (int i = 0; i < kCodes * kEach; ++i) {
        const int nearest = i / kEach + (beside(i) > 0 ? 1 : 0);
        for (int c = 0; c < 3; ++c)
            if (channel_code(image.at(i % kSide, kSide - 1 - i / kSide)[static_cast<std::size_t>(c)]) != nearest)
                worst = std::max(worst, std::abs(beside(i)) + kStep);
    }
    return worst;
}

// Draws a texture whose two coordinates change along the diagonal, the same along x and y. Its levels show their numbers. rho is
// sqrt(2) times the change of one coordinate; 3.8.8 also allows 1 to 2 times.
bool measure_rho() {
    constexpr int kSide = 16, kTexels = 256, kLevels = 9, kStep = 28;  // the colour's code is kStep times the level
    constexpr double kChange = 2;                                      // texels a pixel
    const auto context = make_offscreen_context(kSide, kSide);
    for (int level = 0; level < kLevels; ++level) {
        const int size = kTexels >> level;
        const std::vector<GLubyte> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                                          static_cast<GLubyte>(kStep * level));
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, level, GL_LUMINANCE, size, size, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    const auto vertex = [&](int x, int y) {
        const double along = kChange * (x + y) / kTexels;
        glTexCoord2d(along, along);
        glVertex2d(2.0 * x / kSide - 1, 2.0 * y / kSide - 1);
    };
    glBegin(GL_TRIANGLE_STRIP);
    vertex(0, 0);
    vertex(kSide, 0);
    vertex(0, kSide);
    vertex(kSide, kSide);
    glEnd();
    const double lambda = channel_code(read_pixels(kSide, kSide).at(kSide / 2, kSide / 2)[0]) / double{kStep};
    constexpr double kLogarithm = 0.1;  // more than the error of a logarithm, and of the colour's code
    return std::abs(lambda - std::log2(kChange * std::sqrt(2.0))) > kLogarithm;
}

}  // namespace

DrawingPrecision measure_drawing_precision() { return {measure_position(), measure_conversion(), measure_rho()}; }

}  // namespace twinlight
