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

namespace twinlight {
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
}

TEST(Oracle, AgreesWithTheShadersInAllTiersWhichAreNeverWorseThanTheFixedFunction) {
    fuzz::OracleOptions options{{.count = tries_all() ? 4000u : 1000u, .seed = 2}};
    options.reference = false;
    const fuzz::OracleSummary summary = fuzz::run_against_oracle(options);
    expect_no_failure(summary, 2);
    ASSERT_GE(summary.counts.size(), 5u);
    for (const auto& [who, counts] : summary.counts) expect_rare(summary, who, 0.08);
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
}  // namespace twinlight
