// Work on the CPU alone, the same at every run: what it costs is counted in instructions. Functions of C, so that
// callgrind finds them by name.
#pragma once

#include <cstddef>

namespace twinlight::counted {

// Each gives back a number that the work comes to, so that it is known to be done.
extern "C" {
std::size_t counted_read();       // the built-in scenes, from text
std::size_t counted_state();      // State on the commands of a recorded program
std::size_t counted_plan();       // plan_effects on the Draws of the built-in scenes
std::size_t counted_reference();  // the reference's lighting of a sphere by three lights
std::size_t counted_patches();    // a sphere's triangles in patches
}

// Makes what they work on, which is not counted.
void prepare();
void prepare_plans();  // before counted_plan()

}  // namespace twinlight::counted
