// The study by derivation: what is changed in a scene, how errors fall into parts, which choices make the front, what is written.
#include "study/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command/text.h"
#include "state/state.h"
#include "study/tessellation.h"

namespace twinlight::study {
namespace {

CommandList scene_of(const std::string& text) { return read_scene(text, "scene.gl", "scene"); }
Frame frame_of(const std::string& text) {
    return make_frame(std::make_shared<const CommandList>(scene_of(text)), {.width = 16, .height = 16});
}

TEST(Tessellation, GivesEveryRoundShapeItsSlices) {
    const CommandList scene = scene_of(
        "GLUquadric *q = gluNewQuadric(); glutSolidSphere(1, 5, 6); glutWireCone(1, 2, 5, 6); glutSolidTorus(1, 2, 5, "
        "6); "
        "gluCylinder(q, 1, 2, 3, 5, 6); gluDisk(q, 1, 2, 5, 6);\n#pragma twinlight shape(cone, 1, 2, 5)\n"
        "glutSolidCube(5); glVertex3f(5, 6, 5);");
    EXPECT_TRUE(has_slices(scene));
    EXPECT_EQ(with_slices(scene, 20).commands,
              scene_of("GLUquadric *q = gluNewQuadric(); glutSolidSphere(1, 20, 10); glutWireCone(1, 2, 20, 10); "
                       "glutSolidTorus(1, 2, 10, 20); gluCylinder(q, 1, 2, 3, 20, 10); gluDisk(q, 1, 2, 20, 10);\n"
                       "#pragma twinlight shape(cone, 1, 2, 20)\nglutSolidCube(5); glVertex3f(5, 6, 5);")
                  .commands);
    EXPECT_FALSE(has_slices(scene_of("glutSolidTeapot(1);\n#pragma twinlight shape(cube, 1)\n")));
}

TEST(Choices, LeaveOutWhatTheSceneHasAndNothingElse) {
    const auto has = [](const Frame& frame, Without without) {
        for (const Choice& choice : choices(frame, true, Extent::kQuick))
            if (choice.without == without) return true;
        return false;
    };
    const std::string lit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); ";
    const Frame plain = frame_of(lit + "glutSolidSphere(1, 8, 8);");
    const Frame rich = frame_of(
        lit +
        "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 2, 3, 1}); glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1); "
        "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 40); glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){1, 1, 1, 1}); "
        "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); glEnable(GL_NORMALIZE); glutSolidSphere(1, 8, 8);");
    for (const Without without : {Without::kSpecular, Without::kLocalViewer, Without::kPlaces, Without::kAttenuation,
                                  Without::kSpots, Without::kNormalize}) {
        EXPECT_FALSE(has(plain, without));
        EXPECT_TRUE(has(rich, without));
        // Nothing of it is left.
        EXPECT_FALSE(has(simplified(rich, without), without));
    }
    const Frame directional = simplified(rich, Without::kPlaces);
    const LightSource& light = std::get<Draw>(directional.items[0]).lighting.lights[0];
    EXPECT_EQ(light.position_eye, glm::dvec4(1, 2, 3, 0));  // seen from the middle of the sphere
}

TEST(Choices, HaveKeysOfTheirOwn) {
    std::set<std::string> keys;
    const std::vector<Choice> all = choices(frame_of("glutSolidSphere(1, 8, 8);"), true, Extent::kFull);
    for (const Choice& choice : all) keys.insert(choice.key());
    EXPECT_EQ(keys.size(), all.size());
}

// ---- A study of pictures that are known ----

constexpr int kSide = 8;

// Everything as bright as the shading says; the right half is another shape, which begins later on coarse meshes.
double brightness(const RenderOptions& options) {
    switch (options.shading.value_or(Shading::kExact)) {
        case Shading::kFlat: return 0.9;
        case Shading::kGouraud: return 0.7;
        case Shading::kPhong: return 0.6;
        case Shading::kExact: return 0.5;
    }
    return 0;
}

Renderers known_renderers() {
    Renderers renderers;
    renderers.fixed = renderers.programmable =
        renderers.reference = [](const Frame& /*frame*/, const RenderOptions& options) {
            return Prepared{[] {},
                            [options] {
                                Image image(kSide, kSide);
                                const auto value = static_cast<float>(brightness(options));
                                for (Rgba& pixel : image.pixels) pixel = {value, value, value, 1};
                                return image;
                            }};
        };
    renderers.seen = [](const Frame& /*frame*/, const RenderOptions& options) {
        std::vector<int> seen(kSide * kSide);
        const int border = options.shading == Shading::kExact ? kSide / 2 : kSide / 2 + 1;
        for (int i = 0; i < kSide * kSide; ++i) seen[static_cast<std::size_t>(i)] = i % kSide < border ? 0 : 1;
        return seen;
    };
    return renderers;
}

Frame known_frame(int /*slices*/) {
    Frame known = frame_of("glutSolidSphere(1, 8, 8);");
    known.width = known.height = kSide;
    return known;
}

Study known_study() {
    return run(known_frame, true, known_renderers(), {.extent = Extent::kQuick, .seconds = 0, .progress = {}});
}

TEST(Study, TellsTheErrorsOfSilhouettesApart) {
    const Study study = known_study();
    EXPECT_EQ(study.rounds, 3);
    for (const Point& point : study.points) {
        EXPECT_EQ(point.seconds.size(), 3u);
        const double error = brightness(point.choice.options()) - 0.5;
        EXPECT_NEAR(point.whole.rms, error, 1e-7);
        EXPECT_NEAR(point.interior.max, error, 1e-7);
        EXPECT_EQ(point.whole.pixels, 64u);
        // Columns 3 and 4 lie beside the border of truth, 4 and 5 beside the mesh's.
        EXPECT_EQ(point.silhouette.pixels, point.choice.shading == Shading::kExact ? 16u : 24u);
        EXPECT_EQ(point.interior.pixels + point.silhouette.pixels, 64u);
    }
}

TEST(Study, EndsWithWhatItHasWhereItIsTold) {
    int pieces = 0;
    const Study study = run(known_frame, true, known_renderers(),
                            {.extent = Extent::kQuick, .seconds = 60, .progress = [&](int, int, const std::string&) {
                                 return ++pieces <= 5;
                             }});
    EXPECT_EQ(study.points.size(), 5u);
    EXPECT_NO_THROW(study_svg(study));
    EXPECT_EQ(nlohmann::json::parse(study_json(study))["points"].size(), 5u);
}

// ---- The front ----

Point timed(Shading shading, int slices, double seconds, double rms) {
    Point point;
    point.choice = {.renderer = "programmable", .shading = shading, .slices = slices};
    point.seconds = {seconds, seconds, seconds};
    point.whole = {.pixels = 64, .max = rms, .rms = rms};
    return point;
}

TEST(Front, IsWhatNoOtherBeats) {
    std::vector<Point> points = {timed(Shading::kGouraud, 8, 0.001, 0.1), timed(Shading::kGouraud, 16, 0.003, 0.05),
                                 timed(Shading::kPhong, 8, 0.002, 0.04), timed(Shading::kPhong, 16, 0.004, 0.04),
                                 timed(Shading::kPhong, 32, 0.008, 0.001)};
    points.push_back(timed(Shading::kFlat, 8, 0.0001, 0.5));
    points.back().seconds.clear();  // not timed
    find_front(points);
    std::vector<bool> front;
    for (const Point& point : points) front.push_back(point.on_front);
    EXPECT_EQ(front, (std::vector<bool>{true, false, true, false, true, false}));
}

TEST(Findings, NameTheFastestAndTheCrossover) {
    const std::vector<std::string> sentences =
        findings({timed(Shading::kGouraud, 8, 0.001, 0.09), timed(Shading::kGouraud, 64, 0.006, 0.02),
                  timed(Shading::kPhong, 8, 0.002, 0.025), timed(Shading::kPhong, 32, 0.003, 0.0009)});
    const std::string all = [&] {
        std::ostringstream text;
        for (const std::string& sentence : sentences) text << sentence << "\n";
        return text.str();
    }();
    EXPECT_NE(all.find("For an rms error of 0.1 at most: gouraud, 8 slices, shaders with uniforms (1 ms, rms 0.09)."),
              std::string::npos)
        << all;
    EXPECT_NE(all.find("For an rms error of 0.03 at most: phong, 8 slices"), std::string::npos) << all;
    EXPECT_NE(all.find("For an rms error of 0.001 at most: phong, 32 slices"), std::string::npos) << all;
    EXPECT_NE(all.find("No choice of this study has an rms error of 0.0001 at most."), std::string::npos) << all;
    EXPECT_NE(all.find("From an rms error of 0.025 down, phong is cheaper than gouraud: phong, 8 slices"),
              std::string::npos)
        << all;
}

TEST(StudyFiles, HoldEveryPoint) {
    const Study study = known_study();
    const nlohmann::json json = nlohmann::json::parse(study_json(study));
    ASSERT_EQ(json["points"].size(), study.points.size());
    EXPECT_EQ(json["size"], nlohmann::json({kSide, kSide}));
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        EXPECT_EQ(json["points"][i]["key"], study.points[i].choice.key());
        EXPECT_NEAR(json["points"][i]["error"]["whole"]["rms"].get<double>(), study.points[i].whole.rms, 1e-12);
        EXPECT_EQ(json["points"][i]["on_front"], study.points[i].on_front);
    }
    const std::string csv = study_csv(study), svg = study_svg(study), page = study_page(study);
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), study.points.size() + 1);
    const auto count = [](const std::string& text, const std::string& part) {
        std::size_t found = 0;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count(svg, "class=\"dot\""), study.points.size() - 1);  // the truth has no logarithm
    EXPECT_EQ(count(page, "<tr data-point="), study.points.size());
    EXPECT_EQ(count(page, "{{"), 0u);
}

}  // namespace
}  // namespace twinlight::study
