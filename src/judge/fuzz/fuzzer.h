// Compares random scenes across the three renderers, by vertex colours in floats and by small pictures
// (docs/testing.md).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "judge/fuzz/differences.h"

namespace twinlight::fuzz {

// Scene i of a seed is always the same; the other options do not change it. Scenes are called states here.
struct Options {
    std::uint64_t count = 1000;
    std::uint64_t seed = 1;
    std::uint64_t first = 0;  // number of the first scene
    bool floats = true, pictures = true;
    // A known bug that is not skipped. Every scene is then likely to show it.
    std::string lifted{};
    std::size_t most_failures = 10;
    bool shrinks = true;
};

// One of kPictureEvery scenes is compared as a picture, the others by vertex colours.
inline constexpr std::uint64_t kPictureEvery = 32;
// Scenes that share a structure follow one another.
inline constexpr std::uint64_t kStatesPerStructure = 512;
inline constexpr std::uint64_t kPicturesPerStructure = 8;

bool is_picture(std::uint64_t state);
CommandList random_scene(const Options& options, std::uint64_t state);

struct Failure {
    std::uint64_t state = 0;
    bool is_picture = false;
    std::size_t pair = 0;  // index into kPairNames; kPairs where the scene is rejected
    std::string what;      // the difference in the smallest scene
    CommandList scene;     // the smallest scene that fails
    std::string driver;
    std::size_t commands_before = 0;
};
// The scene as text; a comment says how to repeat it and what differs.
std::string failure_text(const Failure& failure, const Options& options);

struct Worst {
    double value = 0;
    std::uint64_t state = 0;
};

struct Summary {
    std::uint64_t float_states = 0, picture_states = 0;
    bool broken_off = false;
    std::string driver;
    std::array<long, kPairs> vertices{}, pixels{}, differing_pixels{};
    std::array<Worst, kPairs> worst_float, worst_picture;
    LeftOutCounts vertices_left_out, pictures_left_out;
    std::vector<Failure> failures;

    // More pixels differ by 1/255 than may (compare::Tolerance), counted over all pictures.
    bool too_many_differ(std::size_t pair) const;
    bool fails() const;
};

struct Progress {
    // Called often, with the number of scenes done. `doing` is another activity than comparing, or null.
    std::function<void(std::uint64_t done, const Summary& so_far, const char* doing)> show = {};
    // True ends the run; it keeps the failures found so far.
    std::function<bool()> stop = [] { return false; };
    // Called with each failure.
    std::function<void(const Failure&)> found = {};
};

Summary run(const Options& options, const Progress& progress);

}  // namespace twinlight::fuzz
