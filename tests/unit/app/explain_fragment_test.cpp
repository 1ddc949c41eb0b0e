// `twinlight explain --pixel`: texture, colour sum and fog with their numbers. Values by hand; then the printed numbers,
// multiplied and added here, give the printed colours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../run_program.h"
#include "base/image/file.h"
#include "base/text/json.h"

namespace twinlight::explain_fragment_test {
namespace {

using nlohmann::json;

constexpr double kRounding = 1e-12;

// A quadrilateral over the whole picture of 64 x 64 pixels, half a unit before the eye's plane. A texture of 2 x 2 texels
// whose first row is 0 and 255, the second 51 and 102.
constexpr const char* kTexture =
    "glPixelStorei(GL_UNPACK_ALIGNMENT, 1);\n"
    "glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, (GLubyte[]){0, 255, 51, "
    "102});\n"
    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glEnable(GL_TEXTURE_2D);\n";
constexpr const char* kQuad =
    "glColor4f(0.5, 0.25, 1, 0.75); glBegin(GL_TRIANGLES); glTexCoord2f(-1, 0); glVertex3f(-3, -1, -0.5);\n"
    "glTexCoord2f(1, 0); glVertex3f(1, -1, -0.5); glTexCoord2f(1, 2); glVertex3f(1, 3, -0.5); glEnd();\n";

class ExplainFragment : public testing::Test {
  protected:
    std::string explained(const std::string& text, std::vector<std::string> more = {}) {
        write_file_atomically(in_ / "scene.gl", text);
        std::vector<std::string> arguments = {"explain", in_ / "scene.gl", "--size", "64x64", "--pixel", "40,20"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = run_program("twinlight", arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.out;
    }
    json fragment(const std::string& text, std::vector<std::string> more = {}) {
        more.emplace_back("--json");
        const json parsed = json::parse(explained(text, more), nullptr, false);
        EXPECT_EQ(parsed["fragments"].size(), 1u) << text;
        return parsed["fragments"][0];
    }

    const TemporaryFolder in_;
};

glm::dvec4 vec4(const json& j) {
    return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>(), j[3].get<double>()};
}
void expect_near(const glm::dvec4& actual, const glm::dvec4& expected, const std::string& what) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(actual[i], expected[i], kRounding) << what << ", " << i;
}

// The pixel 40,20 is at s = 40.5/64 and, counted from below, t = 43.5/64.
constexpr double kS = 40.5 / 64, kT = 43.5 / 64;

TEST_F(ExplainFragment, ShowsAMagnifiedTextureWithItsTexels) {
    const json seen = fragment(std::string(kTexture) + kQuad), texture = seen["texture"];
    expect_near(vec4(texture["coordinates"]), {kS, kT, 0, 1}, "coordinates");
    EXPECT_NEAR(texture["rho"].get<double>(), 2.0 / 64, kRounding);
    EXPECT_NEAR(texture["lambda"].get<double>(), -5, kRounding);
    EXPECT_EQ(texture["magnified"], true);
    EXPECT_EQ(texture["filter"], "GL_LINEAR");
    EXPECT_EQ(texture["format"], "GL_LUMINANCE");
    EXPECT_EQ(texture["environment"], "GL_MODULATE");
    ASSERT_EQ(texture["levels"].size(), 1u);
    const json& texels = texture["levels"][0]["texels"];
    ASSERT_EQ(texels.size(), 4u);
    const double x = 2 * kS - 0.5, y = 2 * kT - 0.5;  // weights of the second column and row
    const double weights[] = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y}, values[] = {0, 1, 0.2, 0.4};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(texels[i]["i"], i % 2);
        EXPECT_EQ(texels[i]["j"], i / 2);
        EXPECT_EQ(texels[i]["border"], false);
        EXPECT_NEAR(texels[i]["weight"].get<double>(), weights[i], kRounding);
        EXPECT_NEAR(texels[i]["color"][0].get<double>(), values[i], 1e-7);  // a float
        sum += weights[i] * texels[i]["color"][0].get<double>();
    }
    expect_near(vec4(texture["texel"]), {sum, sum, sum, 1}, "texel");
    expect_near(vec4(texture["fragment"]), {0.5, 0.25, 1, 0.75}, "fragment");
    expect_near(vec4(texture["result"]), {0.5 * sum, 0.25 * sum, sum, 0.75}, "result");
    EXPECT_FALSE(seen.contains("fog"));
}

// 2 x 2 texels repeated 24 times over 64 pixels: rho = 0.75; with a bias of 1, lambda = log2(0.75) + 1.
TEST_F(ExplainFragment, ShowsTheLevelsOfAMinifiedTexture) {
    const json texture = fragment(std::string(kTexture) +
                                  "glTexImage2D(GL_TEXTURE_2D, 1, GL_LUMINANCE, 1, 1, 0, GL_LUMINANCE, "
                                  "GL_UNSIGNED_BYTE, (GLubyte[]){255});\n"
                                  "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);\n"
                                  "glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1);\n"
                                  "glMatrixMode(GL_TEXTURE); glScalef(24, 24, 1); glMatrixMode(GL_MODELVIEW);\n" +
                                  kQuad)["texture"];
    expect_near(vec4(texture["coordinates"]), {24 * kS, 24 * kT, 0, 1}, "after the texture matrix");
    EXPECT_NEAR(texture["rho"].get<double>(), 0.75, kRounding);
    const double lambda = std::log2(0.75) + 1;
    EXPECT_NEAR(texture["lambda"].get<double>(), lambda, kRounding);
    EXPECT_EQ(texture["magnified"], false);
    EXPECT_EQ(texture["filter"], "GL_NEAREST_MIPMAP_LINEAR");
    ASSERT_EQ(texture["levels"].size(), 2u);
    EXPECT_NEAR(texture["levels"][0]["weight"].get<double>(), 1 - lambda, kRounding);
    EXPECT_NEAR(texture["levels"][1]["weight"].get<double>(), lambda, kRounding);
    // s = 15.1875 and t = 16.3125: the first texel of both axes, black; the other level is white.
    EXPECT_EQ(texture["levels"][0]["texels"].size(), 1u);
    EXPECT_EQ(texture["levels"][0]["texels"][0]["i"], 0);
    EXPECT_EQ(texture["levels"][0]["texels"][0]["j"], 0);
    EXPECT_NEAR(texture["texel"][0].get<double>(), lambda, kRounding);
}

TEST_F(ExplainFragment, ShowsFogWithItsEquation) {
    const std::string fog = "glEnable(GL_FOG); glFogfv(GL_FOG_COLOR, (GLfloat[]){0.25, 0.5, 1, 1});\n";
    const auto check = [&](const std::string& mode, double factor, const std::string& line) {
        SCOPED_TRACE(mode);
        const json seen = fragment(fog + mode + kQuad);
        EXPECT_NEAR(seen["fog"]["distance"].get<double>(), 0.5, kRounding);
        EXPECT_NEAR(seen["fog"]["factor"].get<double>(), factor, kRounding);
        const glm::dvec4 result(glm::mix(0.25, 0.5, factor), glm::mix(0.5, 0.25, factor), 1, 0.75);
        expect_near(vec4(seen["fog"]["result"]), result, "result");
        const std::string text = explained(fog + mode + kQuad);
        EXPECT_NE(text.find(line), std::string::npos) << text;
        EXPECT_FALSE(seen.contains("texture"));
        EXPECT_EQ(text.find("texture (3.8)"), std::string::npos) << text;
    };
    check("glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_END, 2);\n", 0.75, "= (2 - 0.5) / (2 - 0)\n");
    check("glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_END, 0.25);\n", 0, "= (0.25 - 0.5) / (0.25 - 0), clamped");
    check("glFogf(GL_FOG_DENSITY, 3);\n", std::exp(-1.5), "GL_EXP: e^-(density c) = e^-(3 x 0.5)\n");
    check("glFogi(GL_FOG_MODE, GL_EXP2);\n", std::exp(-0.25), "GL_EXP2: e^-(density c)^2 = e^-(1 x 0.5)^2\n");
}

// C_v and A_v of tables 3.22 and 3.23, for one channel.
double environment(const std::string& mode, const std::string& format, double c, double texel, double texel_alpha,
                   double constant, bool is_alpha) {
    const bool lacks = is_alpha ? format == "GL_RGB" || format == "GL_LUMINANCE" : format == "GL_ALPHA";
    if (lacks) return c;
    const bool as_color = !is_alpha || format == "GL_INTENSITY";
    if (mode == "GL_REPLACE") return texel;
    if (mode == "GL_MODULATE") return c * texel;
    if (mode == "GL_BLEND") return as_color ? c * (1 - texel) + constant * texel : c * texel;
    if (mode == "GL_ADD") return as_color ? std::min(c + texel, 1.0) : c * texel;
    if (is_alpha) return c;
    return c * (1 - texel_alpha) + texel * texel_alpha;  // GL_DECAL
}

TEST_F(ExplainFragment, PrintsNumbersThatMakeTheColor) {
    int found = 0;
    for (const std::string mode : {"GL_MODULATE", "GL_REPLACE", "GL_BLEND", "GL_ADD", "GL_DECAL"}) {
        for (const std::string format : {"GL_RGBA", "GL_RGB", "GL_LUMINANCE_ALPHA", "GL_ALPHA", "GL_INTENSITY"}) {
            if (mode == "GL_DECAL" && format != "GL_RGB" && format != "GL_RGBA") continue;  // our choice
            const bool linear = ++found % 2 == 0;
            SCOPED_TRACE(mode + " " + format);
            const std::string scene =
                fmt::format(
                    "glTexImage2D(GL_TEXTURE_2D, 0, {}, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){{"
                    "10, 200, 30, 40, 250, 60, 70, 80, 90, 100, 110, 220, 130, 140, 50, 160}});\n"
                    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
                    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, {});\n"
                    "glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, (GLfloat[]){{1, 0.5, 0.25, 0.5}});\n"
                    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);\n"
                    "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {});\n"
                    "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (GLfloat[]){{0.125, 0.25, 0.5, 0.75}});\n"
                    "glEnable(GL_TEXTURE_2D); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
                    "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){{0.25, 0.25, 0.25, 1}});\n"
                    "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);\n"
                    "glEnable(GL_FOG); glMatrixMode(GL_TEXTURE); glTranslatef({}, 0, 0);\n"
                    "glMatrixMode(GL_MODELVIEW); glNormal3f(0, 0, 1);\n",
                    format, linear ? "GL_LINEAR" : "GL_NEAREST", mode, linear ? 0.25 : 0.5) +
                kQuad;
            const json seen = fragment(scene), texture = seen["texture"];
            glm::dvec4 texel(0);
            for (const json& level : texture["levels"])
                for (const json& one : level["texels"])
                    texel += level["weight"].get<double>() * one["weight"].get<double>() * vec4(one["color"]);
            expect_near(vec4(texture["texel"]), texel, "texel");
            const bool at_border = texture["levels"][0]["texels"].back()["border"];
            EXPECT_TRUE(at_border);
            const glm::dvec4 before = vec4(texture["fragment"]), constant = vec4(texture["environment_color"]);
            glm::dvec4 color;
            for (int i = 0; i < 4; ++i)
                color[i] = environment(mode, format, before[i], texel[i], format == "GL_RGB" ? 1 : texel.a, constant[i],
                                       i == 3);
            expect_near(vec4(texture["result"]), color, "result");
            for (int i = 0; i < 3; ++i) color[i] = std::min(color[i] + 0.25, 1.0);  // the highlight: shininess is 0
            expect_near(vec4(seen["fog"]["fragment"]), color, "sum");
            const double f = std::exp(-0.5);
            const glm::dvec4 fogged(f * glm::dvec3(color), color.a);  // black fog
            expect_near(vec4(seen["fog"]["result"]), fogged, "fog");
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(seen["color"][i].get<double>(), fogged[static_cast<int>(i)], kRounding);
        }
    }
    EXPECT_EQ(found, 22);
}

TEST_F(ExplainFragment, HasALineForEachStep) {
    const std::string lit =
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glNormal3f(0, 0, 1);\n"
        "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);\n";
    const std::string text = explained(
        kTexture + lit + "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND); glEnable(GL_FOG);\n" + kQuad);
    std::size_t at = 0;
    for (const char* line : {"  texture (3.8) ",
                             "    s, t, r, q   (0.63281, 0.67969, 0, 1)",
                             "    rho          0.03125 ",
                             "    lambda       -5 ",
                             "    filter       GL_LINEAR                       GL_TEXTURE_MAG_FILTER, because lambda",
                             "    level 0      weight 1.00000                  2 x 2 texels\n",
                             "                 texel 0, 0, weight 0.03296 ",
                             "                 texel 1, 1, weight 0.65796 ",
                             "    C_s          the sum of weight times texel; A_s is 1 ",
                             "    C_f ",
                             "    C_c          GL_TEXTURE_ENV_COLOR; A_c is 0 ",
                             "    C_v          GL_BLEND of GL_LUMINANCE: C_f (1 - C_s) + C_c C_s ",
                             "    A_v          1                               A_f: the texture has no alpha\n",
                             "  colour sum (3.9) ",
                             "    c_sec ",
                             "    sum ",
                             "  fog (3.10) ",
                             "    c            0.5 ",
                             "    f            0.60653 ",
                             "    C_r ",
                             "    C_f          GL_FOG_COLOR ",
                             "    C            f C_r + (1 - f) C_f ",
                             "    fragment "}) {
        at = text.find(line, at);
        ASSERT_NE(at, std::string::npos) << line << "\n" << text;
    }
    const std::string projective = std::string(kTexture) + kQuad;
    EXPECT_EQ(explained(projective).find("s/q, t/q"), std::string::npos);
    EXPECT_NE(
        explained("glMatrixMode(GL_TEXTURE); glScalef(2, 2, 2); glMultMatrixf((GLfloat[]){1, 0, 0, 0, 0, 1, 0, 0, "
                  "0, 0, 1, 0, 0, 0, 0, 2}); glMatrixMode(GL_MODELVIEW);\n" +
                  projective)
            .find("s/q, t/q     (0.63281, 0.67969)"),
        std::string::npos);
}

// A point of a sphere by its equation has coordinates of its own.
TEST_F(ExplainFragment, ShowsTheTextureOfAnExactSurface) {
    const std::string text = explained(std::string(kTexture) +
                                           "GLUquadric* ball = gluNewQuadric(); gluQuadricTexture(ball, 1);\n"
                                           "glEnable(GL_DEPTH_TEST); gluSphere(ball, 0.9, 16, 8);\n",
                                       {"--shading", "exact"});
    EXPECT_NE(text.find("of this point of the surface, times the texture matrix"), std::string::npos) << text;
}

// A shadow flattened onto its floor: both are at one depth but for rounding.
TEST_F(ExplainFragment, SaysWhereRoundingDecidesWhichSurfaceShows) {
    const auto floor_and_shadow = [](const std::string& offset) {
        return "glEnable(GL_DEPTH_TEST); glMatrixMode(GL_PROJECTION); gluPerspective(45, 1, 1, 20);\n"
               "glMatrixMode(GL_MODELVIEW); gluLookAt(0, 3, 7, 0, 0, 0, 0, 1, 0);\n"
               "glBegin(GL_QUADS); glVertex3f(-9, 0, -9); glVertex3f(-9, 0, 9); glVertex3f(9, 0, 9);\n"
               "glVertex3f(9, 0, -9); glEnd();\n" +
               offset + "glMultMatrixf((GLfloat[]){1, 0, 0, 0, -0.4, 0, -0.6, 0, 0, 0, 1, 0, 0, 0, 0, 1});\n" +
               "glBegin(GL_QUADS); glVertex3f(-9, 1, -9); glVertex3f(-9, 1, 9); glVertex3f(9, 1, 9);\n"
               "glVertex3f(9, 1, -9); glEnd();\n";
    };
    const std::string note =
        "Surfaces of draws 1, 2 have almost the same depth here, so rounding decides which one shows.";
    EXPECT_NE(explained(floor_and_shadow("")).find(note), std::string::npos);
    EXPECT_NE(explained(floor_and_shadow(""), {"--json"}).find(note), std::string::npos);
    const std::string apart =
        explained(floor_and_shadow("glPolygonOffset(-1, -32); glEnable(GL_POLYGON_OFFSET_FILL);"));
    EXPECT_EQ(apart.find("almost the same depth"), std::string::npos) << apart;
    EXPECT_EQ(explained(kQuad).find("almost the same depth"), std::string::npos);
}

}  // namespace
}  // namespace twinlight::explain_fragment_test
