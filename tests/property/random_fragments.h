// Random states of what happens to fragments, as a scene's text, from a seed: textures, environments, fog, blending,
// tests, masks, clip planes, offsets, widths. The same seed gives the same text on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "state/frame.h"

namespace twinlight {

// Seeds k * kFragmentStatesPerStructure ... + kFragmentStatesPerStructure - 1 share what the driver compiles for (formats,
// filters, functions, modes) and differ in the numbers.
inline constexpr std::uint64_t kFragmentStatesPerStructure = 3;

// One or two batches of a dozen vertices in a perspective view. Every number is of moderate size.
std::string random_fragments(std::uint64_t seed);

// Where a driver is known to leave the text: names of golden/known_differences.
struct FragmentDeparture {
    std::string_view name;
    bool (*applies)(const Draw& draw);
};
const std::vector<FragmentDeparture>& fragment_departures();

}  // namespace twinlight
