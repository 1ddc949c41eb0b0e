// The result of comparing a random scene, by vertex colours in floats or by pictures.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "judge/compare/departures.h"

namespace twinlight::fuzz {

enum class RendererPair : std::uint8_t { kFixedProgrammable, kFixedReference, kProgrammableReference };
inline constexpr std::size_t kPairs = 3;
inline constexpr std::array<std::string_view, kPairs> kPairNames = {"fixed ~ shaders", "fixed ~ reference",
                                                                    "shaders ~ reference"};

inline bool has_fixed(std::size_t pair) {
    return pair != static_cast<std::size_t>(RendererPair::kProgrammableReference);
}

// One pair of renderers: vertices, or judged pixels.
struct PairDifferences {
    long compared = 0;
    long differing = 0;  // pixels that differ by more than the allowed difference
    // Floats: relative to the sum of the terms' magnitudes; pictures: 1/255 beyond the allowed difference.
    double worst = 0;
    bool fails = false;
    bool only_one_draws = false;  // the failure: only one of the two draws the vertex
    std::string what;             // the failure: where, and by how much
};

// How often a vertex or picture was skipped for a known bug, and how often it did differ.
struct LeftOutCount {
    long cases = 0, differing = 0;
};
using LeftOutCounts = std::map<const compare::Departure*, LeftOutCount>;

struct StateDifferences {
    std::array<PairDifferences, kPairs> pairs;
    LeftOutCounts left_out;  // of vertices, or of pictures
    std::string error;       // why GL or a renderer rejects the scene: a bug of the generator

    bool fails() const { return !error.empty() || pairs[0].fails || pairs[1].fails || pairs[2].fails; }
};

}  // namespace twinlight::fuzz
