// Random evaluators: the vertices of the driver's feedback (5.3) and those of State are the same, in floats. Normals
// are compared as texture coordinates (GL_NORMAL_MAP).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "judge/fuzz/random.h"
#include "render/context/context.h"
#include "render/reference/vertices/vertex_stage.h"
#include "scene/command/text.h"
#include "scene/state/state.h"
#include "sent_points.h"

namespace twinlight::evaluators_match_driver_test {
namespace {

constexpr int kStates = 200;
constexpr int kSide = 64;
constexpr double kReach = 64;  // the view volume

class Builder {
  public:
    explicit Builder(std::uint64_t seed) : random_(seed) {}

    std::string text() {
        add(kOneTexel);
        add(fmt::format(
            "glMatrixMode(GL_PROJECTION); glOrtho(-{0}, {0}, -{0}, {0}, -{0}, {0}); glMatrixMode(GL_MODELVIEW);",
            kReach));
        if (random_.chance(0.5)) add("glEnable(GL_AUTO_NORMAL);");
        if (random_.chance(0.6))
            for (const char c : {'S', 'T', 'R'})
                add(fmt::format("glTexGeni(GL_{0}, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glEnable(GL_TEXTURE_GEN_{0});",
                                c));
        add("glColor4f(0.1, 0.2, 0.3, 0.4); glNormal3f(0.6, 0, 0.8); glTexCoord4f(0.3, 0.4, 0.5, 1);");
        const bool two = random_.chance(0.6);
        map(two, random_.chance(0.3) ? "VERTEX_4" : "VERTEX_3");
        for (const char* of :
             {"COLOR_4", "NORMAL", "TEXTURE_COORD_1", "TEXTURE_COORD_2", "TEXTURE_COORD_3", "TEXTURE_COORD_4"})
            if (random_.chance(0.3)) map(two, of);
        if (two) {
            add(fmt::format("glMapGrid2f({}, {:.3f}, {:.3f}, {}, {:.3f}, {:.3f});", 3 + random_.below(3),
                            random_.uniform(0, 0.3), random_.uniform(0.6, 1), 2 + random_.below(3),
                            random_.uniform(0, 0.3), random_.uniform(0.6, 1)));
            add("glEvalMesh2(GL_POINT, 0, 3, 0, 2);");
            add(fmt::format("glBegin(GL_POINTS); glEvalCoord2f({0:.3f}, {1:.3f}); glEvalPoint2(1, 2); glEnd();",
                            random_.uniform(0, 1), random_.uniform(0, 1)));
        } else {
            add(fmt::format("glMapGrid1f({}, {:.3f}, {:.3f});", 3 + random_.below(3), random_.uniform(0, 0.3),
                            random_.uniform(0.6, 1)));
            add("glEvalMesh1(GL_POINT, 0, 3);");
            add(fmt::format("glBegin(GL_POINTS); glEvalCoord1f({:.3f}); glEvalPoint1(1); glEnd();",
                            random_.uniform(0, 1)));
        }
        return std::move(text_);
    }

  private:
    void add(const std::string& line) { text_ += line + "\n"; }
    void map(bool two, const std::string& of) {
        const int size = of.ends_with('4') ? 4 : of.ends_with('1') ? 1 : of.ends_with('2') ? 2 : 3;
        // Mesa evaluates surfaces of order 1 wrongly with GL_AUTO_NORMAL; they have no normal anyway.
        const int least = two ? 2 : 1, order_u = least + random_.below(4);
        const int order_v = two ? least + random_.below(3) : 1, gap = random_.below(3);
        std::string points;
        for (int i = 0; i < order_u * order_v * (size + gap); ++i)
            points +=
                fmt::format("{}{:.3f}", i ? ", " : "",
                            size == 4 && i % (size + gap) == 3 ? random_.uniform(0.8, 1.2) : random_.uniform(-1, 1));
        const std::string target = fmt::format("GL_MAP{}_{}", two ? 2 : 1, of);
        const std::string u = fmt::format("{:.3f}, {:.3f}", random_.uniform(-1, -0.2), random_.uniform(1.2, 2));
        const std::string v = fmt::format("{:.3f}, {:.3f}", random_.uniform(-1, -0.2), random_.uniform(1.2, 2));
        if (two)
            add(fmt::format("glMap2f({}, {}, {}, {}, {}, {}, {}, (GLfloat[]){{{}}});", target, u,
                            (size + gap) * order_v, order_u, v, size + gap, order_v, points));
        else
            add(fmt::format("glMap1f({}, {}, {}, {}, (GLfloat[]){{{}}});", target, u, size + gap, order_u, points));
        add(fmt::format("glEnable({});", target));
    }

    fuzz::Random random_;
    std::string text_;
};

std::vector<SentPoint> of_state(const Frame& frame) {
    std::vector<SentPoint> all;
    for (const Draw* draw : frame.draws())
        for (const reference::StageVertex& v : reference::vertex_stage(*draw)) {
            const glm::dvec3 ndc = glm::dvec3(v.position_clip) / v.position_clip.w;
            all.push_back(
                {glm::dvec4((ndc.x + 1) * kSide / 2, (ndc.y + 1) * kSide / 2, (ndc.z + 1) / 2, v.position_clip.w),
                 glm::clamp(v.color, 0.0, 1.0), v.tex_coord});
        }
    return all;
}

TEST(EvaluatorsMatchDriver, InFloatsOverRandomMaps) {
    const auto context = make_offscreen_context(kSide, kSide);
    for (std::uint64_t seed = 1; seed <= kStates && !HasFailure(); ++seed) {
        const CommandList scene = read_scene(Builder(seed).text(), "scene", "scene");
        SCOPED_TRACE(fmt::format("seed {}\n{}", seed, print_scene(scene)));
        const std::vector<SentPoint> state = of_state(make_frame(scene, {.width = kSide, .height = kSide}));
        const std::vector<SentPoint> driver = sent_by_driver(scene, kSide);
        ASSERT_EQ(driver.size(), state.size());
        constexpr double kPoint = 64 * 0x1p-24;          // the roundings of a sum of at most 20 products
        constexpr double kNormal = 1000 * 1.5 * kPoint;  // two tangents, and their product: each may cancel one digit
        for (std::size_t n = 0; n < state.size(); ++n)
            for (int i = 0; i < 4; ++i) {
                EXPECT_NEAR(driver[n].window[i], state[n].window[i], kPoint * kSide) << n;
                EXPECT_NEAR(driver[n].color[i], state[n].color[i], kPoint) << n;
                EXPECT_NEAR(driver[n].tex_coord[i], state[n].tex_coord[i], kNormal) << n;
            }
    }
}

}  // namespace
}  // namespace twinlight::evaluators_match_driver_test
