// Compares random scenes across the three renderers, by vertex colours in floats and by small pictures
// (docs/testing.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "judge/fuzz/differences.h"
#include "judge/fuzz/run.h"

namespace twinlight::fuzz {

struct Options : RunOptions {
    bool floats = true, pictures = true;
    // A known bug that is not skipped. Every scene is then likely to show it.
    std::string lifted{};
};

// One of kPictureEvery scenes is compared as a picture, the others by vertex colours.
inline constexpr std::uint64_t kPictureEvery = 32;
// Scenes that share a structure follow one another.
inline constexpr std::uint64_t kStatesPerStructure = 512;
inline constexpr std::uint64_t kPicturesPerStructure = 8;

bool is_picture(std::uint64_t state);
CommandList random_scene(const Options& options, std::uint64_t state);

struct Failure : Finding {
    bool is_picture = false;
    std::size_t pair = 0;  // index into kPairNames; kPairs where the scene is rejected
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

using Progress = RunProgress<Summary, Failure>;

Summary run(const Options& options, const Progress& progress);

}  // namespace twinlight::fuzz
