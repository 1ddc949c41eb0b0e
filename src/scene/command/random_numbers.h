// The numbers that rand() gives on Linux, so that a program which is read draws what it draws when it runs there.
#pragma once

#include <array>
#include <cstdint>

namespace twinlight {

// glibc's random(), TYPE_3: x_i = x_(i-3) + x_(i-31) modulo 2^32; the lowest bit is not given. Without srand() the seed is 1.
class RandomNumbers {
  public:
    RandomNumbers() { seed(1); }

    void seed(std::uint32_t seed) {
        constexpr int kUnused = 310;
        std::int64_t word = seed == 0 ? 1 : static_cast<std::int32_t>(seed);
        for (std::uint32_t& x : state_) {
            x = static_cast<std::uint32_t>(word);
            word = 16807 * word % 2147483647;
            if (word < 0) word += 2147483647;
        }
        at_ = 3;
        for (int i = 0; i < kUnused; ++i) next();
    }
    // From 0 to RAND_MAX, which is 2147483647.
    std::int64_t next() {
        const std::size_t size = state_.size();
        state_[at_] += state_[(at_ + size - 3) % size];  // so far it is x_(i-31)
        const std::uint32_t given = state_[at_] >> 1;
        at_ = (at_ + 1) % size;
        return given;
    }

  private:
    std::array<std::uint32_t, 31> state_{};
    std::size_t at_ = 0;
};

}  // namespace twinlight
