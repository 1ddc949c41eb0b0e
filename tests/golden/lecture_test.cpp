// What docs/lecture.md and the comments of the scenes say in numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include "../unit/compare_three_ways.h"
#include "app/session/presets.h"
#include "base/image/file.h"
#include "render/reference/reference.h"
#include "scene/scenes/load.h"
#include "scene/shape/report_shapes.h"
#include "scene/state/state.h"

namespace twinlight::lecture_test {
namespace {

constexpr int kWidth = 640, kHeight = 480;
constexpr double kCode = 1 / 255.0;  // one step of an 8-bit channel
constexpr double kRounding = 1;      // two pictures of 8 bits: each is up to half a step off

Scene scene_of(const std::string& name, int step = 0, int width = kWidth, int height = kHeight) {
    const auto file = std::ranges::find(kSceneFiles, name + ".gl", &EmbeddedFile::name);
    const CommandList commands = read_built_in(*file, {.step = step == 0 ? "" : std::to_string(step)});
    return make_scene(std::make_shared<const CommandList>(commands), {.width = width, .height = height});
}

Image picture(const std::string& name, int step = 0, Shading shading = Shading::kPhong) {
    return reference::render(scene_of(name, step).frame, {{.shading = shading}});
}

const Rgba& at(const Image& image, int x, int y) { return image.pixels[static_cast<std::size_t>(y * kWidth + x)]; }

double apart(const Rgba& a, const Rgba& b) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, static_cast<double>(std::abs(a[c] - b[c])));
    return most;
}

double apart(const Image& a, const Image& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) most = std::max(most, apart(a.pixels[i], b.pixels[i]));
    return most;
}

// The largest difference between the columns from left to right and those `shift` pixels further to the right.
double apart_shifted(const Image& image, int left, int right, int top, int bottom, int shift) {
    double most = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) most = std::max(most, apart(at(image, x, y), at(image, x + shift, y)));
    return most;
}

// How many pixels of a rectangle have more of a channel (0 is red) than `level`.
double count_above(const Image& image, int left, int right, int top, int bottom, std::size_t channel, double level) {
    double count = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) count += at(image, x, y)[channel] > level ? 1 : 0;
    return count;
}

// Both lecture pages say so.
void expect_said(const std::string& words) {
    for (const char* page : {"docs/lecture.md", "docs/zh-CN/lecture.md"})
        EXPECT_NE(read_file(page).find(words), std::string::npos) << page << " does not say " << words;
}

bool is_background(const Rgba& color) { return apart(color, {0.28F, 0.31F, 0.37F, 1}) < kCode; }

TEST(LectureTerms, AddUpToTheWhole) {
    const Image ambient = picture("terms", 2), diffuse = picture("terms", 3), specular = picture("terms", 4),
                whole = picture("terms", 5);
    int pixels = 0;
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
        if (is_background(whole.pixels[i])) continue;
        ++pixels;
        for (std::size_t c = 0; c < 3; ++c) {
            const float sum = ambient.pixels[i][c] + diffuse.pixels[i][c] + specular.pixels[i][c];
            // Each of the four pictures is rounded to 8 bits.
            ASSERT_NEAR(whole.pixels[i][c], sum, 4 * kCode / 2 + 1e-6) << i;
            ASSERT_LT(whole.pixels[i][c], 1) << "no channel is cut off";
        }
    }
    EXPECT_GT(pixels, 100'000);
}

// cos(a)^n = t at a^2 = 2 ln(1/t) / n, so twice the exponent gives half the area.
TEST(LectureShininess, TwiceTheExponentGivesHalfTheArea) {
    const Image image = picture("shininess");
    std::vector<double> areas;
    for (int i = 0; i < 8; ++i) {
        const int left = 86 - 72 + 156 * (i % 4), top = i < 4 ? 152 - 72 : 328 - 72;
        areas.push_back(count_above(image, left, left + 144, top, top + 144, 0, 0.5));
    }
    for (std::size_t i = 2; i < 7; ++i) EXPECT_NEAR(areas[i] / areas[i + 1], 2, 0.3) << i;  // the eighth counts as 256
}

TEST(LectureHalfVector, TheSameExponentGivesFourTimesTheAreaAndAMatchedOneNearlyTheSame) {
    const Image image = picture("half-vector", 1);
    const auto area = [&](int center) { return count_above(image, center - 96, center + 96, 144, 336, 1, 0.55); };
    EXPECT_NEAR(area(320) / area(112), 4, 0.7);
    EXPECT_NEAR(area(528) / area(112), 1, 0.1);
    // docs/lecture.md has these numbers.
    EXPECT_NEAR(apart_shifted(image, 16, 208, 144, 336, 208) * 255, 74, kRounding) << "the same exponent";
    EXPECT_NEAR(apart_shifted(image, 16, 208, 144, 336, 416) * 255, 10, kRounding) << "four times the exponent";
    EXPECT_NEAR(apart(picture("half-vector", 2), picture("half-vector", 3)) * 255, 104, kRounding) << "on the floor";
    for (const char* words : {"74/255", "10/255", "104/255"}) expect_said(words);
}

TEST(LectureSeveralLights, AddUp) {
    const Image all = picture("several-lights", 1), red = picture("several-lights", 2),
                green = picture("several-lights", 3), blue = picture("several-lights", 4);
    constexpr double kAmbient = 0.12 * 0.95;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) {
        if (is_background(all.pixels[i])) continue;
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(all.pixels[i][c], red.pixels[i][c] + green.pixels[i][c] + blue.pixels[i][c] - 2 * kAmbient,
                        4 * kCode / 2 + 1e-6);
    }
}

TEST(LectureDistantLight, HasAnErrorThatFallsWithTheDistance) {
    // Without the marker of the lamp, which only the first step has.
    const Image distant = picture("distant-light", 4), near = picture("distant-light", 1);
    const double at_16 = apart(picture("distant-light", 2), distant),
                 at_64 = apart(picture("distant-light", 3), distant);
    EXPECT_NEAR(at_16 / at_64, 4, 0.6);
    EXPECT_NEAR(at_16 * 255, 47, kRounding);
    EXPECT_NEAR(at_64 * 255, 13, kRounding);
    EXPECT_GT(apart(near, distant), 2 * at_16);
    for (const char* words : {"47/255", "13/255"}) expect_said(words);
}

TEST(LectureDistantViewer, GivesAFloorOneColor) {
    const Image local = picture("distant-viewer", 1), distant = picture("distant-viewer", 2);
    EXPECT_LT(apart(at(distant, 320, 460), at(distant, 100, 400)), kCode);
    EXPECT_LT(apart(at(distant, 320, 460), at(distant, 560, 460)), kCode);
    EXPECT_GT(apart(at(local, 320, 460), at(local, 560, 460)), 0.2);
}

// The fixed function attenuates a lamp's ambient light, the course material does not.
TEST(LectureAttenuation, OfAmbientLightChangesTheUnlitSide) {
    const Image attenuated = picture("attenuation", 2), whole = picture("attenuation", 3);
    EXPECT_NEAR(apart(attenuated, whole) * 255, 60, kRounding);
    expect_said("60/255");
}

TEST(LectureInterpolation, GouraudLosesAHighlightInsideOfAPolygon) {
    const Image gouraud = picture("interpolation", 2, Shading::kGouraud), phong = picture("interpolation", 2);
    const auto is_even = [&](const Image& image) {
        for (int y = 145; y < 335; ++y)
            for (int x = 13; x < 203; ++x)
                if (apart(at(image, x, y), at(image, 13, 145)) > kCode) return false;
        return true;
    };
    EXPECT_TRUE(is_even(gouraud));
    EXPECT_FALSE(is_even(phong));
    // The plate of 40 x 40 has it in both.
    EXPECT_LT(apart(at(gouraud, 532, 240), at(phong, 532, 240)), 4 * kCode);
}

TEST(LectureMaterialForms, GiveTheSamePicture) {
    const Image image = picture("material-forms");
    for (int i = 0; i < 3; ++i)
        EXPECT_LE(apart_shifted(image, 14 + 156 * i, 158 + 156 * i, 88, 232, 156), kCode + 1e-6) << "sphere " << i;
    for (int i = 0; i < 4; ++i)
        EXPECT_LE(apart_shifted(image, 14 + 126 * i, 122 + 126 * i, 288, 408, 126), kCode + 1e-6) << "plate " << i;
}

TEST(LectureColorMaterial, IgnoresTheColorWhereItIsNotEnabled) {
    const Image image = picture("color-material", 1);
    for (int i = 0; i < 3; ++i)
        EXPECT_LE(apart_shifted(image, 18 + 156 * i, 154 + 156 * i, 84, 220, 156), kCode + 1e-6) << "above, " << i;
    EXPECT_GT(apart_shifted(image, 18, 154, 260, 396, 156), 0.3) << "below";
}

TEST(LectureNoSpecular, BlackLampsAndABlackMaterialGiveTheSamePicture) {
    EXPECT_EQ(picture("no-specular", 2).pixels, picture("no-specular", 3).pixels);
    EXPECT_GT(apart(picture("no-specular", 1), picture("no-specular", 2)), 0.4);
}

TEST(LectureMaterials, AreThoseOfTheWindow) {
    std::vector<Material> materials;  // of the teapots, each of which is several Draws
    const Scene scene = scene_of("materials");
    for (const Draw* draw : scene.frame.draws())
        if (materials.empty() || draw->lighting.front.diffuse != materials.back().diffuse ||
            draw->lighting.front.specular != materials.back().specular)
            materials.push_back(draw->lighting.front);
    const auto presets = session::material_presets();
    ASSERT_EQ(materials.size(), presets.size());
    for (std::size_t i = 0; i < presets.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto k = static_cast<int>(c);
            EXPECT_EQ(materials[i].ambient[k], static_cast<float>(presets[i].ambient[c])) << presets[i].name;
            EXPECT_EQ(materials[i].diffuse[k], static_cast<float>(presets[i].diffuse[c])) << presets[i].name;
            EXPECT_EQ(materials[i].specular[k], static_cast<float>(presets[i].specular[c])) << presets[i].name;
        }
        EXPECT_NEAR(materials[i].shininess, presets[i].shininess, 1e-4) << presets[i].name;
    }
}

TEST(LectureQueries, ReturnPositionsInEyeCoordinates) {
    const Scene scene = scene_of("queries");
    const Draw& draw = *scene.frame.draws().front();
    const auto& lights = draw.lighting.lights;
    EXPECT_EQ(lights[0].position_eye, glm::dvec4(3, 4, 5, 1));
    // gluLookAt from (5, 3, 8): the lamp is behind the viewer's plane at z = 0 of the eye, minus the distance of the camera.
    EXPECT_NEAR(lights[1].position_eye.z, (3 * 5 + 4 * 3 + 5 * 8) / std::sqrt(98.0) - std::sqrt(98.0), 1e-5);
}

// ---- The lab: how near fixed function comes ----

double rms(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum += std::pow(a.pixels[i][c] - b.pixels[i][c], 2);
    return std::sqrt(sum / static_cast<double>(a.pixels.size()) / 3);
}

const Image& image_of(const compare::Comparison& comparison, const std::string& name) {
    return std::ranges::find(comparison.renders, name, &compare::Render::name)->image;
}

TEST(LectureLab, TheLastStepIsNearerToTheLabThanTheFirstInFixedFunction) {
    const compare::Comparison first = compare_three_ways(scene_of("lab", 1, 160, 120)),
                              last = compare_three_ways(scene_of("lab", 5, 160, 120));
    const Image lab = image_of(first, "reference-phong");
    const double plain = rms(image_of(first, "reference"), lab), fitted = rms(image_of(last, "reference"), lab);
    EXPECT_LT(fitted, plain);
    EXPECT_NEAR(plain * 255, 23, 0.5);
    EXPECT_NEAR(fitted * 255, 5, 0.5);
    for (const char* words : {"23/255", "5/255"}) expect_said(words);
}

// ---- The report's cone ----

// The report writes the side's normal as (cos t, sin t, r / h); with y as the axis it is (cos t, r / h, sin t), normalised.
TEST(LectureCone, TheNormalInTheReportsOrderIsNotPerpendicularToTheSide) {
    constexpr double r = 0.95, h = 2.1;
    const auto cosine = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::dot(glm::normalize(a), glm::normalize(b));
    };
    double worst = 0;
    for (int i = 0; i < 48; ++i) {
        const double t = 2 * std::numbers::pi * i / 48;
        const glm::dvec3 slant = glm::dvec3(0, h, 0) - r * glm::dvec3(std::cos(t), 0, std::sin(t));
        const glm::dvec3 printed(std::cos(t), std::sin(t), r / h), ordered(std::cos(t), r / h, std::sin(t));
        EXPECT_NEAR(cosine(ordered, slant), 0, 1e-15);
        EXPECT_NEAR(glm::length(ordered), 1.0976, 1e-4);
        worst = std::max(worst, std::abs(cosine(printed, slant)));
    }
    EXPECT_NEAR(std::asin(worst) * 180 / std::numbers::pi, 41.73, 0.01) << "degrees from perpendicular";
    const std::vector<ShapePart> cone = report_cone(r, h, 48);
    for (const ShapeVertex& vertex : cone[0].vertices) {
        if (vertex.position_object.y > 0) continue;  // the apex
        EXPECT_NEAR(cosine(vertex.normal_object, glm::dvec3(0, h, 0) - vertex.position_object), 0, 1e-15);
        EXPECT_NEAR(glm::length(vertex.normal_object), 1, 1e-15);
    }
}

}  // namespace
}  // namespace twinlight::lecture_test
