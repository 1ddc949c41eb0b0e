// Judges random scenes at the limits of floats by the oracle (judge/oracle): the reference with all its number types, and the shaders
// with all their tiers and shadings.
//
// The bar, relative to the larger of 1 and the sum of the terms' magnitudes: 1e-12 for doubles, 3e-5 for floats. A colour may miss
// it only for a reason that has a name here. Each name is counted.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scene/command/command.h"

namespace twinlight::fuzz {

// Scene i of a seed is always the same.
struct OracleOptions {
    std::uint64_t count = 1000;
    std::uint64_t seed = 1;
    std::uint64_t first = 0;  // number of the first scene
    std::size_t most_failures = 10;
    bool shrinks = true;
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
    double worst_right = 0;

    long compared() const;
};

struct OracleFailure {
    std::uint64_t state = 0;
    std::string who;    // a key of OracleSummary::counts
    std::string what;   // the difference in the smallest scene
    CommandList scene;  // the smallest scene that fails
    std::string driver;
    std::size_t commands_before = 0;
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

struct OracleProgress {
    // Called often, with the number of scenes done. `doing` is another activity than comparing, or null.
    std::function<void(std::uint64_t done, const OracleSummary& so_far, const char* doing)> show = {};
    std::function<bool()> stop = [] { return false; };  // true ends the run; it keeps the failures found so far
    std::function<void(const OracleFailure&)> found = {};
};

OracleSummary run_against_oracle(const OracleOptions& options, const OracleProgress& progress = {});

}  // namespace twinlight::fuzz
