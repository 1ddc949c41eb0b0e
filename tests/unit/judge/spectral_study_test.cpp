// The study of spectral samples: its measurements, sentences and files.
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "judge/study/spectral.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::study::spectral_study_test {
namespace {

Frame frame_of(const std::string& text) {
    return make_frame(read_scene(text, "scene.gl", "scene"), {.width = 8, .height = 8});
}

int samples_of(const Frame& frame) {
    const auto& spectrum = std::get<Draw>(frame.items.back()).lighting.light_model.spectrum;
    return spectrum ? spectrum->count() : 0;
}

// Pictures whose grey grows with the number of samples, drawn in no time.
SpectralStudy study_of(int rounds, int stop_after = 1000) {
    const SpectralRenderers renderers = {.reference =
                                             [](const Frame& frame) {
                                                 const float grey = static_cast<float>(samples_of(frame)) / 100;
                                                 return Image(frame.width, frame.height, {grey, grey, grey, 1});
                                             },
                                         .shaders = [](const Frame&) { return [] {}; },
                                         .sampling_shaders = [](const Frame&) { return [] {}; }};
    return spectral_study(frame_of("\n#pragma twinlight spectrum(9)\nglutSolidCube(1);"), renderers, kPictureSamples,
                          rounds, [&](int done, int) { return done < stop_after; });
}

TEST(SpectralStudy, IsOfScenesWithSpectra) {
    EXPECT_FALSE(has_spectrum(frame_of("glutSolidCube(1);")));
    const Frame nine = frame_of("\n#pragma twinlight spectrum(9)\nglutSolidCube(1);");
    EXPECT_TRUE(has_spectrum(nine));
    EXPECT_EQ(samples_of(nine), 9);
    EXPECT_EQ(samples_of(with_samples(nine, 31)), 31);
    EXPECT_EQ(samples_of(with_samples(nine, 0)), 0);
    // A part of the scene with red, green and blue takes part, if it is lit by a light's spectrum.
    const char* lit =
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n#pragma twinlight illuminant(GL_LIGHT0, GL_DIFFUSE, A, 1)\n";
    EXPECT_EQ(samples_of(with_samples(frame_of(std::string(lit) + "glutSolidCube(1);"), 31)), 31);
    EXPECT_EQ(samples_of(with_samples(frame_of("glutSolidCube(1);"), 31)), 0);
}

TEST(SpectralStudy, SaysWhereThreeAreExactAndWhereNinePay) {
    const std::vector<std::string> findings = study_of(1).findings;
    ASSERT_EQ(findings.size(), 8U);
    EXPECT_TRUE(findings[0].starts_with("Under D65, red, green and blue are exact")) << findings[0];
    EXPECT_TRUE(findings[1].starts_with("Under D50, their average error is too small to see")) << findings[1];
    EXPECT_EQ(findings[2], "Nine samples are worth their time under A, F2, F11 and LED_B3.");
    EXPECT_EQ(findings[3],
              "A: the Delta E of red, green and blue is 4.2 on average and 12.6 at worst (cyan), that of nine samples "
              "0.3 and "
              "1.0 (blue).");
}

TEST(SpectralStudy, MeasuresPicturesAgainstThatOfAllSamples) {
    const SpectralStudy study = study_of(2);
    for (const SampledPicture& picture : study.pictures) {
        EXPECT_EQ(picture.reference_seconds.size(), 2U);
        EXPECT_EQ(picture.shader_seconds.size(), 2U);
        EXPECT_EQ(picture.sampling_shader_seconds.size(), 2U);
        EXPECT_EQ(picture.off.pixels, 64U);
        EXPECT_EQ(picture.off.max == 0, picture.samples == 81);
    }
    EXPECT_EQ(study.pictures.front().samples, 0);
    EXPECT_EQ(study.pictures.back().samples, 81);
    // The page has three of them side by side.
    const std::string section = spectral_section(study, "");
    for (const char* picture : {"<img alt=\"red, green, blue\"", "<img alt=\"9 samples\"", "<img alt=\"81 samples\""})
        EXPECT_NE(section.find(picture), std::string::npos) << picture;
    EXPECT_EQ(section.find("<img alt=\"5 samples\""), std::string::npos);
}

TEST(SpectralStudy, SaysWhatItHasWhereItIsStopped) {
    const SpectralStudy study = study_of(2, 0);
    EXPECT_TRUE(study.pictures.front().reference_seconds.empty());
    EXPECT_EQ(study.findings.size(), 7U) << "all but the times";
    EXPECT_NE(spectral_text(study).find("12.56"), std::string::npos);
    EXPECT_TRUE(nlohmann::json::parse(spectral_json(study))["pictures"][0]["reference_seconds"].is_null());
}

TEST(SpectralStudy, IsWrittenAsJsonAndAsAPlot) {
    const SpectralStudy study = study_of(1);
    const auto json = nlohmann::json::parse(spectral_json(study));
    EXPECT_EQ(json["patches"].size(), study.patches.size());
    EXPECT_EQ(json["patches"][0]["light"], "A");
    EXPECT_EQ(json["pictures"].size(), study.pictures.size());
    EXPECT_EQ(json["findings"].size(), study.findings.size());
    const std::string svg = spectral_svg(study);
    EXPECT_NE(svg.find("D65 (exact)"), std::string::npos);
    EXPECT_NE(svg.find("LED_B3"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace twinlight::study::spectral_study_test
