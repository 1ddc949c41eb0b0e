// What a comparison of random states finds, at float precision or as pictures.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "judge/compare/departures.h"

namespace twinlight::fuzz {

enum class RendererPair : std::uint8_t { kFixedProgrammable, kFixedReference, kProgrammableReference };
inline constexpr std::size_t kPairs = 3;
inline constexpr std::array<std::string_view, kPairs> kPairNames = {"fixed ~ programmable", "fixed ~ reference",
                                                                    "programmable ~ reference"};

inline bool has_fixed(std::size_t pair) {
    return pair != static_cast<std::size_t>(RendererPair::kProgrammableReference);
}

// Of one pair: vertices, or interior pixels.
struct PairDifferences {
    long compared = 0;
    long differing = 0;  // pixels of another code
    double worst = 0;    // floats: of the terms' magnitude; pictures: codes beyond the allowed difference
    bool fails = false;
    bool misses = false;  // the failure is that only one of the two shows anything
    std::string what;     // of a failure: where, and how much
};

// How often a departure was left out, and how often it showed.
struct LeftOutCount {
    long cases = 0, differing = 0;
};
using LeftOutCounts = std::map<const compare::Departure*, LeftOutCount>;

struct StateDifferences {
    std::array<PairDifferences, kPairs> pairs;
    LeftOutCounts left_out;  // vertices, or pictures
    std::string error;       // of a scene that GL or a renderer refuses: the generator's mistake

    bool fails() const { return !error.empty() || pairs[0].fails || pairs[1].fails || pairs[2].fails; }
};

}  // namespace twinlight::fuzz
