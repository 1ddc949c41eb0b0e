// What runs with either judge have in common: the other renderers (fuzzer.h), or the oracle (against_oracle.h).
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "scene/command/command.h"

namespace twinlight::fuzz {

// Scene i of a seed is always the same; the other options do not change it. Scenes are called states here.
struct RunOptions {
    std::uint64_t count = 1000;
    std::uint64_t seed = 1;
    std::uint64_t first = 0;         // number of the first scene
    std::size_t most_failures = 10;  // then the run stops
    bool shrinks = true;             // the first kMostShrunk failures

    bool shrinks_after(std::size_t failures) const { return shrinks && failures < kMostShrunk; }
    static constexpr std::size_t kMostShrunk = 10;  // to shrink one takes as long as thousands of states
};

struct Finding {
    std::uint64_t state = 0;
    std::string what;   // the difference in the smallest scene
    CommandList scene;  // the smallest scene that fails
    std::string driver;
    std::size_t commands_before = 0;
};

template <class Summary, class Failure>
struct RunProgress {
    // Called often, with the number of scenes done. `doing` is another activity than comparing, or null.
    std::function<void(std::uint64_t done, const Summary& so_far, const char* doing)> show = {};
    // True ends the run; it keeps the failures found so far.
    std::function<bool()> stop = [] { return false; };
    // Called with each failure.
    std::function<void(const Failure&)> found = {};
};

}  // namespace twinlight::fuzz
