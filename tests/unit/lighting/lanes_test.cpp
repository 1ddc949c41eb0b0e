// Lanes give what plain numbers give, for numbers at the limits too: with every instruction set of this processor, and
// with any version of xsimd.
#include "lighting/lanes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "lane_results.h"

namespace twinlight::lighting::lanes_test {
namespace {

using LaneFunction = LaneCounts (*)(const LaneArrays& arrays);
LaneFunction lane_function(std::string_view set, bool is_float) {
#if defined(__x86_64__)
    if (set == "AVX-512") return is_float ? float_lanes_avx512 : double_lanes_avx512;
    if (set == "AVX2") return is_float ? float_lanes_avx2 : double_lanes_avx2;
#endif
    return is_float ? lane_results<float, xsimd::default_arch> : lane_results<double, xsimd::default_arch>;
}

// Zeros, denormal numbers, the limits of squares, the largest numbers, infinity and NaN, of both signs; and usual ones.
template <class Scalar>
std::vector<double> special_numbers() {
    using L = std::numeric_limits<Scalar>;
    std::vector<double> numbers{std::numeric_limits<double>::quiet_NaN()};
    for (const Scalar x : {Scalar(0), L::denorm_min(), L::min() / 2, L::min(), Limits<Scalar>::small, Scalar(0.3),
                           Scalar(1), 1 + L::epsilon(), Scalar(2.5), Limits<Scalar>::big, L::max(), L::infinity()}) {
        numbers.push_back(static_cast<double>(x));
        numbers.push_back(static_cast<double>(-x));
    }
    return numbers;
}

struct Inputs {
    std::vector<double> a, b, c;
    void add(double x, double y, double z) {
        a.push_back(x);
        b.push_back(y);
        c.push_back(z);
    }
};

// All pairs; and each number in each lane, among ones.
template <class Scalar>
Inputs inputs() {
    Inputs in;
    const std::vector<double> numbers = special_numbers<Scalar>();
    for (const double x : numbers)
        for (const double y : numbers) in.add(x, y, numbers[in.a.size() * 7 % numbers.size()]);
    while (in.a.size() % kMostLanesOfAny != 0) in.add(1, 1, 1);
    for (const double x : numbers)
        for (std::size_t special = 0; special < kMostLanesOfAny; ++special)
            for (std::size_t lane = 0; lane < kMostLanesOfAny; ++lane) in.add(lane == special ? x : 1, 1, 1);
    return in;
}

template <class Scalar>
bool is_same(Scalar a, Scalar b, int most) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    if (most == 0 || std::isinf(a) || std::isinf(b)) return a == b && std::signbit(a) == std::signbit(b);
    const Scalar ulp = std::numeric_limits<Scalar>::epsilon() * std::abs(b) + std::numeric_limits<Scalar>::denorm_min();
    return std::abs(a - b) <= static_cast<Scalar>(most) * ulp;
}

// The failures of each property, of which the first is printed.
class Failures {
  public:
    explicit Failures(std::string where) : where_(std::move(where)) {}
    void add(std::size_t property, const std::string& text) {
        if (property >= counts_.size()) {
            counts_.resize(property + 1);
            firsts_.resize(property + 1);
        }
        if (counts_[property]++ == 0) firsts_[property] = text;
    }
    void report() const {
        for (std::size_t i = 0; i < counts_.size(); ++i)
            if (counts_[i] > 0)
                ADD_FAILURE() << where_ << ": " << firsts_[i] << fmt::format(" ({} such cases)", counts_[i]);
    }

  private:
    std::string where_;
    std::vector<int> counts_;
    std::vector<std::string> firsts_;
};

template <class Scalar>
void compare_lanes(const std::string& set) {
    const bool is_float = std::is_same_v<Scalar, float>;
    const Inputs in = inputs<Scalar>();
    const std::size_t count = in.a.size();
    constexpr std::size_t kMostProperties = 64;
    std::vector<double> results(count * kMostProperties);
    const LaneCounts counts =
        lane_function(set, is_float)({in.a.data(), in.b.data(), in.c.data(), count, results.data()});
    ASSERT_LE(counts.properties, kMostProperties);
    Failures failures(fmt::format("{}, {}s", set, is_float ? "float" : "double"));
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = static_cast<Scalar>(in.a[i]), b = static_cast<Scalar>(in.b[i]), c = static_cast<Scalar>(in.c[i]);
        std::size_t property = 0;
        const auto hold = [&](const char* name, Scalar right, int most = 0) {
            const auto given = static_cast<Scalar>(results[property * count + i]);
            if (!is_same(given, right, most))
                failures.add(property, fmt::format("{} is {}, but must be {}, where a is {}, b is {} and c is {}", name,
                                                   given, right, a, b, c));
            ++property;
        };
        for_each_guarded_property(a, b, c, hold);
        if (counts.has_fused)
            for_each_unguarded_property<true>(a, b, c, hold);
        else
            for_each_unguarded_property<false>(a, b, c, hold);
        bool all_finite = true;
        for (std::size_t lane = 0; lane < counts.lanes; ++lane)
            all_finite = all_finite && std::isfinite(in.a[i / counts.lanes * counts.lanes + lane]);
        hold("whether all lanes are finite", Scalar(all_finite ? 1 : 0));
        ASSERT_EQ(property, counts.properties);
    }
    failures.report();
}

class LaneProperties : public testing::TestWithParam<InstructionSet> {};

TEST_P(LaneProperties, OfDoublesAreThoseOfPlainNumbers) { compare_lanes<double>(GetParam().name); }
TEST_P(LaneProperties, OfFloatsAreThoseOfPlainNumbers) { compare_lanes<float>(GetParam().name); }

INSTANTIATE_TEST_SUITE_P(InstructionSets, LaneProperties, testing::ValuesIn(instruction_sets()), [](const auto& set) {
    std::string name = set.param.name;
    std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
    return name;
});

}  // namespace
}  // namespace twinlight::lighting::lanes_test
