// The pragmas for spectra: the state that they set, their errors, their pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "base/math/srgb.h"
#include "render/context/context.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/shape/written_out.h"
#include "scene/state/gl_error.h"
#include "scene/state/state.h"

namespace twinlight::spectral_scenes_test {
namespace {

Frame frame_of(const std::string& text, int size = 16) {
    return make_frame(read_scene(text, "scene.gl", "scene"), {.width = size, .height = size});
}

LightingState lighting_after(const std::string& text) {
    return std::get<Draw>(frame_of(text + "\nglutSolidCube(1);").items.back()).lighting;
}

// A colour as glMaterialfv and glLightfv take it.
void expect_floats_of(Vec3<double> rgb, const glm::dvec4& color) {
    EXPECT_EQ(color.r, double{static_cast<float>(rgb.x)});
    EXPECT_EQ(color.g, double{static_cast<float>(rgb.y)});
    EXPECT_EQ(color.b, double{static_cast<float>(rgb.z)});
    EXPECT_EQ(color.a, 1);
}

// ---- State ----

TEST(SpectralPragmas, SetTheColorThatGLHasForTheSpectrum) {
    const LightingState state = lighting_after(
        "#pragma twinlight reflectance(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, foliage)\n"
        "#pragma twinlight illuminant(GL_LIGHT2, GL_SPECULAR, F11, 0.5)\n");
    const Spectrum *foliage = find_reflectance("foliage"), *f11 = find_illuminant("F11");
    EXPECT_EQ(state.front.reflectances.ambient, foliage);
    EXPECT_EQ(state.front.reflectances.diffuse, foliage);
    EXPECT_EQ(state.front.reflectances.specular, nullptr);
    EXPECT_EQ(state.back.reflectances.diffuse, nullptr);
    expect_floats_of(rgb_of_reflectance(foliage->lines), state.front.diffuse);
    EXPECT_EQ(state.lights[2].specular_illuminant.spectrum, f11);
    EXPECT_EQ(state.lights[2].specular_illuminant.scale, 0.5);
    EXPECT_EQ(state.lights[2].diffuse_illuminant.spectrum, nullptr);
    expect_floats_of(0.5 * rgb_of_light(f11->lines), state.lights[2].specular);
    EXPECT_EQ(state.light_model.spectrum, nullptr) << "only spectrum() decides whether they are used";
}

TEST(SpectralPragmas, HoldUntilAColorIsSet) {
    const std::string spectra =
        "#pragma twinlight spectrum(9)\n#pragma twinlight reflectance(GL_FRONT, GL_DIFFUSE, red)\n"
        "#pragma twinlight illuminant(GL_LIGHT0, GL_DIFFUSE, A, 1)\n";
    EXPECT_EQ(lighting_after(spectra).light_model.spectrum->count(), 9);
    LightingState state = lighting_after(spectra +
                                         "glMaterialfv(GL_FRONT, GL_DIFFUSE, (float[]){1, 1, 1, 1});"
                                         "glLightfv(GL_LIGHT0, GL_DIFFUSE, (float[]){1, 1, 1, 1});\n"
                                         "#pragma twinlight spectrum(0)\n");
    EXPECT_EQ(state.front.reflectances.diffuse, nullptr);
    EXPECT_EQ(state.lights[0].diffuse_illuminant.spectrum, nullptr);
    EXPECT_EQ(state.light_model.spectrum, nullptr);
    // 2.14.3: a property that tracks the current colour gets that colour.
    state = lighting_after(spectra + "glColorMaterial(GL_FRONT, GL_DIFFUSE); glEnable(GL_COLOR_MATERIAL);");
    EXPECT_EQ(state.front.reflectances.diffuse, nullptr);
}

TEST(SpectralPragmas, TellWhatTheyTake) {
    const auto message_of = [](const std::string& pragma) -> std::string {
        try {
            frame_of("#pragma twinlight " + pragma + "\n");
        } catch (const std::exception& error) {
            return error.what();
        }
        return "(nothing was thrown)";
    };
    EXPECT_NE(message_of("spectrum(2)").find("the number of samples must be 0 (red, green and blue) or from 3 to 81"),
              std::string::npos)
        << message_of("spectrum(2)");
    EXPECT_NE(message_of("spectrum(82)").find("3 to 81"), std::string::npos);
    EXPECT_NE(message_of("reflectance(GL_FRONT, GL_DIFFUSE, D65)").find("dark_skin, light_skin"), std::string::npos);
    EXPECT_NE(message_of("reflectance(GL_FRONT, GL_EMISSION, red)").find("GL_AMBIENT_AND_DIFFUSE"), std::string::npos);
    EXPECT_NE(message_of("reflectance(GL_LIGHT0, GL_DIFFUSE, red)").find("GL_FRONT"), std::string::npos);
    EXPECT_NE(message_of("illuminant(GL_LIGHT0, GL_DIFFUSE, red, 1)").find("A, D50, D65, F2, F11, LED_B3"),
              std::string::npos);
    EXPECT_NE(message_of("illuminant(GL_LIGHT0, GL_DIFFUSE, A, -1)").find("0 or more"), std::string::npos);
    EXPECT_NE(message_of("illuminant(GL_LIGHT0, GL_AMBIENT, A, 1)").find("GL_DIFFUSE"), std::string::npos);
    EXPECT_NE(message_of("transfer(cube)").find("linear or srgb"), std::string::npos);
}

TEST(SpectralPragmas, AreGLsCommandsInAProgramInC) {
    const std::string text =
        "#pragma twinlight spectrum(9)\n#pragma twinlight reflectance(GL_BACK, GL_SPECULAR, cyan)\n"
        "#pragma twinlight illuminant(GL_LIGHT1, GL_DIFFUSE, LED_B3, 2)\n#pragma twinlight transfer(srgb)\n";
    const CommandList scene = read_scene(text, "scene.gl", "scene");
    EXPECT_EQ(print_scene(scene), text);
    const std::string program = print_c_program(with_pragmas_written_out(scene));
    EXPECT_NE(program.find("glMaterialfv(GL_BACK, GL_SPECULAR,"), std::string::npos) << program;
    EXPECT_NE(program.find("glLightfv(GL_LIGHT1, GL_DIFFUSE,"), std::string::npos) << program;
    EXPECT_EQ(program.find("reflectance"), std::string::npos) << program;
}

// ---- Pictures ----

// A square over the whole window that faces GL_LIGHT0.
std::string lit_square(const std::string& state) {
    return "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
           "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (float[]){0, 0, 0, 1});\n" +
           state +
           "\nglBegin(GL_QUADS); glNormal3f(0, 0, 1);\n"
           "glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(1, 1); glVertex2f(-1, 1); glEnd();\n";
}

Vec3<double> middle_of(const Image& image) {
    const Rgba& c = image.at(image.width / 2, image.height / 2);
    return {c[0], c[1], c[2]};
}

struct Pictures {
    Vec3<double> reference, shaders, sampling_shaders;
};

Pictures pictures_of(const std::string& text, Shading shading) {
    const Frame frame = frame_of(text);
    programmable::Options options{{{.shading = shading}}};
    const auto context = make_offscreen_context(frame.width, frame.height, ColorBuffer::kFloat);
    programmable::Renderer renderer;
    const Vec3<double> shaders = middle_of(renderer.render(frame, options));
    options.fold_spectra = false;
    return {middle_of(reference::render(frame, reference::Options{options})), shaders,
            middle_of(renderer.render(frame, options))};
}

// For colours of about 1: the shaders multiply and sum up to 81 samples in floats.
constexpr double kFloats = 81 * 1.2e-7;

void expect_near(Vec3<double> a, Vec3<double> b, double tolerance, const std::string& what) {
    EXPECT_NEAR(a.x, b.x, tolerance) << what;
    EXPECT_NEAR(a.y, b.y, tolerance) << what;
    EXPECT_NEAR(a.z, b.z, tolerance) << what;
}

void expect_drawn(const std::string& text, Vec3<double> expected, double tolerance = kFloats) {
    for (const Shading shading : {Shading::kGouraud, Shading::kPhong}) {
        const Pictures pictures = pictures_of(text, shading);
        expect_near(pictures.reference, expected, 1e-6, "reference: floats of a picture\n" + text);
        expect_near(pictures.shaders, expected, tolerance, "shaders\n" + text);
        expect_near(pictures.sampling_shaders, expected, tolerance, "shaders that light in samples\n" + text);
    }
}

// The colour of a patch under a light with n samples, computed directly from the sums.
Vec3<double> patch_under(const char* light, double scale, const char* patch, int n) {
    const SpectralSamples samples(n);
    return scale * samples.color_of_product(samples.of_illuminant(*find_illuminant(light)),
                                            samples.of_reflectance(*find_reflectance(patch)));
}

TEST(SpectralPictures, AreTheSumsOverTheSamples) {
    for (const int n : {3, 5, 9, 81})
        expect_drawn(lit_square("#pragma twinlight spectrum(" + std::to_string(n) +
                                ")\n#pragma twinlight reflectance(GL_FRONT, GL_DIFFUSE, light_skin)\n"
                                "#pragma twinlight illuminant(GL_LIGHT0, GL_DIFFUSE, F2, 0.5)"),
                     patch_under("F2", 0.5, "light_skin", n));
}

TEST(SpectralPictures, OfRedGreenAndBlueUnderWhiteAreGLsOwn) {
    const std::string state = "glMaterialfv(GL_FRONT, GL_DIFFUSE, (float[]){0.25, 0.5, 0.75, 1});";
    expect_drawn(lit_square(state), {0.25, 0.5, 0.75});
    expect_drawn(lit_square("#pragma twinlight spectrum(9)\n" + state), {0.25, 0.5, 0.75});
}

TEST(SpectralPictures, FollowTheCurrentColor) {
    // Two colours, so that they vary per vertex. Light is linear in the colour, so the middle of the picture is the
    // mean.
    const std::string text =
        "#pragma twinlight spectrum(9)\n#pragma twinlight illuminant(GL_LIGHT0, GL_DIFFUSE, A, 0.4)\n"
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glColorMaterial(GL_FRONT, GL_DIFFUSE);\n"
        "glEnable(GL_COLOR_MATERIAL); glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (float[]){0, 0, 0, 1});\n"
        "glNormal3f(0, 0, 1); glBegin(GL_TRIANGLE_STRIP);\n"
        "glColor3f(0.5, 0.25, 0.125); glVertex2f(-1, -1); glVertex2f(-1, 1);\n"
        "glColor3f(0.25, 0.5, 0.75); glVertex2f(1, -1); glVertex2f(1, 1); glEnd();";
    const SpectralSamples samples(9);
    const auto& light = samples.of_illuminant(*find_illuminant("A"));
    const double right = 8.5 / 16;  // the middle of the pixel
    const Vec3<double> color = (1 - right) * Vec3<double>{0.5, 0.25, 0.125} + right * Vec3<double>{0.25, 0.5, 0.75};
    expect_drawn(text, 0.4 * samples.color_of_product(light, samples.of_color(color)));
}

TEST(SpectralPictures, AddTheHighlightOfAMetalAsASecondColor) {
    const std::string text = lit_square(
        "#pragma twinlight spectrum(16)\nglMaterialfv(GL_FRONT, GL_DIFFUSE, (float[]){0, 0, 0, 1});\n"
        "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR); glMaterialf(GL_FRONT, GL_SHININESS, "
        "8);\n"
        "#pragma twinlight reflectance(GL_FRONT, GL_SPECULAR, light_skin)\n"
        "#pragma twinlight illuminant(GL_LIGHT0, GL_SPECULAR, LED_B3, 0.5)");
    expect_drawn(text, patch_under("LED_B3", 0.5, "light_skin", 16));
}

TEST(SpectralPictures, AreClampedWhereTheGamutEnds) {
    // Yellow under an LED has a negative blue channel in sRGB.
    const Vec3<double> yellow = patch_under("LED_B3", 0.8, "yellow", 9);
    ASSERT_LT(yellow.z, -0.01);
    expect_drawn(
        lit_square("#pragma twinlight spectrum(9)\n#pragma twinlight reflectance(GL_FRONT, GL_DIFFUSE, yellow)\n"
                   "#pragma twinlight illuminant(GL_LIGHT0, GL_DIFFUSE, LED_B3, 0.8)"),
        {yellow.x, yellow.y, 0});
}

TEST(SpectralPictures, AreCodedWhereTheSceneAsks) {
    // Causes: the curve, whose slope is at most 12.92, and a driver's pow(), with an error of some 2^-16.
    constexpr double kCoded = 12.92 * kFloats + 4.0 / 65536;
    const std::string state =
        "#pragma twinlight transfer(srgb)\nglMaterialfv(GL_FRONT, GL_DIFFUSE, (float[]){0.001, 0.2, 0.8, 1});";
    expect_drawn(lit_square(state), {srgb_coded(0.001), srgb_coded(0.2), srgb_coded(0.8)}, kCoded);
    EXPECT_EQ(middle_of(reference::render(frame_of(lit_square(state)), {{.shading = {}, .lecture_variants = false}})),
              (Vec3<double>{0.001F, 0.2F, 0.8F}))
        << "GL's model does not convert to sRGB";
}

TEST(SpectralPictures, SayWhatShadersDoNotDo) {
    const Frame frame = frame_of(
        "#pragma twinlight spectrum(9)\n#pragma twinlight reflectance(GL_FRONT, GL_DIFFUSE, red)\n"
        "glEnable(GL_LIGHTING); glBegin(GL_TRIANGLES); glVertex2f(0, 0); glMaterialfv(GL_FRONT, GL_DIFFUSE, "
        "(float[]){1, 1, 1, 1}); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();");
    ASSERT_EQ(frame.unsupported.size(), 1U);
    EXPECT_EQ(frame.unsupported[0].missing_from, MissingFrom::kShaders);
}

}  // namespace
}  // namespace twinlight::spectral_scenes_test
