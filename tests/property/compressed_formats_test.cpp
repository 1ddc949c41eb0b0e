// Generic compressed formats (3.8.1) are replaced by their base formats. llvmpipe would compress such an image by S3TC, which gives
// the 16 texels of a block at most four colours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "../unit/one_pixel.h"

namespace twinlight::compressed_formats_test {
namespace {

class CompressedFormats : public OnePixel {};

// 4 x 4 texels of 16 colours over the window of 16 x 16 pixels. The texel in row t and column s is (17 (4 t + s), 255 s / 3, 255 t / 3).
std::string shown(const std::string& image) {
    std::string texels;
    for (int t = 0; t < 4; ++t)
        for (int s = 0; s < 4; ++s)
            texels += fmt::format("{}, {}, {}, {}, ", 17 * (4 * t + s), 85 * s, 85 * t, 255 - 17 * t);
    return "GLubyte texels[] = {" + texels + "};\n" + image +
           "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
           "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);\n"
           "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
           "glBegin(GL_QUADS); glTexCoord2f(0, 0); glVertex2f(-1, -1); glTexCoord2f(1, 0); glVertex2f(1, -1);\n"
           "glTexCoord2f(1, 1); glVertex2f(1, 1); glTexCoord2f(0, 1); glVertex2f(-1, 1); glEnd();\n";
}
std::string given(const std::string& format) {
    return shown("glTexImage2D(GL_TEXTURE_2D, 0, " + format + ", 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);\n");
}

TEST_F(CompressedFormats, AreReplacedByTheirBaseFormats) {
    const auto at = [&](const std::string& text, int s, int t) { return codes(text, 4 * s + 1, 4 * t + 1); };
    for (const auto& [s, t] : {std::pair(0, 0), {2, 1}, {1, 2}, {3, 3}}) {
        SCOPED_TRACE(fmt::format("{}, {}", s, t));
        const int red = 17 * (4 * t + s), green = 85 * s, blue = 85 * t, alpha = 255 - 17 * t;
        EXPECT_EQ(at(given("GL_COMPRESSED_RGB"), s, t), (Codes{red, green, blue, 255}));
        EXPECT_EQ(at(given("GL_COMPRESSED_RGBA"), s, t), (Codes{red, green, blue, alpha}));
        EXPECT_EQ(at(given("GL_COMPRESSED_LUMINANCE"), s, t), (Codes{red, red, red, 255}));
        EXPECT_EQ(at(given("GL_COMPRESSED_LUMINANCE_ALPHA"), s, t), (Codes{red, red, red, alpha}));
        EXPECT_EQ(at(given("GL_COMPRESSED_INTENSITY"), s, t), (Codes{red, red, red, red}));
        EXPECT_EQ(at("glColor3f(1, 1, 0);\n" + given("GL_COMPRESSED_ALPHA"), s, t), (Codes{255, 255, 0, alpha}));
        const std::string mipmaps =
            "gluBuild2DMipmaps(GL_TEXTURE_2D, GL_COMPRESSED_RGB, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, texels);\n";
        EXPECT_EQ(at(shown(mipmaps), s, t), (Codes{red, green, blue, 255}));
        const std::string copy =
            "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB, 0, 0, 16, 16, 0); glClear(GL_COLOR_BUFFER_BIT);\n"
            "glBegin(GL_QUADS); glTexCoord2f(0, 0); glVertex2f(-1, -1); glTexCoord2f(1, 0); glVertex2f(1, -1);\n"
            "glTexCoord2f(1, 1); glVertex2f(1, 1); glTexCoord2f(0, 1); glVertex2f(-1, 1); glEnd();\n";
        EXPECT_EQ(at(given("GL_COMPRESSED_RGB") + copy, s, t), (Codes{red, green, blue, 255}));
    }
}

}  // namespace
}  // namespace twinlight::compressed_formats_test
