// Random states at the limits of the lighting equation, judged by the oracle (judge/oracle): the reference with all its number
// types, and the shaders with all their tiers and shadings. TWINLIGHT_ORACLE_STATES=N tests N states instead of a few hundred.
//
// The bar, relative to the larger of 1 and the sum of the terms' magnitudes: 1e-12 for doubles, 3e-5 for floats. A result may
// miss it only for a reason that has a name here; the test counts each name, and no name may cover more than its share.
#include "judge/oracle/oracle.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../unit/effort.h"
#include "judge/check/variants.h"
#include "judge/compare/shader_context.h"
#include "judge/compare/vertex_colors.h"
#include "judge/fuzz/random_states.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"

namespace twinlight {
namespace {

// What a number type can do.
struct Numbers {
    double bar = 0;
    double cosines = 0;         // comparisons of cosines nearer than this are decided by rounding
    double value_rounding = 0;  // of each stored value
    double most = 0;            // the largest coordinate whose square is such a number
    bool flushes = false;       // denormals may be 0 (2.1.1)
};
constexpr double kOfMatrices = 0x1p-53;  // all renderers multiply matrices in double
constexpr Numbers kDoubles{1e-12, 1e-14, 0x1p-53, 1e150, false};
constexpr Numbers kFloats{3e-5, 1e-6, 0x1p-24, 1e18, true};
// The shaders take lengths beyond 1e18 apart before they square them.
constexpr Numbers kShaderFloats{3e-5, 1e-6, 0x1p-24, 1e37, true};

struct State {
    CommandList commands;
    std::optional<compare::VertexScene> scene;
    oracle::Vertex right, right_with_unit_normals;
};

// 2.1.1 asks for colours up to 1024; a double's largest may be infinite when a long double is not.
constexpr const char* kBeyondColors = "a colour beyond the largest float";

bool is_denormal(double x) { return x != 0 && std::abs(x) < 0x1p-126; }

// Why floats or doubles cannot give the answer, seen from the state; empty if they can.
std::string reason(const State& state, const Numbers& numbers, bool is_shader) {
    const Draw& draw = state.scene->draw();
    bool beyond = false, denormal = false, two_directions = false, wide = false, cancels = false;
    for (const double magnitude : state.right.front.magnitude)
        if (magnitude > 1e30) return kBeyondColors;
    const auto look_at = [&](const auto& v, double w) {
        for (int i = 0; i < 3; ++i) {
            beyond |= !(std::abs(w == 0 ? v[static_cast<std::size_t>(i)] : v[static_cast<std::size_t>(i)] / w) <
                        numbers.most);
            denormal |= is_denormal(v[static_cast<std::size_t>(i)]);
        }
        denormal |= is_denormal(w);
    };
    look_at(state.right.position_eye, state.right.position_eye[3]);
    const glm::dvec4& object = draw.vertices.back().position_object;
    look_at(std::array{object.x, object.y, object.z}, 1);
    denormal |= is_denormal(object.w);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) beyond |= !(std::abs(draw.eye_from_object[column][row]) < numbers.most);
    for (const LightSource& light : draw.lighting.lights) {
        if (!light.enabled) continue;
        const glm::dvec4& p = light.position_eye;
        look_at(std::array{p.x, p.y, p.z}, p.w);
        two_directions |= p.w == 0 && state.right.position_eye[3] == 0;
        for (const double k : {light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation})
            denormal |= is_denormal(k);
        if (p.w == 0) continue;
        double distance = 0, size = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double v = state.right.position_eye[i] / state.right.position_eye[3],
                         l = p[static_cast<int>(i)] / p.w;
            distance = std::max(distance, std::abs(v - l));
            size = std::max({size, std::abs(v), std::abs(l)});
        }
        cancels |= distance > 0 && distance < 0x1p-45 * size;
        wide |= !(distance > 0x1p-8 * size) || !(size < 1e9) || !(size > 1e-9);
    }
    if (cancels) return "a light and a vertex that agree in 45 bits";
    if (beyond) return "coordinates beyond a float";
    if (numbers.flushes && denormal) return "denormals";
    if (two_directions) return "a vertex and a light in directions";
    if (is_shader && wide && draw.lighting.enabled &&
        std::abs(glm::determinant(glm::dmat3(draw.eye_from_object))) < 1e-300)
        return "a wide range under a flattening matrix";
    return "";
}

template <class Error>
std::string judge(const State& state, const Numbers& numbers, bool unit_normals, bool is_shader, const Error& error,
                  double& worst) {
    const oracle::Colors& right = (unit_normals ? state.right_with_unit_normals : state.right).front;
    const double first = error(right);
    worst = first;
    if (first <= numbers.bar) return "right";
    const std::string why = reason(state, numbers, is_shader);
    if (std::isinf(first) && why != kBeyondColors) return "not finite";
    if (!why.empty()) return why;
    const auto with = [&](oracle::Border border, double matrices, double values, std::uint64_t seed) {
        return oracle::light(state.commands, {border, numbers.cosines, matrices, values, seed, unit_normals})
            .back()
            .front;
    };
    constexpr oracle::Border kBorders[] = {oracle::Border::kExact, oracle::Border::kInside, oracle::Border::kOutside};
    for (const oracle::Border border : kBorders)
        if (error(with(border, 0, 0, 0)) <= numbers.bar) return "a border";
    // How far rounding alone moves the exact result.
    double spread = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
        for (const oracle::Border border : kBorders) {
            const oracle::Colors moved = with(border, kOfMatrices, numbers.value_rounding, seed);
            for (std::size_t i = 0; i < 3; ++i)
                spread = std::max(spread, (std::abs(moved.primary[i] - right.primary[i]) +
                                           std::abs(moved.secondary[i] - right.secondary[i])) /
                                              std::max(1.0, right.magnitude[i]));
        }
    constexpr double kOperations = 8, kLost = 0.01;  // beyond kLost no digit of the colour is known
    if (first <= kOperations * spread || spread > kLost) return "ill-conditioned";
    return "wrong";
}

double relative(double a, double b, double magnitude) {
    if (!std::isfinite(a)) return HUGE_VAL;
    return a == b ? 0 : std::abs(a - b) / std::max(1.0, magnitude);
}

class Judge {
  public:
    void note(const std::string& who, const State& state, const std::string& verdict, double worst) {
        ++counts_[who][verdict];
        if (verdict == "wrong" || verdict == "not finite")
            ADD_FAILURE() << who << " is " << verdict << ": off by " << worst << " in\n" << print_scene(state.commands);
    }
    // Each reason covers at most this share of the states.
    void expect_rare(const std::string& who, double share) const {
        const auto found = counts_.find(who);
        ASSERT_NE(found, counts_.end()) << who;
        int all = 0;
        for (const auto& [verdict, count] : found->second) all += count;
        for (const auto& [verdict, count] : found->second)
            if (verdict != "right") {
                EXPECT_LE(count, share * all + 3) << who << ": " << verdict << ", of " << all << " states";
            }
    }
    std::string text() const {
        std::string text;
        for (const auto& [who, verdicts] : counts_) {
            text += fmt::format("{:24}", who);
            for (const auto& [verdict, count] : verdicts) text += fmt::format("  {} {}", verdict, count);
            text += "\n";
        }
        return text;
    }

  private:
    std::map<std::string, std::map<std::string, int>> counts_;
};

std::vector<State> states(std::uint64_t structure, std::uint64_t count) {
    std::vector<State> all;
    for (std::uint64_t i = 0; i < count; ++i) {
        CommandList commands = fuzz::extreme_state({structure * 7919 + 1, (structure * count + i) * 104729 + 7});
        std::string error;
        std::optional<compare::VertexScene> scene =
            compare::make_vertex_scene(std::make_shared<const CommandList>(commands), error);
        if (!scene) continue;  // the vertex is not in view: its eye coordinates overflow
        all.push_back({commands, std::move(scene), oracle::light(commands).back(),
                       oracle::light(commands, {.unit_normals = true}).back()});
    }
    return all;
}

std::uint64_t state_count(std::uint64_t usual) {
    const char* given = std::getenv("TWINLIGHT_ORACLE_STATES");
    return given ? std::strtoull(given, nullptr, 10) : usual;
}

void judge_reference(Judge& judged, const State& state) {
    for (const check::ReferenceVariant& variant : check::reference_variants()) {
        reference::Options options = variant.options;
        options.lecture_variants = false;
        reference::LitVertex lit = reference::light_vertices(state.scene->draw(), options, false).back();
        // What a long double holds may be infinite as a double.
        if (variant.options.arithmetic.number == Number::kLongDouble)
            for (glm::dvec4* color : {&lit.front_primary, &lit.front_secondary})
                *color = glm::clamp(*color, -std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
        double worst = 0;
        const std::string verdict = judge(
            state, variant.options.arithmetic.number == Number::kFloat ? kFloats : kDoubles, false, false,
            [&](const oracle::Colors& right) {
                double error = 0;
                for (int i = 0; i < 3; ++i) {
                    const auto at = static_cast<std::size_t>(i);
                    error = std::max({error, relative(lit.front_primary[i], right.primary[at], right.magnitude[at]),
                                      relative(lit.front_secondary[i], right.secondary[at], right.magnitude[at])});
                }
                return error;
            },
            worst);
        judged.note(variant.name, state, verdict, worst);
    }
}

void judge_shaders(Judge& judged, std::vector<State>& states, compare::ShaderContext& context) {
    std::vector<std::optional<compare::VertexScene>> scenes;
    for (const State& state : states) scenes.push_back(state.scene);
    for (const check::ShaderVariant& variant : check::shader_variants()) {
        programmable::Options options = variant.options;
        options.lecture_variants = false;
        const std::vector<std::vector<compare::Color>> colors =
            compare::shader_colors(scenes, context.shaders(), options);
        for (std::size_t i = 0; i < states.size(); ++i) {
            if (!colors[i].front()) continue;
            const glm::dvec4 color = *colors[i].front();
            double worst = 0;
            const std::string verdict = judge(
                states[i], kShaderFloats, options.shading == Shading::kPhong, true,
                [&](const oracle::Colors& right) {
                    double error = 0;
                    for (std::size_t c = 0; c < 3; ++c) {
                        const double sum = std::clamp(
                            std::clamp(right.primary[c], 0.0, 1.0) + std::clamp(right.secondary[c], 0.0, 1.0), 0.0,
                            1.0);
                        error = std::max(error, relative(color[static_cast<int>(c)], sum, right.magnitude[c]));
                    }
                    return error;
                },
                worst);
            judged.note(variant.name, states[i], verdict, worst);
        }
    }
}

constexpr std::uint64_t kPerStructure = 50;

TEST(Oracle, AgreesWithTheReferenceInAllNumberTypes) {
    Judge judged;
    for (std::uint64_t i = 0; i < state_count(2000) / kPerStructure; ++i)
        for (const State& state : states(i, kPerStructure)) judge_reference(judged, state);
    for (const check::ReferenceVariant& variant : check::reference_variants()) judged.expect_rare(variant.name, 0.05);
    if (std::getenv("TWINLIGHT_ORACLE_STATES")) fmt::print("{}", judged.text());
}

TEST(Oracle, AgreesWithTheShadersInAllTiers) {
    compare::ShaderContext context(compare::kShaderPicture, compare::kShaderPicture, ColorBuffer::kFloat);
    context.make_current();
    Judge judged;
    for (std::uint64_t i = 0; i < state_count(tries_all() ? 400 : 200) / kPerStructure; ++i) {
        std::vector<State> some = states(100 + i, kPerStructure);
        judge_shaders(judged, some, context);
    }
    for (const check::ShaderVariant& variant : check::shader_variants()) judged.expect_rare(variant.name, 0.06);
    if (std::getenv("TWINLIGHT_ORACLE_STATES")) fmt::print("{}", judged.text());
}

}  // namespace
}  // namespace twinlight
