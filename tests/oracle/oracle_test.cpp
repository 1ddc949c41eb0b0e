// Random states at the limits of floats, judged by the oracle (judge/oracle): the reference with all its number types, and the shaders
// with all their tiers and shadings. judge/fuzz/against_oracle.h has the bar, and the names of what may miss it.
#include "judge/oracle/oracle.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "../unit/effort.h"
#include "judge/check/variants.h"
#include "judge/fuzz/against_oracle.h"
#include "scene/command/text.h"

namespace twinlight::oracle_test {
namespace {

fuzz::OracleOptions only_the_reference(const fuzz::RunOptions& run) {
    fuzz::OracleOptions options{run};
    options.shaders = false;
    return options;
}

void expect_no_failure(const fuzz::OracleSummary& summary, std::uint64_t seed) {
    for (const fuzz::OracleFailure& failure : summary.failures) ADD_FAILURE() << fuzz::failure_text(failure, seed);
    EXPECT_LE(summary.out_of_view, summary.states / 10);
}

// Each reason covers at most this share of the colours.
void expect_rare(const fuzz::OracleSummary& summary, const std::string& who, double share) {
    ASSERT_TRUE(summary.counts.contains(who)) << who;
    const fuzz::OracleCounts& counts = summary.counts.at(who);
    const auto all = static_cast<double>(counts.compared());
    EXPECT_GT(all, 0);
    for (const auto& [verdict, count] : counts.verdicts)
        if (verdict != fuzz::kRight) {
            EXPECT_LE(static_cast<double>(count), share * all + 4)
                << who << ": " << verdict << ", of " << all << " colours";
        }
}

TEST(Oracle, AgreesWithTheReferenceInAllNumberTypes) {
    const fuzz::OracleSummary summary = fuzz::run_against_oracle(only_the_reference({.count = 2000}));
    expect_no_failure(summary, 1);
    for (const check::ReferenceVariant& variant : check::reference_variants())
        expect_rare(summary, "reference, " + variant.name, 0.08);
    // Each ill-conditioned colour has a condition number, of 10 or more.
    for (const auto& [who, counts] : summary.counts) {
        long with_condition = 0;
        for (const auto& [power, count] : counts.conditions) with_condition += count;
        EXPECT_EQ(with_condition, counts.verdicts.at(fuzz::kIllConditioned)) << who;
        EXPECT_GE(counts.conditions.begin()->first, 1) << who;
    }
}

TEST(Oracle, AgreesWithTheShadersInAllTiersWhichAreNeverWorseThanTheFixedFunction) {
    fuzz::OracleOptions options{{.count = tries_all() ? 1000u : 400u, .seed = 2}};
    options.reference = false;
    const fuzz::OracleSummary summary = fuzz::run_against_oracle(options);
    expect_no_failure(summary, 2);
    ASSERT_GE(summary.counts.size(), 5u);
    for (const auto& [who, counts] : summary.counts) expect_rare(summary, who, 0.08);
}

// A spot factor of 3.1e-39, which a driver may flush to 0, under an attenuation of 1e37: the ambient term is 0.2 of 0.031.
TEST(Oracle, AddsUpTheTermsWithDenormalPowers) {
    const auto sum = [](int exponent) {
        const std::string text = fmt::format(
            "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){{0, 0, 1, 0}});"
            "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){{-1, 0, 0, 1}}); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 79);"
            "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){{0.4008, 0.9162, 0}});"
            "glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, {}); glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1e-37);"
            "glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();",
            exponent);
        return oracle::light(read_scene(text, "spot", "spot")).at(0).of_denormal_powers;
    };
    EXPECT_NEAR(sum(97), 0.2 * std::pow(0.4008 / std::hypot(0.4008, 0.9162), 97) * 1e37, 1e-5);
    EXPECT_EQ(sum(80), 0);
}

// With a bar that nobody can reach, everything fails.
TEST(Oracle, ShrinksWhatItFindsToASceneThatStillFails) {
    fuzz::OracleOptions options = only_the_reference({.count = 20, .most_failures = 1});
    options.strictness = 1e9;
    const fuzz::OracleSummary summary = fuzz::run_against_oracle(options);
    ASSERT_EQ(summary.failures.size(), 1u);
    const fuzz::OracleFailure& failure = summary.failures.front();
    EXPECT_TRUE(summary.broken_off);
    EXPECT_TRUE(failure.who.starts_with("reference, ")) << failure.who;
    EXPECT_LT(failure.scene.commands.size(), failure.commands_before);
    EXPECT_NE(failure.what.find("is wrong: ("), std::string::npos) << failure.what;
    const std::string text = fuzz::failure_text(failure, options.seed);
    const std::string first_line =
        fmt::format("// twinlight fuzz --against oracle --seed 1 --first {} --count 1\n", failure.state);
    EXPECT_TRUE(text.starts_with(first_line)) << text;
    const CommandList again = read_scene(text, "failure.gl", "failure");
    EXPECT_EQ(print_scene(again), print_scene(failure.scene));
}

TEST(Oracle, ShrinksOnlyTheFirstTenFailures) {
    EXPECT_TRUE(fuzz::RunOptions{}.shrinks_after(9));
    EXPECT_FALSE(fuzz::RunOptions{}.shrinks_after(10));
    EXPECT_FALSE(fuzz::RunOptions{.shrinks = false}.shrinks_after(0));
}

TEST(Oracle, StatesDoNotDependOnTheFirst) {
    const auto text = [](std::uint64_t state) { return print_scene(fuzz::extreme_scene(7, state)); };
    EXPECT_EQ(text(41), text(41));
    EXPECT_NE(text(41), text(42));
}

// What the states are made for, of 2,000: both faces, tracked colours of all kinds, singular matrices, w of 0.
TEST(Oracle, StatesReachWhatTheyAreMadeFor) {
    int triangles = 0, two_sided = 0, flattened = 0, w_0 = 0, far = 0, tiny = 0;
    std::set<std::pair<double, double>> tracked;
    for (std::uint64_t state = 0; state < 2000; ++state) {
        for (const Command& c : fuzz::extreme_scene(3, state * 997).commands) {
            triangles += c.id == CommandId::glBegin && c.enumerant(0) == kGL_TRIANGLES;
            two_sided += c.id == CommandId::glLightModeli && c.enumerant(0) == kGL_LIGHT_MODEL_TWO_SIDE;
            flattened += c.id == CommandId::glScalef && c.number(0) * c.number(1) * c.number(2) == 0;
            w_0 += c.id == CommandId::glVertex4f && c.number(3) == 0;
            if (c.id == CommandId::glColorMaterial) tracked.insert({c.number(0), c.number(1)});
            if (c.id != CommandId::glLightfv || c.enumerant(1) != kGL_POSITION) continue;
            const double size = std::abs(c.number(2));
            far += size > 1e30;
            tiny += size > 0 && size < 1e-30;
        }
    }
    for (const int count : {triangles, two_sided, flattened, w_0, far, tiny}) EXPECT_GT(count, 20);
    EXPECT_EQ(tracked.size(), 15u);  // three faces, five modes
}

}  // namespace
}  // namespace twinlight::oracle_test
