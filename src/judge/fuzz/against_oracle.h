// Judges random scenes at the limits of floats by the oracle (judge/oracle): the reference with all its number types, and the shaders
// with all their tiers and shadings.
//
// The bar, relative to the larger of 1 and the sum of the terms' magnitudes: 1e-12 for doubles, 3e-5 for floats. A colour may miss
// it only for a reason that has a name here. Each name is counted.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "judge/fuzz/run.h"

namespace twinlight::fuzz {

struct OracleOptions : RunOptions {
    // Shaders with constants are compiled for each scene, which takes much longer than all else. So only one of this many scenes has
    // them.
    std::uint64_t baked_every = 16;
    bool reference = true, shaders = true;  // who is judged
    double strictness = 1;                  // divides what may differ, for tests of what a failure gives
};

CommandList extreme_scene(std::uint64_t seed, std::uint64_t state);

inline constexpr const char* kRight = "right";

// What was found for the reference with one number type, or for one kind of shaders. A count is of colours: of one face of one
// vertex.
struct OracleCounts {
    std::map<std::string, long> verdicts;  // kRight, and each reason
    // The ill-conditioned ones, by the power of ten of the condition number: how far the exact colour moves, relative to the larger
    // of 1 and the terms' sum, divided by the relative change of the inputs. At least so: the search ends when a move explains the
    // difference.
    std::map<int, long> conditions;
    double worst_right = 0;

    long compared() const;
};

struct OracleFailure : Finding {
    std::string who;  // a key of OracleSummary::counts
};
// The scene as text; a comment says how to repeat it and what differs.
std::string failure_text(const OracleFailure& failure, std::uint64_t seed);

struct OracleSummary {
    std::uint64_t states = 0;
    std::uint64_t out_of_view = 0;  // their coordinates overflow, so that no renderer shows the vertex
    bool broken_off = false;
    std::string driver;
    std::map<std::string, OracleCounts> counts;  // by "reference, double" or "shaders, uniform"
    std::vector<OracleFailure> failures;
};

using OracleProgress = RunProgress<OracleSummary, OracleFailure>;

OracleSummary run_against_oracle(const OracleOptions& options, const OracleProgress& progress = {});

}  // namespace twinlight::fuzz
