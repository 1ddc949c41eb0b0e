// GL_TEXTURE_MAX_ANISOTROPY_EXT (EXT_texture_filter_anisotropic): drivers choose how they filter, so the reference filters as without
// it, and what they choose is within the allowed difference.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../unit/compare_three_ways.h"
#include "scene/command/text.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::anisotropy_test {
namespace {

constexpr int kSide = 64;

// A chequered floor that reaches to the horizon.
std::string floor(const char* filter, double anisotropy) {
    std::string texels;
    for (int i = 0; i < 16 * 16; ++i)
        texels += fmt::format("{}{}", i ? "," : "", (i / 4 + i / 64) % 2 ? 230 : 20 + i / 8);
    return fmt::format(
        "glMatrixMode(GL_PROJECTION); gluPerspective(60, 1, 0.1, 50); glMatrixMode(GL_MODELVIEW);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE); glPixelStorei(GL_UNPACK_ALIGNMENT, 1);\n"
        "GLubyte texels[] = {{{}}};\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 16, 16, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, {}); glEnable(GL_TEXTURE_2D);\n"
        "glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, {});\n"
        "glBegin(GL_QUADS); glTexCoord2f(0, 0); glVertex3f(-3, -0.5, -1); glTexCoord2f(6, 0); glVertex3f(3, -0.5, "
        "-1);\n"
        "glTexCoord2f(6, 20); glVertex3f(3, -0.5, -20); glTexCoord2f(0, 20); glVertex3f(-3, -0.5, -20); glEnd();\n",
        texels, filter, anisotropy);
}

Scene scene_of(const std::string& text) {
    const auto list = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
    return make_scene(list, {.width = kSide, .height = kSide});
}

TEST(Anisotropy, IsTheDriversChoiceWithinTheAllowedDifference) {
    for (const char* filter : {"GL_NEAREST", "GL_LINEAR", "GL_NEAREST_MIPMAP_NEAREST", "GL_LINEAR_MIPMAP_NEAREST",
                               "GL_NEAREST_MIPMAP_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"}) {
        for (const double anisotropy : {1.5, 4.0, 16.0}) {
            SCOPED_TRACE(fmt::format("{}, {}", filter, anisotropy));
            const Scene scene = scene_of(floor(filter, anisotropy));
            EXPECT_TRUE(scene.frame.unsupported.empty());
            const compare::Comparison comparison = compare_three_ways(scene);
            EXPECT_TRUE(comparison.within_tolerance());
        }
    }
}

// The reference draws as without it, and more is allowed only where the filter may show.
TEST(Anisotropy, IsAllowedOnlyWhereTheTextureIs) {
    const Scene with = scene_of(floor("GL_LINEAR_MIPMAP_LINEAR", 16)),
                without = scene_of(floor("GL_LINEAR_MIPMAP_LINEAR", 1));
    EXPECT_EQ(reference::render(with.frame, {}).pixels, reference::render(without.frame, {}).pixels);
    const auto allowed = [](const Scene& scene) { return reference::allowed_difference(scene.frame, {}).channels(); };
    const Image more = allowed(with), less = allowed(without);
    float largest = 0;
    for (int x = 0; x < kSide; ++x) {
        EXPECT_EQ(more.at(x, 2), Rgba{});  // above the horizon
        for (int y = kSide / 2; y < kSide; ++y) largest = std::max(largest, more.at(x, y)[0] - less.at(x, y)[0]);
    }
    EXPECT_GT(largest, 0.05F);
}

// There llvmpipe crashes, so it is not given any.
TEST(Anisotropy, InOneDimensionIsLeftOut) {
    const Scene scene = scene_of(
        "GLubyte texels[] = {10, 200, 40, 90, 160, 30, 250, 120};\n"
        "glTexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE, 8, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);\n"
        "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glEnable(GL_TEXTURE_1D);\n"
        "glTexParameterf(GL_TEXTURE_1D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);\n"
        "glBegin(GL_TRIANGLES); glTexCoord1f(0); glVertex2f(-1, -1); glTexCoord1f(9); glVertex2f(1, -1);\n"
        "glTexCoord1f(2); glVertex2f(0, 1); glEnd();\n");
    EXPECT_TRUE(compare_three_ways(scene).within_tolerance());
}

TEST(Anisotropy, IsKept) {
    const auto state_of = [](const std::string& text) {
        State state({.width = kSide, .height = kSide});
        for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
        return state;
    };
    const auto value = [&](const std::string& text) {
        return tex_parameter_answer(state_of(text), kGL_TEXTURE_2D, kGL_TEXTURE_MAX_ANISOTROPY_EXT);
    };
    EXPECT_EQ(value(""), Answer{1});
    EXPECT_EQ(value("glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4);"), Answer{4});
    EXPECT_EQ(value("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 100);"), Answer{16});
    EXPECT_EQ(value("glPushAttrib(GL_TEXTURE_BIT); glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4); "
                    "glPopAttrib();"),
              Answer{1});
    EXPECT_EQ(state_of("glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.5);").errors().at(0).code,
              kGL_INVALID_VALUE);
}

}  // namespace
}  // namespace twinlight::anisotropy_test
