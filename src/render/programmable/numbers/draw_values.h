// DrawValues: the uniforms and vertex arrays of a Draw's program, computed in double precision and rounded to float
// once.
//
// Everything that is the same at every vertex is computed here and not in the shader: unit directions, cosines, half
// vectors of directional lights, products of the material's and the lights' colours, the normal matrix.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "render/effect/plan.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/numbers/uniforms.h"

namespace twinlight::programmable {

// The uniforms of a light's smooth cone.
struct SmoothConeValues {
    double cos_outer = 0, slope = 0;  // slope: 1 / (cos inner - cos outer)
};
SmoothConeValues smooth_cone_values(const LightSource& light);

// The nearest float; what is too large for one becomes the largest.
inline float to_float(double x) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x, -kLargest, kLargest));
}

// An exponent for a shader, whose processor may take denormal floats for 0: 0^0 is 1, but 0^1e-40 is 0.
inline double normal_exponent(double exponent) {
    constexpr double kSmallest = std::numeric_limits<float>::min();
    return exponent > 0 && exponent < kSmallest ? kSmallest : exponent;
}

// All uniforms of the program made from this code, except the texture's sampler.
Uniforms uniforms(const Draw& draw, const Plan& plan, const Code& code);

// The program of a Draw and its uniforms: the one of --precise if requested and if floats suffice, else the ordinary
// one.
struct DrawProgram {
    Code code;
    Uniforms numbers;
    // Which of the numbers other Draws with the same state may have too.
    struct OfState {
        std::size_t colors = 0, lights = 0;  // the first of each; after the lights there are no others
        double unit = 1;                     // of lengths
    };
    OfState of_state{};
};
// like: null, or the program of a Draw whose plan differs at most in the vertices' facts. Then what both share is not computed again.
DrawProgram draw_program(const Draw& draw, const Plan& plan, bool precise, const DrawProgram* like = nullptr);

// The vertex attributes, one vertex after the other, in the order of attributes(effects). Positions are relative to
// `origin_object`: Code::origin_object, or 0.
std::vector<float> vertex_array(const Draw& draw, const EffectSet& effects, const std::vector<std::uint32_t>& vertices,
                                const glm::dvec3& origin_object);

}  // namespace twinlight::programmable
