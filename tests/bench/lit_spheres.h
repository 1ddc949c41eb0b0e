// The mesh and the states of light that the vertex stage is measured with.
#pragma once

#include <string>
#include <vector>

#include "state/frame.h"

namespace twinlight::bench {

// The indices of a sphere's triangles by rows from pole to pole, as one writes them down.
Draw sphere(int slices, int stacks);

struct LitScene {
    std::string name;
    Draw draw;
};

// The seven states of docs/performance.md, on the same sphere: 512 x 256.
std::vector<LitScene> seven_scenes();
// All highlights black but the shininess set; one light of eight that gives anything.
std::vector<LitScene> idle_scenes();

// A picture of that one Draw. A viewport of one pixel leaves hardly anything to rasterise: the vertex stage is measured.
Frame frame_of(const Draw& draw);

}  // namespace twinlight::bench
