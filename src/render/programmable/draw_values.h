// DrawValues: the numbers that a Draw's program takes, worked out in double precision and rounded to float once.
//
// Whatever is the same at every vertex is done here and not in the shader: unit directions, cosines, half
// vectors of directional lights, the products of the material's and the lights' colours, the matrix of the normals.
#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "render/effect/plan.h"
#include "render/programmable/form.h"

namespace twinlight::programmable {

// By the uniform's name: its floats, matrices by columns, the elements of an array one after the other.
using Uniforms = std::map<std::string, std::vector<float>, std::less<>>;

// The nearest float; what is too large for one becomes its largest.
inline float to_float(double x) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x, -kLargest, kLargest));
}

// Every uniform that the program made from this code has, but for the texture's sampler.
Uniforms uniforms(const Draw& draw, const Plan& plan, const Code& code);

// What a Draw is drawn with: the program of --precise where that is asked for and its floats suffice, else the ordinary one.
struct DrawProgram {
    Code code;
    Uniforms numbers;
};
DrawProgram draw_program(const Draw& draw, const Plan& plan, bool precise);

// The attributes of the vertices, one vertex after the other, as attributes(effects) lists them; positions are relative to
// `origin_object`: the Code's, or 0.
std::vector<float> vertex_array(const Draw& draw, const EffectSet& effects, const std::vector<std::uint32_t>& vertices,
                                const glm::dvec3& origin_object);

}  // namespace twinlight::programmable
