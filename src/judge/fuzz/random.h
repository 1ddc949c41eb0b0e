// Random numbers that are the same on every machine.
#pragma once

#include <cstdint>
#include <random>

namespace twinlight::fuzz {

// The standard defines the bits of the engine (rand.predef), but not those of its distributions, so numbers are made
// from bits here.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low, double high) { return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53; }
    int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    std::uint64_t next() { return engine_(); }

  private:
    std::mt19937_64 engine_;
};

}  // namespace twinlight::fuzz
