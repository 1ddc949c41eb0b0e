// Random scenes, in all the ways that commands have to say them.
#pragma once

#include <cstdint>
#include <string_view>

#include "judge/fuzz/random.h"
#include "scene/command/command.h"

namespace twinlight::fuzz {

// What one random scene comes from. Scenes of one structure share what the driver makes a program for (which lights, of
// which type, ...) and differ in their values, since a program takes a driver a tenth of a second to make.
struct Seed {
    std::uint64_t structure = 0;
    std::uint64_t values = 0;
    // A departure of compare::departures(): the scene is likely to show it. Else one in ten structures is about any of them.
    std::string_view departure{};
};

// What the scene is about; empty: nothing.
std::string_view departure_of(const Seed& seed, Random& structure);

// Everything that the equation of 2.14.1 reads: one primitive with three vertices, which stand in different corners of the view;
// random lights, materials, light model, colour material, matrices, normals and colours. Values of moderate size, no coordinate
// at 0, but where the scene is about a departure.
CommandList lighting_state(const Seed& seed);

// What happens between vertices and pixels: a few batches in a perspective view; random primitives, textures, environments,
// fog, blending, tests, masks, clip planes, offsets, widths. Every number is of moderate size.
CommandList fragment_state(const Seed& seed);

// The same scene, said otherwise: display lists, vertex arrays, attribute stacks and matrix stacks, where none of them may
// change the picture.
CommandList disguised(const CommandList& scene, Random& random);

}  // namespace twinlight::fuzz
