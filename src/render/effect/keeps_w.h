#pragma once

#include <glm/mat4x4.hpp>

namespace twinlight {

// Whether what the matrix takes has the w that it had: its last row is 0, 0, 0, 1.
inline bool keeps_w(const glm::dmat4& m) { return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1; }

}  // namespace twinlight
