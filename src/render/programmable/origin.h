// Draws whose object and camera are far from the object's origin: floats cannot hold both the vertices' coordinates and their
// distance from the eye, so vertices are uploaded relative to a place among them, subtracted in double.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "render/effect/vertex_facts.h"
#include "scene/state/frame.h"

namespace twinlight::programmable {

// That place, in object coordinates; nothing where vertices stay as they are. `facts` are the Draw's.
std::optional<glm::dvec3> upload_origin(const Draw& draw, const VertexFacts& facts);

}  // namespace twinlight::programmable
