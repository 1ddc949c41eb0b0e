// Lights many points at once, with every instruction set of this processor, and compares with the equation for one
// point.
#include "lighting/points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "../lighting_case.h"
#include "../run_program.h"
#include "judge/fuzz/random.h"
#include "lighting/real_cast.h"

namespace twinlight::lighting::points_test {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

struct State {
    Model<double> model;
    std::vector<Light<double>> lights;
    std::vector<Material<double>> materials;  // one, or one for each point
    std::vector<SurfacePoint<double>> surfaces;

    Points points() const {
        Points points;
        for (const SurfacePoint<double>& surface : surfaces) points.add(surface);
        for (const Material<double>& material : materials) points.add(material);
        return points;
    }
    const Material<double>& material(std::size_t i) const { return materials[materials.size() == 1 ? 0 : i]; }
};

// Random states as in a lecture's scene; if `wild`, also unusual ones: lights at the point, vectors of any length,
// infinity.
class States {
  public:
    explicit States(std::uint64_t seed) : random_(seed) {}

    State make(std::size_t point_count, bool wild) {
        wild_ = wild;
        State state;
        state.model = {.ambient = color(),
                       .local_viewer = random_.chance(0.5),
                       .separate_specular = random_.chance(0.3),
                       .reflection = random_.chance(0.2),
                       .ambient_unattenuated = random_.chance(0.2)};
        for (int i = random_.below(9); i > 0; --i) state.lights.push_back(light());
        const std::size_t materials = random_.chance(0.7) ? 1 : point_count;
        for (std::size_t i = 0; i < materials; ++i)
            state.materials.push_back({color(), color(), color(), color(), random_.uniform(0, 1), exponent()});
        for (std::size_t i = 0; i < point_count; ++i) {
            const D normal{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(0.1, 1)};
            state.surfaces.push_back({place_eye(), random_.chance(0.9) ? unit(normal) : normal * scale()});
        }
        return state;
    }

  private:
    double scale() { return wild_ && random_.chance(0.1) ? std::pow(10, random_.uniform(-320, 308)) : 1; }
    D color() { return D{random_.uniform(0, 1), random_.uniform(0, 1), random_.uniform(0, 1)} * scale(); }
    D place_eye() {
        if (wild_ && random_.chance(0.1)) return {0, 0, 0};
        return D{random_.uniform(-2, 2), random_.uniform(-2, 2), random_.uniform(-5, -1)} * scale();
    }
    double exponent() {
        if (random_.chance(0.1)) return 0;
        return random_.chance(0.5) ? random_.below(129) : random_.uniform(0, 128);
    }
    Light<double> light() {
        Light<double> light{.ambient = color(), .diffuse = color(), .specular = color()};
        if (random_.chance(0.2)) light.ambient = {};
        if (random_.chance(0.2)) light.specular = {};
        place(light, place_eye() + D{0, 0, random_.uniform(-1, 4)}, random_.chance(0.3) ? 0.0 : 1.0);
        light.spot_dir_eye = unit(D{random_.uniform(-1, 1), random_.uniform(-1, 1), -1});
        light.is_spot = random_.chance(0.3);
        light.cos_cutoff = cos_deg(random_.uniform(5, 90));
        light.spot_exponent = exponent();
        if (random_.chance(0.6)) {
            light.constant_attenuation = random_.below(3);
            light.linear_attenuation = random_.chance(0.9) ? random_.uniform(0, 1) * scale() : 0;
            light.quadratic_attenuation = random_.chance(0.9) ? random_.uniform(0, 1) : 0;
        }
        light.has_smooth_cone = random_.chance(0.1);
        light.cos_inner = 0.9;
        light.cos_outer = random_.uniform(0.5, 0.95);
        return light;
    }

    fuzz::Random random_;
    bool wild_ = false;
};

// The largest difference of a channel, relative to the sum of its terms' magnitudes (for the secondary colour: to
// itself), or to `least` if that is larger.
template <class Real>
double worst(const State& state, const Lit<Column>& lit, double least = 0) {
    double worst = 0;
    std::vector<Light<Real>> lights;
    for (const Light<double>& light : state.lights) lights.push_back(real_cast<Real>(light));
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        const auto material = real_cast<Real>(state.material(i));
        const SurfacePoint<Real> surface{vec3_cast<Vec3<Real>>(state.surfaces[i].position_eye),
                                         vec3_cast<Vec3<Real>>(state.surfaces[i].normal_eye)};
        const MeasuredLit<Real> one = measured_light<Real>(real_cast<Real>(state.model), material, surface, lights);
        const auto hold = [&](double a, Real b, Real magnitude) {
            const Real difference = std::abs(static_cast<Real>(a) - b);
            if (difference == 0) return;
            const double relative = static_cast<double>(difference / std::max(magnitude, static_cast<Real>(least)));
            if (!(relative <= worst)) worst = relative;
        };
        const D primary = at(each(lit.primary), i), secondary = at(each(lit.secondary), i);
        hold(primary.x, one.primary.x, one.magnitude.x);
        hold(primary.y, one.primary.y, one.magnitude.y);
        hold(primary.z, one.primary.z, one.magnitude.z);
        hold(secondary.x, one.secondary.x, std::abs(one.secondary.x));
        hold(secondary.y, one.secondary.y, std::abs(one.secondary.y));
        hold(secondary.z, one.secondary.z, std::abs(one.secondary.z));
        hold(Each(lit.alpha)[i], one.alpha, 1);
    }
    return worst;
}

Lit<Column> lit_of(const State& state, const Arithmetic& arithmetic = {}) {
    Lit<Column> lit;
    light_points(state.model, state.lights, state.points(), arithmetic, lit);
    return lit;
}

Lit<Column> lit_by(const InstructionSet& set, const State& state, const Arithmetic& arithmetic = {}) {
    Lit<Column> lit = lit_of(state, arithmetic);  // correct columns, but old values
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    for (Vec3<Column>* color : {&lit.primary, &lit.secondary})
        for (Column* column : {&color->x, &color->y, &color->z})
            if (color == &lit.primary || state.model.separate_specular) column->assign(column->size(), nothing);
    set.light_points(state.model, state.lights, state.points(), arithmetic, lit);
    return lit;
}

class LightPoints : public testing::TestWithParam<InstructionSet> {};

TEST_P(LightPoints, GivesWhatTheEquationGivesForEach) {
    States states(1);
    for (int i = 0; i < 400; ++i) {
        const State state = states.make(37, false);
        EXPECT_LE(worst<double>(state, lit_by(GetParam(), state)), 4 * kUlp) << "state " << i;
    }
}

TEST_P(LightPoints, TakesEveryWholePower) {
    States states(9);
    for (int exponent = 0; exponent <= 130; ++exponent) {
        State state = states.make(16, false);
        for (Material<double>& material : state.materials) material.shininess = exponent;
        for (Light<double>& light : state.lights) light.spot_exponent = exponent;
        EXPECT_LE(worst<double>(state, lit_by(GetParam(), state)), 4 * kUlp) << "to the power of " << exponent;
    }
}

// The half vector or the vector to the eye is 0. Neither may give a highlight with any method for powers.
TEST_P(LightPoints, KeepsTheRulingsWhateverItsPowers) {
    State state;
    state.lights.push_back({.specular = {1, 1, 1}});
    state.materials.push_back({.specular = {1, 1, 1}, .shininess = 50});
    const auto hold = [&] {
        for (const Powers powers : {Powers::kPow, Powers::kSquaring, Powers::kTable})
            EXPECT_LE(worst<double>(state, lit_by(GetParam(), state, {.powers = powers}), 1), 4 * kUlp);
    };
    place(state.lights[0], D{0, 0, -5}, 1.0);
    state.surfaces.assign(16, {D{0, 0, -1}, D{0, 0, -1}});
    hold();
    state.model.local_viewer = true;
    place(state.lights[0], D{3, 0, 4}, 1.0);
    state.surfaces.assign(16, {D{0, 0, 0}, D{0, 0, 1}});
    hold();
}

// The rulings hold in every lane, even if the neighbouring lanes need none.
TEST_P(LightPoints, GivesWhatTheEquationGivesForTheWildest) {
    States states(2);
    for (int i = 0; i < 400; ++i) {
        const State state = states.make(37, true);
        EXPECT_LE(worst<double>(state, lit_by(GetParam(), state)), 4 * kUlp) << "state " << i;
    }
}

// A power multiplies the error of its base by the exponent, at most 128; the rest is some tens of roundings.
TEST_P(LightPoints, IsAsRightAsDoublesAre) {
    States states(3);
    for (int i = 0; i < 100; ++i) {
        const State state = states.make(20, false);
        EXPECT_LE(worst<long double>(state, lit_by(GetParam(), state), 1), 2e-13) << "state " << i;
    }
}

TEST_P(LightPoints, InFloatIsAsRightAsFloatsAre) {
    States states(4);
    for (int i = 0; i < 100; ++i) {
        State state = states.make(20, false);
        // At the border of a spot the last bit decides.
        for (Light<double>& light : state.lights) light.is_spot = light.has_smooth_cone = false;
        const double error = worst<double>(state, lit_by(GetParam(), state, {.number = Number::kFloat}), 1);
        EXPECT_LE(error, 128 * 8 * std::numeric_limits<float>::epsilon()) << "state " << i;
    }
}

// Whole exponents: each product is rounded, and a power of 128 has at most 127 products in a row.
TEST_P(LightPoints, BySquaringRoundsMore) {
    States states(5);
    double most = 0;
    for (int i = 0; i < 200; ++i) {
        State state = states.make(20, false);
        for (Material<double>& material : state.materials) material.shininess = 127;
        for (Light<double>& light : state.lights) light.spot_exponent = 3;
        most = std::max(most, worst<double>(state, lit_by(GetParam(), state, {.powers = Powers::kSquaring})));
    }
    EXPECT_LE(most, 128 * kUlp);
    EXPECT_GT(most, 4 * kUlp);  // so this really is a different method
}

// The error of linear interpolation of x^s is at most s (s - 1) / 8 times the square of the step, for a highlight of 1.
TEST_P(LightPoints, ByTableIsOffByTheChordOfItsSteps) {
    Case c;
    c.only_specular(50);
    State state{c.model, c.lights, {c.material}, {}};
    for (int i = 0; i <= 1000; ++i) {
        const double angle = i * 0.001;
        state.surfaces.push_back({{0, 0, 0}, {std::sin(angle), 0, std::cos(angle)}});
    }
    const Lit<Column> exact = lit_by(GetParam(), state), table = lit_by(GetParam(), state, {.powers = Powers::kTable});
    double most = 0;
    for (std::size_t i = 0; i < state.surfaces.size(); ++i)
        most = std::max(most, std::abs(exact.primary.x[i] - table.primary.x[i]));
    const double bound = 50 * 49 / 8.0 / (256.0 * 256.0);
    EXPECT_LE(most, bound);
    EXPECT_GT(most, bound / 2);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, LightPoints, testing::ValuesIn(instruction_sets()), [](const auto& set) {
    std::string name = set.param.name;
    std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
    return name;
});

TEST(LightPointsCount, OfAnyNumberAreEachLitAsAmongMany) {
    States states(6);
    const State many = states.make(40, false);
    const Lit<Column> all = lit_of(many);
    for (std::size_t count = 0; count <= 40; ++count) {
        State few = many;
        few.surfaces.resize(count);
        if (few.materials.size() > 1) few.materials.resize(count);
        const Lit<Column> lit = lit_of(few);
        ASSERT_EQ(lit.primary.x.size(), count);
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(lit.primary.x[i], all.primary.x[i]) << i << " of " << count;
    }
}

// Columns that held the results of other states before.
TEST(LightPointsCount, OfPlacesThatAreNoNumbersAreLitInFloatsToo) {
    State state;
    state.lights.push_back({.diffuse = {1, 1, 1}});
    state.materials.push_back({.diffuse = {1, 1, 1}});
    const double none = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    for (const D& where : {D{0, none, 1}, D{infinite, 0, none}, D{1, -infinite, 0}}) {
        state.surfaces.assign(16, {where, D{0, 0, 1}});
        EXPECT_EQ(lit_of(state, {.number = Number::kFloat}).primary.x.front(), 1);
    }
}

TEST(LightPointsCount, TakesTheMemoryOfOthers) {
    States states(8);
    Lit<Column> kept;
    for (const std::size_t count : {40, 5, 17, 3, 40}) {
        for (const bool separate : {true, false}) {
            State state = states.make(count, false);
            state.model.separate_specular = separate;
            light_points(state.model, state.lights, state.points(), {}, kept);
            EXPECT_EQ(kept.primary.z.size(), count);
            EXPECT_LE(worst<double>(state, kept), 4 * kUlp) << count << " points";
        }
    }
}

TEST(LightPointsCount, InLongDoubleIsTheEquationInLongDouble) {
    States states(7);
    const State state = states.make(5, false);
    const Lit<Column> lit = lit_of(state, {.number = Number::kLongDouble});
    EXPECT_LE(worst<long double>(state, lit), kUlp / 2);
}

// The linker must not use code compiled for wide instructions on other processors. So all visible symbols of these
// objects (except data of exceptions) must be templates over the lanes of that set, or the one function that is called
// by name.
TEST(WideInstructions, AreConfinedToTheirOwnSymbols) {
#if !defined(__x86_64__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "only for release builds on x86-64";
#endif
    if (std::system("command -v nm >/dev/null 2>&1") != 0) GTEST_SKIP() << "nm is not installed";
    for (const std::string file : {"src/lighting/points", "tests/unit/lighting/lane_results"}) {
        for (const std::string set : {"avx2", "avx512"}) {
            const ProgramResult symbols =
                run_shell("objects/" + file + "_" + set + ".o", "nm -C --defined-only --extern-only \"$PROGRAM\"");
            ASSERT_EQ(symbols.status, 0) << symbols.err;
            std::istringstream lines(symbols.out);
            int count = 0;
            for (std::string line; std::getline(lines, line); ++count)
                EXPECT_TRUE(line.find(set) != std::string::npos || line.find(" DW.ref.") != std::string::npos)
                    << file << ": " << line;
            EXPECT_GT(count, 0);
        }
    }
}

}  // namespace
}  // namespace twinlight::lighting::points_test
