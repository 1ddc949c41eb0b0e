// Random scenes, three ways: at float precision and as small pictures (docs/testing.md).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "judge/fuzz/differences.h"

namespace twinlight::fuzz {

// State i of a seed is the same scene whatever else is asked for.
struct Options {
    std::uint64_t count = 1000;
    std::uint64_t seed = 1;
    std::uint64_t first = 0;  // the first state
    bool floats = true, pictures = true;
    // A departure that is not left out; then every scene is likely to show it.
    std::string lifted{};
    std::size_t most_failures = 10;
    bool shrinks = true;
};

// One in kPictureEvery states is drawn as a picture, the others are compared at float precision.
inline constexpr std::uint64_t kPictureEvery = 32;
// States that share a structure follow one another.
inline constexpr std::uint64_t kStatesPerStructure = 512;
inline constexpr std::uint64_t kPicturesPerStructure = 8;

bool is_picture(std::uint64_t state);
CommandList random_scene(const Options& options, std::uint64_t state);

struct Failure {
    std::uint64_t state = 0;
    bool is_picture = false;
    std::size_t pair = 0;  // of kPairNames; kPairs where a scene is refused
    std::string what;      // of the smallest scene
    CommandList scene;     // the smallest
    std::string driver;
    std::size_t commands_before = 0;
};
// The scene with a comment that says where it comes from and what differs.
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

    // Beyond the share of pixels that may differ by one code (compare::Tolerance): a failure of all pictures together.
    bool too_many_differ(std::size_t pair) const;
    bool fails() const;
};

struct Progress {
    // Called often; done of count states, and what is being done where that is not comparing.
    std::function<void(std::uint64_t done, const Summary& so_far, const char* doing)> show = {};
    // Whether to stop: what is found until then is kept.
    std::function<bool()> stop = [] { return false; };
    // Called with each failure.
    std::function<void(const Failure&)> found = {};
};

Summary run(const Options& options, const Progress& progress);

}  // namespace twinlight::fuzz
