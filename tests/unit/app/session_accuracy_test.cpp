// The window's answer to "how fine must the mesh be": what it says of a study, and that a study can give it.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "app/session/accuracy.h"
#include "app/study_renderers.h"
#include "judge/study/scene_of_choice.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session::session_accuracy_test {
namespace {

constexpr double kCode = 1.0 / 255;

// A study whose points have these errors (in codes) and times.
struct Measured {
    Shading shading;
    int slices;
    double codes, ms;
};
study::Study study_of(const std::vector<Measured>& all) {
    study::Study study;
    study.series.resize(1);
    for (const Measured& one : all) {
        study::Point point;
        point.choice = {.shading = one.shading, .slices = one.slices};
        point.errors.whole.rms = one.codes * kCode;
        point.seconds = {one.ms / 1000};
        study.points.push_back(point);
    }
    return study;
}
std::string sentence(const std::vector<Measured>& all, double target) {
    return accuracy_sentence(accuracy_rows(study_of(all), target), target);
}

const std::vector<Measured> kBall = {{Shading::kGouraud, 24, 2, 1},   {Shading::kGouraud, 48, 0.9, 2.1},
                                     {Shading::kGouraud, 96, 0.2, 4}, {Shading::kPhong, 12, 1.5, 1},
                                     {Shading::kPhong, 24, 0.7, 1.2}, {Shading::kExact, 0, 0.01, 0.9}};

TEST(SessionAccuracy, NamesTheCoarsestMeshThatIsEnough) {
    EXPECT_EQ(sentence(kBall, kCode),
              "For an error of at most 1/255: Gouraud needs 48 slices (2.10 ms). Phong needs 24 slices (1.20 ms). "
              "Exact surfaces take "
              "0.90 ms, which is faster than both.");
    EXPECT_NE(sentence(kBall, 2 * kCode).find("Gouraud needs 24 slices (1.00 ms). Phong needs 12 slices"),
              std::string::npos);
}

TEST(SessionAccuracy, SaysWhichShadingDoesNotReachTheError) {
    EXPECT_NE(sentence(kBall, 0.5 * kCode).find("Phong is not accurate enough: with 24 slices its error is 0.7/255."),
              std::string::npos)
        << sentence(kBall, 0.5 * kCode);
    EXPECT_EQ(sentence({{Shading::kGouraud, 0, 3, 1}}, kCode),
              "For an error of at most 1/255: Gouraud is not accurate enough: its error is 3/255.");
    EXPECT_EQ(sentence({{Shading::kGouraud, 0, 0.5, 1}}, kCode),
              "For an error of at most 1/255: Gouraud is enough (1.00 ms).");
    EXPECT_EQ(sentence({}, kCode), "");
}

TEST(SessionAccuracy, ComparesExactSurfacesWithTheMeshesThatAreEnough) {
    std::vector<Measured> ball = kBall;
    ball.back().ms = 1.5;
    EXPECT_TRUE(sentence(ball, kCode).ends_with("which is between the two."));
    ball.back().ms = 9;
    EXPECT_TRUE(sentence(ball, kCode).ends_with("which is slower."));
    EXPECT_TRUE(sentence(kBall, 0.5 * kCode).ends_with("Exact surfaces take 0.90 ms, which is faster."));
    EXPECT_TRUE(sentence(kBall, 0.1 * kCode).ends_with("Exact surfaces take 0.90 ms."));
}

// More slices, less error; exact surfaces are the picture that the errors are measured from, but for float's rounding.
TEST(SessionAccuracy, AStudyOfABallAnswers) {
    const CommandList ball = read_scene(
        "glMatrixMode(GL_PROJECTION); gluPerspective(45, 1, 0.1, 100); glMatrixMode(GL_MODELVIEW);\n"
        "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);\n"
        "glutSolidSphere(1, 16, 16);\n",
        "ball.gl", "ball");
    const StateOptions size{.width = 32, .height = 32};
    const auto frame_of = [&](int slices) {
        return make_frame(slices == 0 ? ball : study::with_slices(ball, slices), size);
    };
    StudyRenderers renderers(32, 32);
    study::Settings settings;
    settings.seconds = 0;
    settings.choices = accuracy_choices(frame_of(0), study::has_slices(ball));
    const study::Study study = study::run(frame_of, true, renderers.functions(), settings);
    const std::vector<AccuracyRow> rows = accuracy_rows(study, kCode);
    ASSERT_EQ(rows.size(), settings.choices.size());
    EXPECT_EQ(rows.front().shading, "Gouraud");
    EXPECT_EQ(rows.front().slices, 8);
    EXPECT_GT(rows.front().error, rows[8].error);  // 8 and 128 slices
    EXPECT_EQ(rows.back().shading, "Exact surfaces");
    EXPECT_LT(rows.back().error, rows.front().error);
    EXPECT_TRUE(rows.back().is_enough);
    EXPECT_NE(accuracy_sentence(rows, kCode).find("Exact surfaces take"), std::string::npos);
}

TEST(SessionAccuracy, WithoutSlicesMeasuresTheScenesOwnMesh) {
    const Frame triangle =
        make_frame(read_scene("glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();",
                              "t.gl", "t"),
                   {});
    const auto choices = accuracy_choices(triangle, false);
    ASSERT_EQ(choices.size(), 2u);
    EXPECT_EQ(choices[0].slices, 0);
    EXPECT_EQ(choices[1].shading, Shading::kPhong);
}

}  // namespace
}  // namespace twinlight::session::session_accuracy_test
