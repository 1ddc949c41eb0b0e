// The matrix that transforms normals (GL 2.1, section 2.11.3), if the modelview matrix has one.
#pragma once

#include <glm/mat3x3.hpp>

namespace twinlight {

// RULING: whether a modelview matrix flattens space, so that it has no inverse. The determinant of a product of rotations and
// glScalef(1, 0, 1), or of a shadow's matrix given in floats, is rarely exactly 0. So the rank decides, for numbers of 21 bits: a
// float has 24, and a few are lost in making such a matrix. Rows and columns are scaled to size 1 first, because glScale with
// tiny factors loses no digits.
bool is_singular(const glm::dmat3& eye_from_object);

// The transposed inverse. 0 if the matrix is singular.
glm::dmat3 normal_matrix(const glm::dmat3& eye_from_object);

}  // namespace twinlight
