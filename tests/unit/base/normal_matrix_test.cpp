#include "base/math/normal_matrix.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <random>

namespace twinlight::normal_matrix_test {
namespace {

using Digits = boost::multiprecision::cpp_bin_float_50;

// The transposed inverse, by cofactors in 50 digits.
glm::dmat3 in_digits(const glm::dmat3& m) {
    const auto at = [&](int column, int row) { return Digits(m[column % 3][row % 3]); };
    const auto cofactor = [&](int column, int row) {
        return Digits(at(column + 1, row + 1) * at(column + 2, row + 2) -
                      at(column + 1, row + 2) * at(column + 2, row + 1));
    };
    Digits determinant = 0;
    for (int row = 0; row < 3; ++row) determinant += at(0, row) * cofactor(0, row);
    glm::dmat3 result(0);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            result[column][row] = static_cast<double>(Digits(cofactor(column, row) / determinant));
    return result;
}

// Columns that are nearly multiples of each other: of each other's directions 1e-3 and 1e-5 are left.
TEST(NormalMatrix, KeepsItsDigitsWhereColumnsAreNearlyParallel) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto vector = [&] { return glm::dvec3(uniform(random), uniform(random), uniform(random)); };
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 first = vector(), second = 0.7 * first + 1e-3 * vector(),
                         third = 0.3 * first - 0.4 * second + 1e-5 * vector();
        const glm::dmat3 m(first, second, third);
        if (is_singular(m)) continue;
        const glm::dmat3 normals = normal_matrix(m), right = in_digits(m);
        for (int column = 0; column < 3; ++column) {
            double size = 0;
            for (int row = 0; row < 3; ++row) size = std::max(size, std::abs(right[column][row]));
            for (int row = 0; row < 3; ++row)
                ASSERT_NEAR(normals[column][row] / size, right[column][row] / size, 1e-11) << i;
        }
    }
}

}  // namespace
}  // namespace twinlight::normal_matrix_test
