// The meshes and the states of light that the stages are measured with.
#pragma once

#include <string>
#include <vector>

#include "scene/frame/frame.h"

namespace twinlight::bench {

// The indices of a sphere's triangles by rows from pole to pole, as one writes them down.
Draw sphere(int slices, int stacks);

// The same state on a dome that fills a picture of side x side pixels with few triangles: fragments are nearly all that it
// costs. Without a depth test: nothing hides anything.
Draw on_dome(Draw draw, int side);

struct LitScene {
    std::string name;
    Draw draw;
};

// The seven states of docs/performance.md, on one mesh.
std::vector<LitScene> seven_scenes(const Draw& mesh = sphere(512, 256));
// Highlights that are black, though the shininess is set; lights that are on, though they give nothing.
std::vector<LitScene> idle_scenes(const Draw& mesh = sphere(512, 256));

Frame frame_of(const Draw& draw, int side = 64);

}  // namespace twinlight::bench
