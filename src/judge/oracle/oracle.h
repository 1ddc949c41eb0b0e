// The oracle: the lit colours of vertices by the text of GL 2.1, sections 2.11 and 2.14, evaluated from the commands on in 60
// decimal digits with an exponent of 32 bits, so that nothing rounds, overflows or underflows where it matters.
//
// It judges everything else that lights a vertex. So it shares only the reader of commands with the rest: it has its own
// matrices, its own state and its own equation. Where the specification is silent it follows the rulings of
// docs/hard-cases.md.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/command/command.h"

namespace twinlight::oracle {

// Where a comparison of 2.14.1 is within `width` of equality, rounding decides it: PV . s and cos(cutoff), n . VP and 0.
enum class Border : std::uint8_t {
    kExact,    // the comparison in all digits
    kInside,   // counts as inside the cone, and as lit from the front; lights are as near as value_rounding allows
    kOutside,  // counts as outside, and as lit from behind; lights are as far away
};

// How an evaluation may differ from the exact one. It shows how much a result depends on rounding.
struct Options {
    Border border = Border::kExact;
    double width = 0;  // cosines this near count as equal, relative to the lengths of the vectors
    // Relative errors, with random signs: of matrices where they are multiplied; and of each value that a shader gets or stores as a float (matrices, lights' positions, eye coordinates, normals, attenuation factors).
    double matrix_rounding = 0, value_rounding = 0;
    std::uint64_t seed = 0;     // of the signs
    bool unit_normals = false;  // as with GL_NORMALIZE, which lighting per pixel implies

    friend bool operator==(const Options&, const Options&) = default;
};

// The colours of one face of a vertex, before the clamp of 2.14.6. The largest double where they are beyond it.
struct Colors {
    std::array<double, 4> primary{};
    std::array<double, 3> secondary{};
    std::array<double, 3> primary_rest{}, secondary_rest{};  // what the doubles above lack of 32 digits
    std::array<double, 3> magnitude{};                       // the sum of the magnitudes of the terms of both colours
};

struct Vertex {
    Colors front, back;  // back: only with GL_LIGHT_MODEL_TWO_SIDE
    std::array<double, 4> position_eye{};
    // The least distance to a positional light that is not exactly here, relative to the vertex's distance from the eye.
    double closest_light = HUGE_VAL;
    double shortest_half_vector = 2;  // the least length of VP + VPe of all lights
    // The sum of the magnitudes of the terms whose spot_i or (n . h_i)^s_rm is a denormal float. Attenuation may make them large.
    double of_denormal_powers = 0;
};

// The vertices after the last glBegin, in order. Throws std::invalid_argument for a command that it does not know.
std::vector<Vertex> light(const CommandList& commands, const Options& options = {});

}  // namespace twinlight::oracle
