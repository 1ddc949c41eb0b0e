// MesaFloats: the floats that Mesa 22.3.6 computes from GL's state before its vertex program runs, in Mesa's order of
// operations. --precise gives its shaders these numbers, so that they start from the driver's own floats.
//
// Loaded matrices are reproduced exactly. Matrices multiplied by glRotate and similar commands are not: the driver
// multiplies them in floats, and a Frame has doubles (docs/architecture.md).
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/frame/frame.h"

namespace twinlight::programmable {

// The product of the projection and the modelview matrix (math/m_matrix.c, matmul4).
glm::mat4 mesa_product(const glm::mat4& a, const glm::mat4& b);

struct MesaMatrix {
    glm::mat3 inverse{1};       // the upper 3x3 of the inverse
    bool keeps_lengths = true;  // only rotates and translates, within about 1e-6
};

// The matrix's kind and its inverse, computed as Mesa inverts that kind (math/m_matrix.c, analyse_from_scratch and
// invert_matrix_*). The inverse of a singular matrix is the identity.
MesaMatrix mesa_matrix(const glm::mat4& matrix);

// GL_RESCALE_NORMAL's factor in eye coordinates (main/light.c, update_modelview_scale; GL 2.1, section 2.11.3).
float mesa_normal_scale(const MesaMatrix& modelview);

// Whether the driver lights in eye coordinates; if not, in object coordinates (main/light.c, _mesa_update_lighting and
// _mesa_update_tnl_spaces).
bool mesa_lights_in_eye_space(const LightingState& lighting, const MesaMatrix& modelview);

// A light in the space where the driver lights (main/light.c, compute_light_positions; program/prog_statevars.c).
struct MesaLight {
    glm::vec3 position{0};  // divided by w; if w is 0, the direction with length 1
    glm::vec3 half_dir{0};  // h_i for a directional light and a viewer at infinity
    glm::vec3 spot_direction{0};
    float spot_cutoff_cosine = 0;
};
MesaLight mesa_light(const LightSource& light, const glm::mat4& modelview, const MesaMatrix& facts, bool eye_space);

}  // namespace twinlight::programmable
