// Random lighting states as commands, from a seed; the same seed gives the same commands on every machine.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "command/command.h"
#include "state/frame.h"

namespace twinlight {

// xorshift64*: Vigna, "An experimental exploration of Marsaglia's xorshift generators, scrambled" (2016).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 0x2545F4914F6CDD1DULL) {
        for (int i = 0; i < 4; ++i) next();
    }
    double uniform(double low, double high) { return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53; }
    int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
    bool chance(double probability) { return uniform(0, 1) < probability; }

  private:
    std::uint64_t next() {
        state_ ^= state_ >> 12;
        state_ ^= state_ << 25;
        state_ ^= state_ >> 27;
        return state_ * 0x2545F4914F6CDD1DULL;
    }
    std::uint64_t state_;
};

// A scene of `triangles` small triangles under random lights, materials, light model, colour material, matrices and
// normals: everything that the equation of 2.14.1 reads. No hard cases: values of moderate size, no coordinate at 0.
// Seeds k * kStatesPerStructure ... + kStatesPerStructure - 1 share what decides the driver's program (which lights, of
// which type, ...) and differ in the values, since a program takes a driver a tenth of a second to make.
inline constexpr std::uint64_t kStatesPerStructure = 100;
CommandList random_state(std::uint64_t seed, int triangles);

// A state in which the driver is known to leave the specification's text (golden/known_differences), or in which
// the equation is discontinuous at a vertex, so that rounding alone decides. Such vertices are left out by this name.
struct Exclusion {
    std::string_view name;
    std::string_view section;  // what it departs from, or why it is left out
    bool departure;            // of the driver; else a jump of the equation itself
    std::function<bool(const Draw& draw, const Vertex& vertex)> applies;
};
const std::vector<Exclusion>& exclusions();

// Whether the current context's driver is the one on which golden/known_differences was measured. It must show every
// departure of that list; another driver may have mended some.
bool is_listed_driver();

}  // namespace twinlight
