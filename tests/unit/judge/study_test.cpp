// The study: changes of a scene, errors inside shapes and at outlines, the front, and the files.
#include "judge/study/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <span>
#include <sstream>

#include "base/text/json.h"
#include "judge/study/scene_of_choice.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::study::study_test {
namespace {

CommandList scene_of(const std::string& text) { return read_scene(text, "scene.gl", "scene"); }
Frame frame_of(const std::string& text) { return make_frame(scene_of(text), {.width = 16, .height = 16}); }

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

const std::string kLit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); ";
const std::string kRich =
    kLit +
    "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 2, 3, 1}); glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1); "
    "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 40); glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){1, 1, 1, 1}); "
    "glMaterialf(GL_FRONT, GL_SHININESS, 40); glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); glEnable(GL_NORMALIZE); "
    "glutSolidSphere(1, 8, 8);";

const LightingState& lighting_of(const Frame& frame) { return std::get<Draw>(frame.items[0]).lighting; }

TEST(Choices, ChangeWhatTheSceneHasAndNothingElse) {
    const auto has = [](const Frame& frame, LightingChange change) {
        return std::ranges::any_of(select_choices(frame, true, Extent::kQuick),
                                   [&](const Choice& choice) { return choice.lighting_change == change; });
    };
    const Frame plain = frame_of(kLit + "glutSolidSphere(1, 8, 8);"), rich = frame_of(kRich);
    for (const LightingChangeRow& change : lighting_changes()) {
        if (change.value == LightingChange::kWhole || change.value == LightingChange::kHalfVector) continue;
        EXPECT_FALSE(has(plain, change.value)) << change.words;
        EXPECT_TRUE(has(rich, change.value)) << change.words;
        // The changed scene no longer has the effect.
        EXPECT_FALSE(has(with_lighting_change(rich, change.value), change.value)) << change.words;
    }
    EXPECT_EQ(lighting_of(with_lighting_change(rich, LightingChange::kDirectional)).lights[0].position_eye,
              glm::dvec4(1, 2, 3, 0));  // seen from the middle of the sphere
}

TEST(Choices, TurnHighlightsByHalfVectorIntoSuchByReflectionAndBack) {
    const Frame rich = frame_of(kRich), reflecting = with_lighting_change(rich, LightingChange::kReflection);
    EXPECT_EQ(lighting_of(reflecting).light_model.specular, Word::reflection);
    EXPECT_EQ(lighting_of(reflecting).front.shininess, 10);
    EXPECT_TRUE(matters(reflecting, LightingChange::kHalfVector));
    EXPECT_EQ(lighting_of(with_lighting_change(reflecting, LightingChange::kHalfVector)).light_model.specular,
              Word::half_vector);
    EXPECT_EQ(lighting_of(with_lighting_change(reflecting, LightingChange::kHalfVector)).front.shininess, 40);
}

// With a distant light and viewer, n.h is cos(a) where r.v is cos(2a). Finds the exponent for which the two lobes are
// closest, over the sphere of normals, where directions at angle a have the weight sin(a).
TEST(Choices, MatchTheExponentsOfHighlights) {
    for (const double shininess : {16.0, 40.0, 128.0}) {
        const auto distance = [&](double part) {
            double sum = 0;
            constexpr int kSteps = 2000;
            for (int i = 0; i < kSteps; ++i) {
                const double a = (i + 0.5) / kSteps * std::acos(0.0);
                const double by_half = std::pow(std::cos(a), shininess);
                const double by_reflection = std::pow(std::max(std::cos(2 * a), 0.0), part * shininess);
                sum += std::pow(by_half - by_reflection, 2) * std::sin(a);
            }
            return sum;
        };
        double best = 0.15;
        for (double part = 0.15; part < 0.35; part += 0.001)
            if (distance(part) < distance(best)) best = part;
        // The next term of the series makes lobes of the reflection vector narrower; narrow lobes are affected less.
        EXPECT_LT(best, kReflectionExponent) << shininess;
        EXPECT_GT(best, kReflectionExponent * (1 - 2 / shininess)) << shininess;
    }
}

TEST(Choices, RescaleOnlyWhereThatNormalizes) {
    const std::string sphere = "glutSolidSphere(1, 8, 8);";
    const auto rescales = [&](const std::string& before, const std::string& shape) {
        return matters(frame_of(kLit + "glEnable(GL_NORMALIZE); " + before + shape), LightingChange::kRescale);
    };
    EXPECT_TRUE(rescales("", sphere));
    EXPECT_TRUE(rescales("glRotatef(30, 1, 2, 3); glScalef(2, 2, 2); ", sphere));
    EXPECT_FALSE(rescales("glScalef(2, 2, 1); ", sphere));
    EXPECT_FALSE(rescales("glScalef(2, 2, 1); glutSolidCube(1); glLoadIdentity(); ", sphere));
    EXPECT_FALSE(rescales("", "glBegin(GL_POINTS); glNormal3f(0, 0, 2); glVertex3f(0, 0, 0); glEnd();"));
    EXPECT_FALSE(matters(frame_of(kLit + sphere), LightingChange::kRescale));
}

TEST(Choices, AreThereForWhatTheStudyAsks) {
    const auto count = [](const Frame& frame, Extent extent, int coverage, const auto& is) {
        return std::ranges::count_if(select_choices(frame, true, extent, coverage), is);
    };
    const Frame lit = frame_of(kRich), unlit = frame_of("glutSolidSphere(1, 8, 8);");
    const auto is_precise = [](const Choice& choice) { return choice.method == Method::kPrecise; };
    const auto has_samples = [](const Choice& choice) { return choice.samples > 1; };
    EXPECT_GT(count(lit, Extent::kQuick, 1, is_precise), 0);
    EXPECT_EQ(count(unlit, Extent::kQuick, 1, is_precise), 0);
    EXPECT_EQ(count(lit, Extent::kFull, 1, has_samples), 0);
    EXPECT_GT(count(lit, Extent::kQuick, 8, has_samples), 0);
    for (const Extent extent : {Extent::kQuick, Extent::kFull})
        for (const fixed::Sending sending :
             {fixed::Sending::kClientArrays, fixed::Sending::kImmediate, fixed::Sending::kDisplayList})
            EXPECT_GT(count(lit, extent, 1, [&](const Choice& choice) { return choice.sending == sending; }), 0);
}

// Every axis reads back its own keys, and refuses others.
TEST(Choices, AreWhatTheirAxesTell) {
    for (const Choice& choice : select_choices(frame_of(kRich), true, Extent::kFull, 8)) {
        Choice read;
        for (const Axis& axis : axes()) ASSERT_TRUE(axis.set(read, axis.value(choice).key)) << axis.name;
        EXPECT_EQ(read, choice) << choice.words();
    }
    Choice untouched;
    for (const Axis& axis : axes())
        for (const char* foreign : {"nonsense", "-1", "1e9", "nan", "2x"}) {
            EXPECT_FALSE(axis.set(untouched, foreign)) << axis.name << " takes " << foreign;
            EXPECT_EQ(untouched, Choice{});
        }
    EXPECT_FALSE(axes().at(2).set(untouched, "2.5"));  // slices
}

TEST(Choices, HaveKeysOfTheirOwn) {
    std::set<std::string> keys;
    const std::vector<Choice> all = select_choices(frame_of(kRich), true, Extent::kFull, 8);
    for (const Choice& choice : all) keys.insert(choice.key());
    EXPECT_EQ(keys.size(), all.size());
}

// ---- A study with known pictures ----

constexpr int kSide = 8;

// The brightness depends only on the shading. The right half is another shape; in meshes it begins one pixel later.
double brightness(Shading shading) {
    switch (shading) {
        case Shading::kFlat: return 0.9;
        case Shading::kGouraud: return 0.7;
        case Shading::kPhong: return 0.6;
        case Shading::kExact: return 0.5;
    }
    return 0;
}

ChoiceRenderers known_renderers() {
    ChoiceRenderers renderers;
    renderers.prepare = [](const Frame& /*frame*/, const Choice& choice) {
        return Prepared{[] {},
                        [shading = choice.shading] {
                            Image image(kSide, kSide);
                            const auto value = static_cast<float>(brightness(shading));
                            for (Rgba& pixel : image.pixels) pixel = {value, value, value, 1};
                            return image;
                        }};
    };
    renderers.seen = [](const Frame& /*frame*/, const reference::Options& options) {
        std::vector<int> seen(kSide * kSide);
        const int border = options.shading == Shading::kExact ? kSide / 2 : kSide / 2 + 1;
        for (int i = 0; i < kSide * kSide; ++i) seen[static_cast<std::size_t>(i)] = i % kSide < border ? 0 : 1;
        return seen;
    };
    return renderers;
}

Frame known_frame(int /*slices*/) {
    Frame known = frame_of(kLit + "glutSolidSphere(1, 8, 8);");
    known.width = known.height = kSide;
    return known;
}

Settings quick(double seconds = 0) {
    Settings settings;
    settings.extent = Extent::kQuick;
    settings.seconds = seconds;
    return settings;
}

Study known_study(const Settings& settings = quick()) {
    Study study = run(known_frame, true, known_renderers(), settings);
    study.scene = "scene.gl";
    study.fingerprint = "0123";
    study.series[0].name = study.series[0].driver = "llvmpipe (LLVM 15), 4.5";
    study.series[0].machine = {.processor = "a processor", .cores = 2, .system = "a system"};
    SpectralStudy& samples = study.series[0].spectral.emplace();
    for (const char* light : {"A", "D65"})
        for (const int count : {0, 9, 81})
            samples.patches.push_back({.light = light, .samples = count, .mean = 1.0 / (1 + count), .worst = "cyan"});
    for (const int count : {0, 9, 81})
        samples.pictures.push_back({.samples = count,
                                    .reference_seconds = {0.5},
                                    .sampling_shader_seconds = {0.125},
                                    .shader_seconds = {0.25},
                                    .off = {.mean = 1.0 / (1 + count)}});
    samples.findings = spectral_findings(samples);
    return study;
}

TEST(Study, TellsTheErrorsOfSilhouettesApart) {
    const Study study = known_study();
    EXPECT_EQ(study.series[0].rounds, 3);
    for (const Point& point : study.points) {
        EXPECT_EQ(point.seconds.size(), 3u);
        const double error = brightness(point.choice.shading) - 0.5;
        EXPECT_NEAR(point.errors.whole.rms, error, 1e-7);
        EXPECT_NEAR(point.errors.interior.max, error, 1e-7);
        EXPECT_EQ(point.errors.whole.pixels, 64u);
        // Columns 3 and 4 are at the border in the exact picture, 4 and 5 at that of the mesh.
        EXPECT_EQ(point.errors.silhouette.pixels, point.choice.shading == Shading::kExact ? 16u : 24u);
        EXPECT_EQ(point.errors.interior.pixels + point.errors.silhouette.pixels, 64u);
    }
}

TEST(Study, LeavesOutWhatIsRefused) {
    ChoiceRenderers renderers = known_renderers();
    const auto prepare = renderers.prepare;
    renderers.prepare = [&](const Frame& frame, const Choice& choice) {
        if (choice.method == Method::kPrecise) throw Refused("no such programs");
        return prepare(frame, choice);
    };
    const Study study = run(known_frame, true, renderers, quick()), whole = known_study();
    EXPECT_LT(study.points.size(), whole.points.size());
    for (const Point& point : study.points) EXPECT_NE(point.choice.method, Method::kPrecise);
}

TEST(Study, GoesOnWhereAChoiceFails) {
    ChoiceRenderers renderers = known_renderers();
    const auto prepare = renderers.prepare;
    renderers.prepare = [&](const Frame& frame, const Choice& choice) {
        if (choice.shading == Shading::kPhong) throw std::runtime_error("the driver refuses a vertex shader: why");
        return prepare(frame, choice);
    };
    int failed = 0;
    Settings settings = quick();
    settings.failed = [&](const Choice& choice, const std::string& reason) {
        EXPECT_EQ(choice.shading, Shading::kPhong);
        EXPECT_EQ(reason, "the driver refuses a vertex shader: why");
        ++failed;
    };
    const Study study = run(known_frame, true, renderers, settings), whole = known_study();
    EXPECT_GT(failed, 0);
    EXPECT_EQ(study.points.size() + static_cast<std::size_t>(failed), whole.points.size());
}

// Ends the study after some steps.
Settings ending_after(int pieces) {
    Settings settings = quick(60);
    settings.progress = [left = pieces](const Progress& progress) mutable {
        EXPECT_GE(progress.seconds_left, 0);
        EXPECT_LE(progress.done, progress.total);
        return --left >= 0;
    };
    return settings;
}

TEST(Study, EndsWithWhatItHasAndGoesOnFromThere) {
    const Study begun = known_study(ending_after(5));
    EXPECT_EQ(begun.points.size(), 5u);
    EXPECT_NO_THROW(study_svg(begun));
    EXPECT_EQ(nlohmann::json::parse(study_json(begun))["points"].size(), 5u);

    const Study nothing = known_study(ending_after(0));
    EXPECT_TRUE(nothing.points.empty());
    EXPECT_NO_THROW(study_page(nothing));
    EXPECT_TRUE(read_study(study_json(nothing), "study.json").points.empty());

    // Ended while timing: all choices are there, some of them timed once more.
    const std::size_t all = known_study().points.size();
    const Study timed = known_study(ending_after(static_cast<int>(2 * all + 7)));
    ASSERT_EQ(timed.points.size(), all);
    EXPECT_EQ(timed.series[0].rounds, 1);
    EXPECT_EQ(timed.points[6].seconds.size(), 2u);
    EXPECT_EQ(timed.points[7].seconds.size(), 1u);

    Settings resumed = quick();
    resumed.earlier = &timed;
    const Study ended = known_study(resumed);
    EXPECT_EQ(ended.series[0].rounds, 3);
    EXPECT_EQ(ended.points[6].seconds.size(), 4u);
    for (std::size_t i = 0; i < all; ++i) {
        EXPECT_GE(ended.points[i].seconds.size(), 3u);
        EXPECT_TRUE(std::ranges::equal(timed.points[i].seconds,
                                       std::span(ended.points[i].seconds).first(timed.points[i].seconds.size())));
    }
    // Ended again at once: nothing is lost.
    Settings interrupted = ending_after(3);
    interrupted.earlier = &ended;
    const Study kept = known_study(interrupted);
    EXPECT_EQ(kept.points.size(), all);
    for (const Point& point : kept.points) EXPECT_GE(point.seconds.size(), 3u) << point.choice.words();
}

// ---- The front ----

Point timed(Shading shading, int slices, double seconds, double rms, double max = 1) {
    Point point;
    point.choice = {.method = Method::kUniforms, .shading = shading, .slices = slices};
    point.seconds = {seconds, seconds, seconds};
    point.errors.whole = {.pixels = 64, .max = max, .rms = rms};
    return point;
}

Study study_of(std::vector<Point> points) {
    Study study;
    study.width = study.height = kSide;
    study.series.resize(1);
    study.points = std::move(points);
    return study;
}

TEST(Front, IsWhatNoOtherBeats) {
    Study study =
        study_of({timed(Shading::kGouraud, 8, 0.001, 0.1, 0.2), timed(Shading::kGouraud, 16, 0.003, 0.05, 0.3),
                  timed(Shading::kPhong, 8, 0.002, 0.04, 0.3), timed(Shading::kPhong, 16, 0.004, 0.04, 0.1),
                  timed(Shading::kPhong, 32, 0.008, 0.001, 0.1)});
    study.points.push_back(timed(Shading::kFlat, 8, 0.0001, 0.5));
    study.points.back().seconds.clear();  // not timed
    find_fronts(study);
    std::vector<bool> by_rms, by_max;
    for (const Point& point : study.points) {
        by_rms.push_back(point.on_front[0]);
        by_max.push_back(point.on_front[1]);
    }
    EXPECT_EQ(by_rms, (std::vector<bool>{true, false, true, false, true, false}));
    EXPECT_EQ(by_max, (std::vector<bool>{true, false, false, true, false, false}));
}

// For any times and errors: along a front the time rises and the error falls.
TEST(Front, IsMonotone) {
    std::mt19937 random;
    const auto next = [&] { return std::uniform_real_distribution(0.001, 1.0)(random); };
    Study study = study_of({});
    for (int i = 0; i < 300; ++i) {
        const double seconds = std::round(next() * 50) / 1000 + 0.001;  // some are equal
        study.points.push_back(timed(Shading::kPhong, i + 1, seconds, std::ceil(next() * 50) / 50, next()));
        study.points.back().errors.whole.delta_e = next();
        study.points.back().errors.whole.delta_e_95 = next();
    }
    find_fronts(study);
    for (std::size_t m = 0; m < kMeasureCount; ++m) {
        std::vector<const Point*> front;
        for (const Point& point : study.points)
            if (point.on_front[m]) front.push_back(&point);
        ASSERT_GT(front.size(), 1u);
        std::ranges::sort(front, {}, [](const Point* point) { return point->median_seconds(); });
        const auto error = [&](const Point* point) { return point->errors.whole.*kMeasures[m].value; };
        for (std::size_t i = 1; i < front.size(); ++i) {
            EXPECT_LT(front[i - 1]->median_seconds(), front[i]->median_seconds());
            EXPECT_GT(error(front[i - 1]), error(front[i]));
        }
        for (const Point& point : study.points)
            EXPECT_TRUE(std::ranges::any_of(front, [&](const Point* best) {
                return best->median_seconds() <= point.median_seconds() && kSameError * error(best) <= error(&point);
            }));
    }
}

TEST(Findings, NameTheFastestAndTheCrossover) {
    Study study = study_of({timed(Shading::kGouraud, 8, 0.001, 0.09), timed(Shading::kGouraud, 64, 0.006, 0.02),
                            timed(Shading::kPhong, 8, 0.002, 0.025), timed(Shading::kPhong, 32, 0.003, 0.0009, 0.003)});
    write_findings(study);
    const std::string all = [&] {
        std::ostringstream text;
        for (const std::string& sentence : study.series[0].findings) text << sentence << "\n";
        return text.str();
    }();
    for (const char* expected :
         {"For an rms error of at most 0.1: shaders with uniforms, gouraud, 8 slices (1 ms, rms 0.09).",
          "For an rms error of at most 0.03: shaders with uniforms, phong, 8 slices",
          "For an rms error of at most 0.001: shaders with uniforms, phong, 32 slices",
          "No choice of this study reaches an rms error of at most 0.0001.",
          "For a largest error of at most 1/255: shaders with uniforms, phong, 32 slices (3 ms, max 0.003).",
          "For an rms error of 0.025 or less, phong is faster than gouraud: shaders with uniforms, phong, 8 slices"})
        EXPECT_NE(all.find(expected), std::string::npos) << expected << "\n" << all;
    // A choice that meets several targets is named only for the strictest.
    EXPECT_EQ(all.find("For an rms error of at most 0.01"), std::string::npos) << all;
}

// ---- Files ----

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(StudyFiles, HoldEveryPoint) {
    const Study study = known_study();
    const nlohmann::json json = nlohmann::json::parse(study_json(study));
    ASSERT_EQ(json["points"].size(), study.points.size());
    EXPECT_EQ(json["size"], nlohmann::json({kSide, kSide}));
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        EXPECT_EQ(json["points"][i]["key"], study.points[i].choice.key());
        EXPECT_EQ(json["points"][i]["error"]["whole"]["rms"], study.points[i].errors.whole.rms);
        EXPECT_EQ(json["points"][i]["front"].empty(), study.points[i].on_front == decltype(Point::on_front){});
    }
    const std::string csv = study_csv(study), svg = study_svg(study), page = study_page(study);
    EXPECT_EQ(count(csv, "\n"), study.points.size() + 1);
    std::istringstream lines(csv);
    std::string first, line;
    for (std::getline(lines, first); std::getline(lines, line);) EXPECT_EQ(count(line, ","), count(first, ",")) << line;
    const auto has_error = [](const Point& point) { return point.errors.whole.rms > 0; };  // 0 has no logarithm
    EXPECT_EQ(count(svg, "class=\"dot\""), static_cast<std::size_t>(std::ranges::count_if(study.points, has_error)));
    EXPECT_LT(count(svg, "class=\"dot\""), study.points.size());
    EXPECT_EQ(count(page, "<tr data-point="), study.points.size());
    EXPECT_EQ(count(page, "{{"), 0u);
}

TEST(StudyFiles, OpenTheirPageOnThreeFindingsAndTheChartWithTheTableFolded) {
    const Study study = known_study();
    const std::vector<std::string> sentences = headlines(study, 0);
    ASSERT_EQ(sentences.size(), 3u);
    EXPECT_TRUE(sentences[0].starts_with("The fastest choice within 1/255 of the exact picture at every pixel: "));
    const std::string page = study_page(study);
    const std::size_t first = page.find("<li>" + sentences[0]), chart = page.find("<canvas id=\"chart\""),
                      folded = page.find("<details id=\"all-choices\">"), table = page.find("<table id=\"points\"");
    EXPECT_NE(table, std::string::npos);
    EXPECT_LT(first, chart);
    EXPECT_LT(chart, folded);
    EXPECT_LT(folded, table);
    EXPECT_EQ(page.substr(folded, table - folded).find("</details>"), std::string::npos);
    EXPECT_TRUE(headlines(known_study(ending_after(0)), 0).empty());
}

// Each has a mark for every point that it shows; a study without the choices has no plot.
TEST(StudyFiles, PlotOneFindingEach) {
    const Study study = known_study();
    Settings two = quick();
    for (const LightingChange change : {LightingChange::kWhole, LightingChange::kNoSpecular})
        two.choices.push_back({.shading = Shading::kPhong, .slices = 32, .lighting_change = change});
    const Study changed = run(known_frame, true, known_renderers(), two);
    const std::string shading = shading_svg(study), outlines = outlines_svg(study), changes = changes_svg(changed);
    EXPECT_EQ(
        headlines(changed, 0).back(),
        "Simpler lighting costs most accuracy: shaders with uniforms, phong, 32 slices, no highlights has an rms error "
        "of 0.1, with all of the lighting 0.1.");
    EXPECT_EQ(count(shading, "class=\"dot\""), 3u * 4);  // the exact surfaces have no error here
    EXPECT_EQ(count(outlines, "class=\"dot\""), 3u * 4);
    EXPECT_EQ(count(changes, "<rect "), 3u);  // the ground and two bars
    for (const char* words : {">all of the lighting<", ">no highlights<"})
        EXPECT_NE(changes.find(words), std::string::npos) << words;
    for (const std::string& svg : {shading, outlines, changes}) EXPECT_EQ(svg.find("nan"), std::string::npos);
    const Study nothing = known_study(ending_after(0));
    EXPECT_EQ(shading_svg(nothing) + outlines_svg(nothing) + changes_svg(nothing), "");
}

TEST(StudyFiles, AreReadBack) {
    const Study study = known_study(), read = read_study(study_json(study), "study.json");
    EXPECT_EQ(study_json(Study(study)), [&] {
        Study with_pictures = read;
        for (std::size_t i = 0; i < study.points.size(); ++i)
            with_pictures.points[i].picture_png = study.points[i].picture_png;
        return study_json(with_pictures);
    }());
    EXPECT_EQ(read.series, study.series);
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        EXPECT_EQ(read.points[i].choice, study.points[i].choice);
        EXPECT_EQ(read.points[i].seconds, study.points[i].seconds);
        EXPECT_EQ(read.points[i].errors, study.points[i].errors);
        EXPECT_EQ(read.points[i].on_front, study.points[i].on_front);
    }
}

TEST(StudyFiles, OfOthersAreRefusedWithTheirPlace) {
    const nlohmann::json right = nlohmann::json::parse(study_json(known_study()));
    const auto refusal = [](const std::string& text) {
        try {
            read_study(text, "A.json");
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string("read");
    };
    EXPECT_EQ(refusal(right.dump()), "read");
    const auto with = [&](const char* pointer, const nlohmann::json& value) {
        nlohmann::json wrong = right;
        wrong[nlohmann::json::json_pointer(pointer)] = value;
        return refusal(wrong.dump());
    };
    EXPECT_EQ(refusal("no"), "A.json: this is not JSON");
    EXPECT_EQ(refusal("[]"), "A.json: this is not a study; `twinlight study` writes studies as study.json");
    EXPECT_EQ(refusal(R"({"format": 3})"), refusal("{}"));
    EXPECT_EQ(with("/version", 99), "A.json: version: this program reads version 2; run the study again");
    EXPECT_EQ(with("/size", nlohmann::json({1})), "A.json: size: it must be [width, height]");
    EXPECT_EQ(with("/size/0", -1).substr(0, 22), "A.json: size[0]: -1 is");
    EXPECT_EQ(with("/series", nlohmann::json::array()), "A.json: series: it is empty");
    EXPECT_EQ(with("/points/3/series", 1), "A.json: points[3].series: 1 is not in [0, 0]");
    EXPECT_EQ(with("/points/3/axes/shading", "matte"),
              "A.json: points[3].axes.shading: 'matte' is not one of flat, gouraud, phong, exact");
    EXPECT_EQ(with("/points/3/axes/slices", 2.5), "A.json: points[3].axes.slices: '2.5' is not a legal number here");
    EXPECT_EQ(with("/points/3/error/interior", nullptr), "A.json: points[3].error.interior: it must be an object");
    EXPECT_EQ(with("/points/3/seconds/samples/1", "soon"), "A.json: points[3].seconds.samples[1]: it must be a number");
    EXPECT_EQ(with("/points/3/seconds/samples/1", -1), "A.json: points[3].seconds.samples[1]: -1 is not in [0, 1e+06]");
    EXPECT_EQ(with("/points/3", right["points"][2]), "A.json: points[3]: this choice is listed twice");
    EXPECT_EQ(with("/series/0/spectral/patches/1/mean", "little"),
              "A.json: series[0].spectral.patches[1].mean: it must be a number");
    EXPECT_EQ(
        with("/series/0/spectral/patches/1/samples", 0),
        "A.json: series[0].spectral.patches: it must be sorted by light, with the same numbers of samples for each, "
        "from few to many");
    EXPECT_EQ(with("/series/0/spectral/patches/3/light", "B").substr(0, 49),
              with("/series/0/spectral/patches/1/samples", 0).substr(0, 49));
    EXPECT_EQ(with("/series/0/spectral/patches/0/worst", "a\nb"),
              "A.json: series[0].spectral.patches[0].worst: it contains a control character");
    EXPECT_EQ(with("/series/0/spectral/pictures/1/samples", 81),
              "A.json: series[0].spectral.pictures: it must go from few samples to many");
    EXPECT_EQ(with("/series/0/spectral/pictures/1/reference_seconds", 0),
              "A.json: series[0].spectral.pictures[1].reference_seconds: 0 is not in [1e-09, 1e+06]");
    EXPECT_EQ(with("/series/0/spectral/pictures", nullptr), "A.json: series[0].spectral.pictures: it must be a list");
}

TEST(StudyFiles, OfSeveralMachinesAreLaidOverEachOther) {
    const Study study = known_study();
    Study other = study;
    other.series[0].driver = "a GPU, 4.6";
    for (Point& point : other.points)
        for (double& seconds : point.seconds) seconds = seconds / 10 + 1e-9;
    const Study both = merged({{"A.json", study}, {"B.json", other}});
    ASSERT_EQ(both.series.size(), 2u);
    EXPECT_EQ(both.series[0].name, "llvmpipe (LLVM 15)");
    EXPECT_EQ(both.series[1].name, "a GPU");
    ASSERT_EQ(both.points.size(), 2 * study.points.size());
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        EXPECT_EQ(both.points[i].on_front, study.points[i].on_front);  // each machine has its own front
        EXPECT_EQ(both.points[study.points.size() + i].series, 1u);
    }
    EXPECT_EQ(both.series[0].findings, study.series[0].findings);
    EXPECT_NE(both.series[1].findings, study.series[0].findings);
    EXPECT_EQ(study_json(read_study(study_json(both), "C.json")).size() > 0, true);
    EXPECT_NE(study_page(both).find("a GPU"), std::string::npos);
    EXPECT_EQ(both.series[1].spectral, study.series[0].spectral);
    EXPECT_NE(study_page(both).find("Samples of the spectrum: a GPU"), std::string::npos);
    EXPECT_EQ(spectral_file(both, 1), "2-spectral.svg");
    EXPECT_NE(study_svg(both).find("a GPU"), std::string::npos);
    // Merged again, with a study of the same machine.
    EXPECT_EQ(merged({{"C.json", both}, {"A.json", study}}).series[2].name, "llvmpipe (LLVM 15), a processor (3)");

    other.width = 9;
    try {
        merged({{"A.json", study}, {"B.json", other}});
        ADD_FAILURE() << "studies of two sizes are merged";
    } catch (const MergeError& error) {
        EXPECT_STREQ(error.what(),
                     "B.json is of 9 x 8 pixels, not 8 x 8 like A.json; only studies of the same scene, size and "
                     "coverage can be "
                     "merged");
    }
    other.width = kSide;
    other.fingerprint = "4567";
    EXPECT_THROW(merged({{"A.json", study}, {"B.json", other}}), MergeError);
}

}  // namespace
}  // namespace twinlight::study::study_test
