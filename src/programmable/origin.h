// Draws whose object and camera are far from the object's origin: floats cannot hold both the vertices' coordinates and their
// distance from the eye, so vertices are made relative to one of them, in double, ahead of the upload.
#pragma once

#include <optional>

#include "state/frame.h"

namespace twinlight::programmable {

// Whether the first vertex's eye coordinates are what is left of numbers that cancel.
bool is_far_from_origin(const Draw& draw);

// The same Draw with the first vertex's place for its origin, where it is far from its own; else nothing.
std::optional<Draw> moved_to_origin(const Draw& draw);

}  // namespace twinlight::programmable
