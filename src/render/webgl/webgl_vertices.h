// The vertices of a Part that has its own.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/webgl/webgl_lines.h"

namespace twinlight::webgl {

// For each vertex the values of programmable::attributes(), then those of programmable::line_attributes().
std::vector<float> vertex_values(const Part& part, const Draw& draw, const EffectSet& effects,
                                 const glm::dvec3& origin_object);

}  // namespace twinlight::webgl
