// Comparisons of stub renderers: which pictures are asked for, what is judged, what is written.
#include "judge/compare/comparison.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>

#include "../pictures.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"
#include "judge/compare/missing.h"
#include "judge/report/report.h"
#include "judge/report/words.h"
#include "render/reference/reference.h"
#include "scene/command/command.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::report::comparison_test {
namespace {

using namespace compare;

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kWidth = 40, kHeight = 30;

// Its only command enables fog.
Scene empty_scene() {
    return {std::make_shared<const CommandList>(
                "stub", std::vector<Command>{{CommandId::glEnable, {static_cast<double>(kGL_FOG)}, {}}}),
            {.width = kWidth, .height = kHeight}};
}

// Pictures of one grey; the left column is an edge of the background.
struct Stub {
    float fixed = 128.0F / 255, programmable = 128.0F / 255, reference = 128.0F / 255;
    float allowed = 0;
    std::vector<Unsupported> unsupported;
    // The fixed function's grey without glEnable(GL_FOG), the scene's only command.
    float without_fog = 128.0F / 255;
    std::map<std::string, int> calls;  // "fixed gouraud GL", ...

    void count(const std::string& name, const Look& look) {
        ++calls[name +
                (look.shading == Shading::kPhong ? " phong"
                 : look.shading                  ? " other"
                                                 : " scene") +
                (look.lecture_variants ? " variants" : " GL")];
    }
    static bool has_commands(const Scene& scene) {
        bool any = false;
        scene.recording->for_each([&](const Step&) { return any = true; });
        return any;
    }
    static Image picture(const Frame& frame, float grey) { return {frame.width, frame.height, {grey, grey, grey, 1}}; }

    Renderers renderers() {
        return {.fixed =
                    [this](const Scene& scene, const fixed::Options& options) {
                        count("fixed", {options.shading, false});
                        return picture(scene.frame, has_commands(scene) ? fixed : without_fog);
                    },
                .programmable =
                    [this](const Frame& frame, const programmable::Options& options) {
                        count("shaders", options);
                        return picture(frame, programmable);
                    },
                .reference =
                    [this](const Frame& frame, const reference::Options& options) {
                        count("reference", options);
                        return picture(frame, reference);
                    },
                .allowed_difference =
                    [this](const Frame& frame, const reference::Options&) {
                        AllowedDifference result(frame.width, frame.height);
                        result.part(Why::kTextures) =
                            Image(frame.width, frame.height, {allowed, allowed, allowed, allowed});
                        result.drawn.assign(result.edge.size(), true);
                        for (int y = 0; y < frame.height; ++y) {
                            result.edge[result.index(0, y)] = true;
                            result.drawn[result.index(0, y)] = false;
                        }
                        return result;
                    }};
    }
    Comparison compare() {
        Scene scene = empty_scene();
        scene.frame.unsupported = unsupported;
        return compare_scene(scene, {.driver = "a driver"}, renderers());
    }
};

Unsupported fog(int count) {
    Unsupported item;
    item.name = "glEnable(GL_FOG)";
    item.count = count;
    item.first = {std::make_shared<std::string>("scene.gl"), 3, 1};
    return item;
}

const Pair& pair_named(const Comparison& comparison, const std::string& name) {
    for (const Pair& pair : comparison.pairs) {
        if (name_of(comparison, pair) == name) return pair;
    }
    throw std::logic_error("no pair " + name);
}

std::string page_of(const Comparison& comparison) {
    return comparison_page({{"", comparison, encode_pictures(comparison)}});
}

class ReportTest : public testing::Test {
  protected:
    ReportTest() {
        std::string pattern = (fs::temp_directory_path() / "twinlight-report-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~ReportTest() override { fs::remove_all(folder_); }
    fs::path folder_;
};

// ---- What is drawn ----

TEST(Comparison, DrawsPerVertexByGlsModelAndPhongByTheScenes) {
    Stub stub;
    stub.compare();
    const std::map<std::string, int> expected = {
        {"fixed scene GL", 2},  // one to warm the driver up, one that counts
        {"shaders scene GL", 2},       {"reference scene GL", 1},
        {"shaders phong variants", 2}, {"reference phong variants", 1},
    };
    EXPECT_EQ(stub.calls, expected);
}

TEST(Comparison, TellsItsProgressStepByStep) {
    Stub stub;
    int steps = 0;
    const auto count = [&](int done, int total, std::string_view) {
        EXPECT_EQ(done, steps++);
        EXPECT_EQ(total, 7);
    };
    compare_scene(empty_scene(), {.progress = count}, stub.renderers());
    EXPECT_EQ(steps, 7);
}

TEST(Comparison, CountsInteriorAndEdgesApart) {
    Stub stub;
    const Comparison comparison = stub.compare();
    for (const Pair& pair : comparison.pairs) {
        EXPECT_EQ(pair.difference.edge.pixels, 30U);
        EXPECT_EQ(pair.difference.interior.pixels, 39U * 30U);
    }
}

// ---- What is judged ----

TEST(Verdict, IsWithinUpToOneCodeInFewPixels) {
    ImageDifference difference;
    difference.beyond_allowed = {.pixels = 10'000, .differing = 9, .max = 1 / 255.0, .rms = 0};
    EXPECT_EQ(judge(difference, {}), Verdict::kWithin);
    difference.beyond_allowed.differing = 10;  // 0.1 %: not fewer
    EXPECT_EQ(judge(difference, {}), Verdict::kBeyond);
    difference.beyond_allowed.differing = 1;
    difference.beyond_allowed.max = 2 / 255.0;
    EXPECT_EQ(judge(difference, {}), Verdict::kBeyond);
}

// 5 codes off: one code more than what is allowed and rounding, in every pixel; then none.
TEST(Verdict, IsOfWhatIsLeftBeyondTheAllowedDifference) {
    Stub stub;
    stub.fixed = 133.0F / 255;
    stub.allowed = 1.6F / 255;  // twice, for either of two drivers
    const Comparison beyond = stub.compare();
    const ImageDifference& difference = pair_named(beyond, "fixed ~ shaders").difference;
    EXPECT_EQ(difference.interior.max, 5 / 255.0);
    EXPECT_EQ(difference.beyond_allowed.max, 1 / 255.0);
    EXPECT_EQ(difference.beyond_allowed.differing, difference.interior.pixels);
    EXPECT_EQ(pair_named(beyond, "fixed ~ shaders").verdict, Verdict::kBeyond);
    stub.allowed = 2.01F / 255;
    EXPECT_EQ(pair_named(stub.compare(), "fixed ~ shaders").verdict, Verdict::kWithin);
    EXPECT_EQ(pair_named(stub.compare(), "fixed ~ reference").verdict, Verdict::kBeyond);
    stub.allowed = 4.01F / 255;
    EXPECT_EQ(stub.compare().verdict(), Verdict::kWithin);
}

// 76.5 codes: one driver rounds down, another up.
TEST(Verdict, TakesEitherCodeOfAColorOnTheirBorder) {
    Stub stub;
    stub.reference = 0.3F;
    stub.fixed = 76.0F / 255;
    stub.programmable = 77.0F / 255;
    EXPECT_EQ(stub.compare().verdict(), Verdict::kWithin);
    stub.reference = 0.3005F;  // 76.63
    EXPECT_EQ(pair_named(stub.compare(), "fixed ~ reference").verdict, Verdict::kBeyond);
}

TEST(Verdict, LeavesEdgesAlone) {
    ImageDifference difference;
    difference.edge = {.pixels = 10, .differing = 10, .max = 1, .rms = 1};
    EXPECT_EQ(judge(difference, {}), Verdict::kWithin);
}

TEST(Verdict, OfEqualPicturesIsWithin) {
    Stub stub;
    const Comparison comparison = stub.compare();
    EXPECT_TRUE(comparison.within_tolerance());
    const std::vector<std::string> agreed = {"All three agree: no pixel away from edges differs."};
    EXPECT_EQ(answer(comparison).sentences(), agreed);
}

// Over 2% of the drawn pixels may have any colour, or one in a wide range: nothing is wrong, and nothing is certain.
TEST(Verdict, SaysHowManyPixelsCouldNotBeJudged) {
    Stub stub;
    const auto compared = [&](std::size_t open, const std::vector<AllowedRange>& ranges) {
        Renderers renderers = stub.renderers();
        renderers.allowed_difference = [&, of_stub = renderers.allowed_difference](const Frame& frame,
                                                                                   const reference::Options& options) {
            AllowedDifference allowed = of_stub(frame, options);
            for (std::size_t i = 0; i < allowed.edge.size(); ++i) {
                allowed.edge[i] = i < open;
                allowed.drawn[i] = i < 1000;
                if (i < open && !ranges.empty()) allowed.ranges[i] = ranges;
            }
            return allowed;
        };
        return compare_scene(empty_scene(), {.driver = "a driver"}, renderers);
    };
    const AllowedRange grey{{0.5F, 0.5F, 0.5F, 1}, {0.51F, 0.51F, 0.51F, 1}}, wide{{0, 0, 0, 1}, {0.6F, 0.6F, 0.6F, 1}};
    EXPECT_EQ(compared(20, {}).verdict(), Verdict::kWithin);
    EXPECT_EQ(compared(900, {grey}).verdict(), Verdict::kWithin);
    const Comparison open = compared(21, {});
    EXPECT_EQ(open.verdict(), Verdict::kUnjudged);
    EXPECT_TRUE(open.within_tolerance());
    EXPECT_EQ(answer(open).headline, "No difference found; 2.1% of the drawn pixels could not be checked.");
    EXPECT_EQ(json::parse(comparison_json(open))["verdict"], "unchecked");
    EXPECT_EQ(compared(21, {grey, wide}).verdict(), Verdict::kUnjudged);

    const Judged& judged = compared(900, {grey}).pairs.front().judged;
    EXPECT_EQ(judged.to_one_of, 900U);
    EXPECT_EQ(judged.to_allowed, 300U);
    EXPECT_EQ(judged.not_judged, 0U);
    EXPECT_EQ(judged.colors.median, 2) << "the range and the reference's own colour";
    EXPECT_NEAR(judged.width.most, 0.01, 1e-6);
    stub.fixed = 0.6F;
    EXPECT_EQ(compared(900, {}).verdict(), Verdict::kBeyond) << "300 pixels are judged";
}

TEST(Verdict, NamesThePairsThatDiffer) {
    Stub stub;
    stub.fixed = 0.6F;  // 153 against 128
    const Comparison comparison = stub.compare();
    EXPECT_FALSE(comparison.within_tolerance());
    EXPECT_EQ(pair_named(comparison, "fixed ~ shaders").verdict, Verdict::kBeyond);
    EXPECT_EQ(pair_named(comparison, "fixed ~ reference").verdict, Verdict::kBeyond);
    EXPECT_EQ(pair_named(comparison, "shaders ~ reference").verdict, Verdict::kWithin);
    EXPECT_EQ(pair_named(comparison, "shaders-phong ~ reference-phong").verdict, Verdict::kWithin);
    EXPECT_EQ(pair_named(comparison, "fixed ~ shaders-phong").verdict, Verdict::kInformative);
    const Answer answers = answer(comparison);
    EXPECT_EQ(answers.headline, "Not all agree: fixed and shaders differ by up to 25/255.");
    EXPECT_EQ(answers.where,
              "fixed ~ shaders: 1,170 of 1,170 checked pixels differ (100.00%); the worst is at "
              "(1, 0). Allowed: up to 1/255, in fewer than 0.1% of the pixels.");
    ASSERT_EQ(answers.details.size(), 2U);
    EXPECT_EQ(answers.details[0],
              "fixed ~ reference: 1,170 of 1,170 checked pixels differ (100.00%), by up to 25/255; the worst is at "
              "(1, 0).");
    EXPECT_EQ(answers.sentences().size(), 4U);
}

TEST(Verdict, SaysWhenOnlyAlphaDiffers) {
    Comparison comparison = Stub().compare();
    Pair& pair = comparison.pairs[1];
    pair.verdict = Verdict::kBeyond;
    const auto where = [&](const Rgba& other) {
        const Image one(40, 30, {0.2F, 0.4F, 0.6F, 0.8F});
        Image differing = one;
        differing.at(3, 4) = other;
        pair.difference = difference(one, differing, PixelMask(one.pixels.size()));
        return answer(comparison).where;
    };
    const std::string words = "Only alpha differs, which no window shows.";
    EXPECT_TRUE(where({0.2F, 0.4F, 0.6F, 0.5F}).ends_with(words));
    EXPECT_FALSE(where({0.2F, 0.4F, 0.5F, 0.5F}).ends_with(words));
    EXPECT_FALSE(where({0.2F, 0.4F, 0.5F, 0.8F}).ends_with(words));
}

// A pixel off by 1/255 is within the tolerance, and the answers still say where it is.
TEST(Verdict, ShowsWhereAllowedRoundingDiffers) {
    Comparison comparison = Stub().compare();
    RegionDifference& beyond = comparison.pairs[1].difference.beyond_allowed;
    beyond = {.pixels = 5000, .differing = 2, .max = 1 / 255.0, .rms = 1e-4, .worst_x = 7, .worst_y = 8};
    comparison.pairs[1].difference.interior = beyond;
    EXPECT_EQ(answer(comparison).headline, "All three agree: the largest difference away from edges is 1/255.");
    EXPECT_EQ(answer(comparison).where,
              "fixed ~ reference differ most: at 2 of 5,000 pixels away from edges (0.04%), for example (7, 8).");
}

TEST(Verdict, SaysWhatExplainsALargerDifference) {
    Comparison comparison = Stub().compare();
    ImageDifference& difference = comparison.pairs[1].difference;
    difference.interior = {.pixels = 5000, .differing = 2, .max = 3 / 255.0, .rms = 1e-4, .worst_x = 7, .worst_y = 8};
    const std::string largest = "All three agree: the largest difference away from edges is 3/255, and OpenGL leaves ";
    difference.beyond_allowed = {.pixels = 5000};
    EXPECT_EQ(answer(comparison).headline, largest + "that much open.");
    difference.beyond_allowed = {.pixels = 5000, .differing = 1, .max = 1 / 255.0};
    EXPECT_EQ(answer(comparison).headline, largest + "all but 1/255 of it open.");
    EXPECT_EQ(largest_difference(comparison), 3 / 255.0);
}

TEST(Verdict, LeavesPicturesThatAreMeantToDifferOutOfItsLargestDifference) {
    Comparison comparison = Stub().compare();
    Pair& meant = comparison.pairs.back();
    ASSERT_EQ(meant.verdict, Verdict::kInformative);
    meant.difference.interior.max = 1;
    EXPECT_EQ(largest_difference(comparison), 0);
    meant.verdict = Verdict::kWithin;
    EXPECT_EQ(largest_difference(comparison), 1);
}

// A wide line, which softpipe draws half a pixel too far along, and no other driver.
TEST(Verdict, NamesWhatTheDriverIsKnownToGetWrongWhereItIsBeyond) {
    Draw line;
    line.mode = kGL_LINES;
    line.vertices.edit().resize(2);
    line.raster.line_width = 5;
    Scene scene = empty_scene();
    scene.frame.items.emplace_back(line);
    Stub stub;
    const auto compared = [&](const std::string& driver) {
        return compare_scene(scene, {.driver = driver + ", EGL", .per_vertex_only = true}, stub.renderers());
    };
    const std::string softpipe = "softpipe, 3.3 (Compatibility Profile) Mesa 22.3.1";
    EXPECT_TRUE(answer(compared(softpipe)).details.empty());
    EXPECT_TRUE(answer(compared("a GPU, 4.6 Mesa 22.3.6")).details.empty());
    stub.fixed = 0.6F;
    const Comparison beyond = compared(softpipe);
    ASSERT_EQ(beyond.known_departures.size(), 1U);
    EXPECT_TRUE(beyond.known_departures[0].starts_with("wide lines in softpipe (3.4.2: "));
    EXPECT_EQ(answer(beyond).details.back(), "A known bug of softpipe in Mesa 22.3.1 may be the cause: " +
                                                 beyond.known_departures[0] + ". See golden/known_differences.");
    EXPECT_EQ(json::parse(comparison_json(beyond))["known_departures"], json(beyond.known_departures));
    EXPECT_EQ(json::parse(comparison_json(beyond))["is_listed_driver"], true);
    const Comparison unmeasured = compared("softpipe, 3.3 (Compatibility Profile) Mesa 24.0.5");
    EXPECT_TRUE(answer(unmeasured)
                    .details.back()
                    .starts_with("A known bug of softpipe in Mesa 24.0.5 (measured on Mesa 22.3) may be the cause: "));
    for (const char* driver : {"a GPU, 4.6 Mesa 22.3.6", "?"}) {
        const Comparison other = compared(driver);
        EXPECT_EQ(other.known_departures.size(), 0U);
        EXPECT_EQ(json::parse(comparison_json(other))["is_listed_driver"], false);
        EXPECT_EQ(answer(other).details.back(), "No known bugs are listed for this driver.");
    }
    const Comparison listed = compared("llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile) Mesa 22.3.6");
    EXPECT_TRUE(answer(listed).details.back().starts_with("fixed ~ reference: "));
}

TEST(Verdict, BlamesNoBugOfTheFixedFunctionForPicturesInWhichItHasNoPart) {
    const auto commands = std::make_shared<const CommandList>(
        read_scene("glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); "
                   "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR); glutSolidCube(1);",
                   "scene.gl", "scene"));
    const Scene scene = make_scene(commands, {.width = kWidth, .height = kHeight});
    Stub stub;
    Renderers renderers = stub.renderers();
    const auto bugs = [&] {
        const Comparison comparison =
            compare_scene(scene, {.driver = "softpipe, 3.3 (Compatibility Profile) Mesa 22.3.1, EGL"}, renderers);
        EXPECT_FALSE(comparison.within_tolerance());
        return comparison.known_departures.size();
    };
    renderers.programmable = [](const Frame& frame, const programmable::Options& options) {
        return Stub::picture(frame, options.shading ? 0.6F : 128.0F / 255);
    };
    EXPECT_EQ(bugs(), 0U);
    stub.fixed = 0.6F;
    EXPECT_EQ(bugs(), 1U);
}

TEST(Verdict, IsPartialWhereARendererLeavesSomethingOut) {
    Stub stub;
    stub.fixed = 0.6F;
    stub.without_fog = 128.0F / 255;
    stub.unsupported = {fog(2)};  // programmable and reference do without
    const Comparison comparison = stub.compare();
    EXPECT_EQ(pair_named(comparison, "fixed ~ shaders").verdict, Verdict::kPartial);
    EXPECT_EQ(pair_named(comparison, "shaders ~ reference").verdict, Verdict::kPartial);
    EXPECT_EQ(pair_named(comparison, "shaders-phong ~ reference-phong").verdict, Verdict::kPartial);
    EXPECT_EQ(comparison.verdict(), Verdict::kPartial);
    EXPECT_TRUE(comparison.within_tolerance());
    EXPECT_EQ(answer(comparison).headline,
              "The comparison is partial: one kind of command is not drawn by every renderer.");
    EXPECT_EQ(answer(comparison).where,
              "The first is glEnable(GL_FOG) at scene.gl:3:1. Where leaving them out changes no pixel of the fixed "
              "function, the pictures agree.");
    EXPECT_EQ(answer(comparison).details.front(), "They change 1,200 of 1,200 pixels.");
    EXPECT_EQ(json::parse(comparison_json(comparison))["verdict"], "partial");
}

// A difference where the missing commands change nothing has another cause.
TEST(Verdict, IsBeyondWhereTheMissingCommandsExplainNothing) {
    Stub stub;
    stub.fixed = stub.without_fog = 0.6F;
    stub.unsupported = {fog(2)};
    const Comparison comparison = stub.compare();
    EXPECT_EQ(pair_named(comparison, "fixed ~ shaders").verdict, Verdict::kBeyond);
    EXPECT_EQ(pair_named(comparison, "shaders ~ reference").verdict, Verdict::kWithin);
    EXPECT_EQ(comparison.verdict(), Verdict::kBeyond);
    EXPECT_FALSE(comparison.within_tolerance());
}

TEST(Verdict, IsWithinIfTheMissingCommandsChangeNoPixel) {
    Stub stub;
    stub.unsupported = {fog(2)};
    const Comparison comparison = stub.compare();
    EXPECT_EQ(comparison.verdict(), Verdict::kWithin);
    EXPECT_EQ(answer(comparison).headline, "All three agree: no pixel away from edges differs.");
    EXPECT_EQ(answer(comparison).details.front(),
              "Not every renderer draws all commands, but leaving those out changes no pixel.");
    // Commands that no renderer draws might change every picture.
    stub.unsupported.push_back({"glUseProgram", 1, {}, MissingFrom::kEverything});
    EXPECT_EQ(stub.compare().verdict(), Verdict::kPartial);
}

TEST(Verdict, IsPartialIfTheMissingCommandsCannotBeLeftOut) {
    Stub stub;
    stub.fixed = 0.6F;
    stub.unsupported = {fog(2), fog(1)};
    stub.unsupported[1].name = "a border of a texture";
    const Comparison comparison = stub.compare();
    EXPECT_TRUE(comparison.changed_by_missing.empty());
    EXPECT_EQ(comparison.verdict(), Verdict::kPartial);
    EXPECT_NE(answer(comparison).where.find("the missing commands may cause any difference"), std::string::npos);
}

TEST(Missing, LeavesOutTheCommandsThatTheNamesMean) {
    const auto left = [](const std::string& name) {
        const auto scene = std::make_shared<const CommandList>(
            read_scene("glEnable(GL_FOG);\nglEnable(GL_TEXTURE_2D);\nglFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);\n"
                       "glFogf(GL_FOG_DENSITY, 0.5);\nglTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, 1);\n"
                       "glActiveTexture(GL_TEXTURE1);\nglEnable(GL_TEXTURE_2D);\nglEvalMesh2(GL_FILL, 0, 1, 0, 1);\n",
                       "scene.gl", "scene"));
        Unsupported item = fog(1);
        item.name = name;
        const auto less = without_missing(scene, {item});
        std::vector<int> lines;
        if (!less) return lines;
        for (int i = 1; i <= 8; ++i) lines.push_back(i);
        less->for_each([&](const Step& step) {
            std::erase(lines, step.command.place.line);
            return true;
        });
        return lines;
    };
    using Lines = std::vector<int>;
    EXPECT_EQ(left("glEnable(GL_FOG)"), Lines{1});
    EXPECT_EQ(left("glFog(GL_FOG_COORD_SRC, GL_FOG_COORD)"), Lines{3});
    EXPECT_EQ(left("glTexParameter(GL_TEXTURE_LOD_BIAS)"), Lines{5});
    EXPECT_EQ(left("glEvalMesh2"), Lines{8});
    EXPECT_EQ(left("glEval"), Lines{});
    for (const char* name :
         {"glEnable(GL_NO_SUCH_NAME)", "glEnable(GL_FOG", "a border", "glCopyTexImage2D", "glTexEnv(GL_COMBINE)"}) {
        Unsupported item = fog(1);
        item.name = name;
        EXPECT_EQ(without_missing(empty_scene().recording, {item}), nullptr) << name;
    }
    Unsupported item = fog(1);
    item.missing_from = MissingFrom::kEverything;
    EXPECT_EQ(without_missing(empty_scene().recording, {item}), nullptr);
}

// What both leave out cannot be why they differ.
TEST(Verdict, IsBeyondWhereBothLeaveTheSameOut) {
    Stub stub;
    stub.reference = 0.6F;
    stub.without_fog = 0.7F;
    stub.unsupported = {fog(2)};
    const Comparison comparison = stub.compare();
    EXPECT_EQ(pair_named(comparison, "fixed ~ shaders").verdict, Verdict::kPartial);
    EXPECT_EQ(pair_named(comparison, "shaders ~ reference").verdict, Verdict::kBeyond);
    EXPECT_EQ(comparison.verdict(), Verdict::kBeyond);
}

TEST(Verdict, IsNotGivenForPhongAgainstFixed) {
    Stub stub;
    const Renderers plain = stub.renderers();
    Renderers renderers = plain;
    // What phong adds, both draw alike.
    const auto white = [](const Frame& frame) { return Image(frame.width, frame.height, {1, 1, 1, 1}); };
    renderers.programmable = [&](const Frame& frame, const programmable::Options& options) {
        if (options.shading == Shading::kPhong) return white(frame);
        return plain.programmable(frame, options);
    };
    renderers.reference = [&](const Frame& frame, const reference::Options& options) {
        return options.shading == Shading::kPhong ? white(frame) : plain.reference(frame, options);
    };
    const Comparison comparison = compare_scene(empty_scene(), {}, renderers);
    EXPECT_TRUE(comparison.within_tolerance());
    EXPECT_GT(pair_named(comparison, "fixed ~ shaders-phong").difference.interior.max, 0.4);
}

// ---- What is written ----

TEST_F(ReportTest, HoldsEveryPictureTheNumbersAndThePage) {
    Stub stub;
    stub.fixed = 0.6F;
    const Comparison comparison = stub.compare();
    const fs::path out = folder_ / "new" / "folder";
    write_report(comparison, out.string());

    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(out)) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    const std::vector<std::string> expected = {
        "comparison.json",
        "difference-fixed-reference.png",
        "difference-fixed-shaders-phong.png",
        "difference-fixed-shaders.png",
        "difference-shaders-phong-reference-phong.png",
        "difference-shaders-reference.png",
        "fixed.png",
        "index.html",
        "reference-phong.png",
        "reference.png",
        "shaders-phong.png",
        "shaders.png",
    };
    EXPECT_EQ(names, expected);
    EXPECT_EQ(read_png((out / "fixed.png").string()).pixels[0], quantised(comparison.renders[0].image).pixels[0]);
}

TEST_F(ReportTest, SaysWhereItCannotBeWritten) {
    Stub stub;
    write_file_atomically((folder_ / "file").string(), "x");
    EXPECT_THROW(write_report(stub.compare(), (folder_ / "file").string()), FileError);
    EXPECT_THROW(write_report(stub.compare(), (folder_ / "file" / "below").string()), FileError);
}

// The files of the folder and those below it, without the temporary ones that a killed process leaves behind.
std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() != ".part")
            files[entry.path().lexically_relative(folder).string()] = read_file(entry.path().string());
    return files;
}

TEST_F(ReportTest, RemovesPicturesThatTheNewReportLacks) {
    Stub stub;
    Comparison exact = stub.compare();
    exact.renders.back().name = "reference-exact";
    const std::string out = (folder_ / "out").string();
    write_report(std::vector<ComparedStep>{{"one", stub.compare()}, {"two", stub.compare()}}, out);
    write_file_atomically(out + "/step-2/mine.png", "mine");
    write_file_atomically(out + "/fixed-mine.png", "mine");
    write_report(exact, out);
    std::map<std::string, std::string> expected = files_in(out);
    EXPECT_EQ(expected.size(), 14u);  // as above, and two of others
    EXPECT_EQ(expected.count("step-2/mine.png") + expected.count("fixed-mine.png"), 2u);
    EXPECT_FALSE(fs::exists(folder_ / "out/step-1"));
    write_report(stub.compare(), out);
    EXPECT_FALSE(fs::exists(folder_ / "out/reference-exact.png"));
    EXPECT_EQ(files_in(out).size(), 14u);
}

// Runs `work` in a process that is killed as it begins to name, rename or remove its n-th file. Returns false if it has fewer.
bool killed_at(int n, const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
        ::raise(SIGSTOP);
        try {
            work();
        } catch (...) {
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    int count = 0;
    while (true) {
        ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
        if (::waitpid(child, &status, 0) < 0 || !WIFSTOPPED(status)) return false;
        if (WSTOPSIG(status) != (SIGTRAP | 0x80)) continue;
        __ptrace_syscall_info info{};
        ::ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof info, &info);
        if (info.op != PTRACE_SYSCALL_INFO_ENTRY) continue;
        const auto number = static_cast<long>(info.entry.nr);
        const bool moves = number == SYS_renameat || number == SYS_renameat2 || number == SYS_unlinkat ||
                           number == SYS_linkat
#ifdef SYS_rename
                           || number == SYS_rename || number == SYS_unlink
#endif
            ;
        if (!moves || ++count < n) continue;
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        return true;
    }
}

// As long as there is a page, the folder is whole; old pictures never lie beside new ones.
TEST_F(ReportTest, IsWholeOrWithoutAPageIfTheProgramIsKilled) {
    Stub old_stub, new_stub;
    old_stub.fixed = old_stub.programmable = old_stub.reference = 0.2F;
    const Comparison old_one = old_stub.compare(), new_one = new_stub.compare();
    const std::string out = (folder_ / "out").string();
    const auto written = [&](const Comparison& comparison) {
        fs::remove_all(out);
        write_report(comparison, out);
        return files_in(out);
    };
    const std::map<std::string, std::string> new_files = written(new_one), old_files = written(old_one);
    ASSERT_EQ(new_files.size(), old_files.size());
    int incomplete = 0, n = 1;
    for (; killed_at(n, [&] { write_report(new_one, out); }); ++n) {
        const std::map<std::string, std::string> found = files_in(out);
        if (found.count("index.html") == 1) {
            EXPECT_TRUE(found == old_files || found == new_files) << "killed at " << n;
        } else {
            ++incomplete;
            std::size_t old_ones = 0, new_ones = 0;
            for (const auto& [name, bytes] : found) {
                if (old_files.at(name) == new_files.at(name)) continue;
                ++(bytes == old_files.at(name) ? old_ones : new_ones);
            }
            EXPECT_TRUE(old_ones == 0 || new_ones == 0) << "killed at " << n;
        }
        ASSERT_EQ(written(old_one), old_files);
    }
    EXPECT_EQ(files_in(out), new_files);  // the last one was not killed
    EXPECT_GT(incomplete, 10);
    EXPECT_GT(n, 20);
}

TEST(ComparisonJson, HasTheFormThatTheHeaderTells) {
    Stub stub;
    stub.reference = 128.0F / 255 + 1.0F / 255;  // one code off, everywhere
    Comparison comparison = stub.compare();
    comparison.unsupported.push_back(fog(2));
    const json read = json::parse(comparison_json(comparison));
    EXPECT_EQ(read["scene"], "stub");
    EXPECT_EQ(read["driver"], "a driver");
    EXPECT_EQ(read["size"], json({40, 30}));
    ASSERT_EQ(read["renders"].size(), 5U);
    EXPECT_EQ(read["renders"][3]["name"], "shaders-phong");
    EXPECT_EQ(read["renders"][3]["file"], "shaders-phong.png");
    EXPECT_TRUE(read["renders"][3]["ms"].is_number());
    ASSERT_EQ(read["pairs"].size(), 5U);
    const json& pair = read["pairs"][1];
    EXPECT_EQ(pair["a"], "fixed");
    EXPECT_EQ(pair["b"], "reference");
    EXPECT_EQ(pair["interior"]["pixels"], 1170);
    EXPECT_EQ(pair["interior"]["differing"], 1170);
    EXPECT_EQ(pair["interior"]["max"], 1 / 255.0);
    EXPECT_NEAR(pair["interior"]["rms"].get<double>(), std::sqrt(0.75) / 255, 1e-15);  // alpha is equal
    EXPECT_EQ(pair["interior"]["worst"], json({1, 0}));
    EXPECT_EQ(pair["edge"]["worst"], json({0, 0}));
    EXPECT_EQ(pair["verdict"], "beyond");
    EXPECT_FALSE(read["pairs"][4].contains("tolerance"));
    EXPECT_EQ(read["unsupported"][0], json({{"name", "glEnable(GL_FOG)"},
                                            {"count", 2},
                                            {"place", "scene.gl:3:1"},
                                            {"renderers", {"shaders", "reference"}}}));
}

TEST(ComparisonJson, IsValidWhateverBytesASceneIsNamedWith) {
    Stub stub;
    Comparison comparison = stub.compare();
    comparison.scene = "\xff\"\n";
    EXPECT_TRUE(json::accept(comparison_json(comparison)));
}

TEST(ComparisonPage, HoldsEverythingAndAsksForNothing) {
    Stub stub;
    Comparison comparison = stub.compare();
    comparison.scene = "<script>alert(1)</script>{{verdict}}";
    const std::string page = page_of(comparison);
    EXPECT_NE(page.find("<h1>&lt;script&gt;alert(1)&lt;/script&gt;{{verdict}}</h1>"), std::string::npos);
    for (const char* outside : {"http:", "https:", "src=\"/", "@import", "url("}) {
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    }
    for (const Render& render : comparison.renders) {
        EXPECT_NE(page.find("data-name=\"" + render.name + "\""), std::string::npos);
        EXPECT_NE(render.meaning, "");
    }
    EXPECT_NE(page.find("<p class=\"headline\">All three agree: no pixel away from edges differs.</p>"),
              std::string::npos);
    EXPECT_NE(page.find("Every renderer draws every command of the scene."), std::string::npos);
}

// Fixed function beside lighting at every pixel, with the pixel selected where they differ most.
TEST(ComparisonPage, OpensOnThePairThatTeaches) {
    Comparison comparison = Stub().compare();
    comparison.pairs.back().difference.interior = {
        .pixels = 1170, .differing = 9, .max = 40 / 255.0, .rms = 0.1, .worst_x = 31, .worst_y = 17};
    const std::string page = page_of(comparison);
    EXPECT_NE(page.find(" data-x=\"31\" data-y=\"17\">"), std::string::npos);
    const std::size_t first = page.find("<button type=\"button\" data-left=");
    EXPECT_EQ(page.find("data-left=\"fixed\" data-right=\"shaders-phong\"", first), first + 22);
    EXPECT_NE(page.find("They are meant to differ: in this scene by up to 40/255.\">Lit vertices, lit pixels</button>"),
              std::string::npos);
    EXPECT_NE(page.find("data-right=\"fixed ~ reference\" "), std::string::npos);
    EXPECT_EQ(page.find("<nav"), std::string::npos);
}

TEST(ComparisonPage, HoldsOneArticleForEachStep) {
    Stub stub;
    const Comparison first = stub.compare();
    stub.fixed = 0.6F;
    const Comparison second = stub.compare();
    const EncodedPictures pictures = encode_pictures(first);
    const std::string page = comparison_page({{"Diffuse", first, pictures}, {"<Specular>", second, pictures}});
    for (const char* text :
         {"<a href=\"#step=1\">1. Diffuse<span class=\"within\">largest difference 0/255</span></a>",
          "<a href=\"#step=2\">2. &lt;Specular&gt;<span class=\"beyond\">largest difference 25/255</span></a>",
          "id=\"step=1\"", "id=\"step=2\"", "<h2>2. &lt;Specular&gt;</h2>"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
    EXPECT_EQ(page.find("{{"), std::string::npos);
}

TEST(ComparisonPage, NamesWhatIsNotDrawn) {
    Stub stub;
    Comparison comparison = stub.compare();
    comparison.unsupported.push_back(fog(1));
    const std::string page = page_of(comparison);
    EXPECT_NE(page.find("glEnable(GL_FOG) (once, at scene.gl:3:1) is not drawn by shaders and reference."),
              std::string::npos);
}

TEST(Words, GroupDigitsAndRoundShares) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1'000), "1,000");
    EXPECT_EQ(grouped(12'345'678), "12,345,678");
    EXPECT_EQ(share_of({.pixels = 100'000, .differing = 0}), "0%");
    EXPECT_EQ(share_of({.pixels = 100'000, .differing = 9}), "< 0.01%");
    EXPECT_EQ(share_of({.pixels = 1'000, .differing = 123}), "12.30%");
    EXPECT_EQ(in_255ths(3 / 255.0), "3/255");
}

// What a plan leaves out is told, and not held against the shaders; it is held against pairs without them.
TEST(Comparison, TakesTheBoundOfThePlansForAllowed) {
    Draw draw;  // a point that GL_LIGHT1 may light by 0.4 / 255
    draw.mode = kGL_POINTS;
    draw.vertices.edit().resize(1);
    draw.lighting.enabled = true;
    draw.lighting.lights[1].enabled = true;
    draw.lighting.lights[1].diffuse = glm::dvec4(0.5 / 255);
    Scene scene = empty_scene();
    scene.frame.items.emplace_back(draw);
    Stub stub;
    stub.fixed = stub.reference = 128.3F / 255;  // 0.2 below the border
    stub.programmable = 129.0F / 255;
    const auto compared = [&](double budget) {
        return compare_scene(scene, {.budget = budget, .per_vertex_only = true}, stub.renderers());
    };
    const Comparison within = compared(0.5 / 255);
    EXPECT_NEAR(error_bound(within.renders[1].plan), 0.4 / 255, 1e-9);
    EXPECT_EQ(within.verdict(), Verdict::kWithin);
    EXPECT_EQ(compared(0).verdict(), Verdict::kBeyond);
    stub.programmable = 131.0F / 255;  // 3 codes: one of rounding and 0.4 are the plan's
    EXPECT_EQ(compared(0.5 / 255).verdict(), Verdict::kBeyond);
    stub.programmable = 129.0F / 255;
    stub.fixed = stub.reference = 128.0F / 255;  // 0.5 below: out of the plan's reach
    EXPECT_EQ(compared(0.5 / 255).verdict(), Verdict::kBeyond);
    stub.programmable = stub.reference = 128.3F / 255;
    stub.fixed = 129.0F / 255;
    EXPECT_EQ(compared(0.5 / 255).verdict(), Verdict::kBeyond);
}

// Two quadrilaterals whose alpha is 1 at two corners that face each other, blended over each other. Between the diagonals either cut has
// a colour of its own, so each Draw must have its own choice.
std::string two_quadrilaterals_text() {
    const std::string quad =
        "glBegin(GL_QUADS); glColor4f(1, 0, 0, 1); glVertex2f(-1, -1); glColor4f(0, 0, 1, 0); "
        "glVertex2f(1, -1); glColor4f(1, 0, 0, 1); glVertex2f(1, 1); glColor4f(0, 0, 1, 0); "
        "glVertex2f(-1, 1); glEnd(); ";
    return "glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); " + quad +
           "glRotatef(20, 0, 0, 1); " + quad;
}
Scene two_quadrilaterals() {
    return make_scene(std::make_shared<CommandList>(read_scene(two_quadrilaterals_text(), "scene.gl", "scene")),
                      {.width = 32, .height = 32});
}

Renderers renderers_of(const Image& drawn) {
    return {.fixed = [&](const Scene&, const fixed::Options&) { return drawn; },
            .programmable = [&](const Frame&, const programmable::Options&) { return drawn; },
            .reference = [](const Frame& frame,
                            const reference::Options& options) { return reference::render(frame, options); },
            .allowed_difference =
                [](const Frame& frame, const reference::Options& options) {
                    return reference::allowed_difference(frame, options);
                }};
}

TEST(Comparison, ADriverMayCutEachDrawsQuadrilateralsItsOwnWay) {
    const Scene scene = two_quadrilaterals();
    for (const bool first : {false, true})
        for (const bool second : {false, true}) {
            reference::Options options{{.lecture_variants = false}};
            options.cut_otherwise = {first, second};
            const Image drawn = reference::render(scene.frame, options);
            const Comparison comparison =
                compare_scene(scene, {.driver = "a driver", .per_vertex_only = true}, renderers_of(drawn));
            EXPECT_EQ(comparison.verdict(), Verdict::kWithin) << first << second;
            EXPECT_EQ(comparison.pairs[1].counterpart.has_value(), first != second);
        }
}

// A driver that cuts one Draw each way, and whose bug does not show in the rewritten scene.
TEST(Comparison, ProvesACauseInAnyMixOfCuts) {
    const auto commands = std::make_shared<CommandList>(
        read_scene("glEnable(GL_LIGHTING); glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0, 0, 1});\n"
                   "glEnable(GL_COLOR_MATERIAL); glDisable(GL_COLOR_MATERIAL); glDisable(GL_LIGHTING);\n" +
                       two_quadrilaterals_text() + "glEnable(GL_LIGHTING); glRectf(-0.1, -0.1, 0.1, 0.1);",
                   "scene.gl", "scene"));
    const Scene scene = make_scene(commands, {.width = 32, .height = 32});
    reference::Options options{{.lecture_variants = false}};
    options.cut_otherwise = {true, false};
    const Image right = reference::render(scene.frame, options);
    Image wrong = right;
    for (int y = 15; y < 18; ++y)
        for (int x = 15; x < 18; ++x) wrong.at(x, y)[1] = 0.9F;
    Renderers renderers = renderers_of(right);
    renderers.fixed = [&](const Scene& drawn, const fixed::Options&) {
        return drawn.recording == scene.recording ? wrong : right;
    };
    const Comparison comparison =
        compare_scene(scene, {.driver = "llvmpipe, 4.5 (Compatibility Profile) Mesa 22.3.6"}, renderers);
    EXPECT_EQ(comparison.verdict(), Verdict::kBeyond);
    EXPECT_EQ(comparison.proved_causes.size(), 1u);
}

TEST(Comparison, OtherColoursAreNoCut) {
    const Scene scene = two_quadrilaterals();
    reference::Options options{{.lecture_variants = false}};
    options.cut_otherwise = {true, false};
    Image drawn = reference::render(scene.frame, options);
    for (int y = 10; y < 20; ++y)
        for (int x = 10; x < 20; ++x) drawn.at(x, y)[1] = 0.1F;  // nothing is green
    const Comparison comparison =
        compare_scene(scene, {.driver = "a driver", .per_vertex_only = true}, renderers_of(drawn));
    EXPECT_EQ(comparison.verdict(), Verdict::kBeyond);
}

}  // namespace
}  // namespace twinlight::report::comparison_test
