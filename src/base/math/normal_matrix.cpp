#include "base/math/normal_matrix.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace twinlight {
namespace {

// m = rows * scaled * columns, where rows and columns are diagonal and contain powers of two, so nothing rounds.
struct Scaled {
    glm::dmat3 scaled;
    glm::dvec3 rows{1}, columns{1};
    bool has_zero = false;  // a row or column of zeros
};

int exponent_of(double x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return exponent;
}

Scaled scaled(const glm::dmat3& m) {
    constexpr int kRounds = 8;  // each halves the exponents that are left
    Scaled result{m};
    bool changes = true;
    for (int round = 0; changes && round < kRounds; ++round) {
        changes = false;
        for (int row = 0; row < 3; ++row) {
            double largest = 0;
            for (int column = 0; column < 3; ++column)
                largest = std::max(largest, std::abs(result.scaled[column][row]));
            if (!(largest > 0) || !std::isfinite(largest)) return {m, glm::dvec3(1), glm::dvec3(1), true};
            const int exponent = exponent_of(largest);
            if (exponent == 0) continue;
            changes = true;
            for (int column = 0; column < 3; ++column)
                result.scaled[column][row] = std::ldexp(result.scaled[column][row], -exponent);
            result.rows[row] = std::ldexp(result.rows[row], exponent);
        }
        for (int column = 0; column < 3; ++column) {
            glm::dvec3& of = result.scaled[column];
            const double largest = std::max({std::abs(of.x), std::abs(of.y), std::abs(of.z)});
            if (!(largest > 0)) return {m, glm::dvec3(1), glm::dvec3(1), true};
            const int exponent = exponent_of(largest);
            if (exponent == 0) continue;
            changes = true;
            for (int row = 0; row < 3; ++row) of[row] = std::ldexp(of[row], -exponent);
            result.columns[column] = std::ldexp(result.columns[column], exponent);
        }
    }
    return result;
}

// Cofactors of columns that are nearly parallel are small differences, and the determinant is a small sum of those. Doubles would
// lose digits twice.
using Matrix = glm::mat<3, 3, long double>;

// The cofactors: the transposed inverse times the determinant.
Matrix cofactors(const Matrix& m) { return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])}; }

long double norm(const Matrix& m) {
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

struct Cofactors {
    Matrix of{0};
    long double determinant = 0;
    bool is_singular = true;
};
Cofactors cofactors_of(const Scaled& m) {
    if (m.has_zero) return {};
    constexpr double kSingular = 0x1p21;
    const Matrix scaled(m.scaled), of = cofactors(scaled);
    const long double determinant = glm::dot(scaled[0], of[0]);
    // The product of the norms of a matrix and its inverse: the largest singular value over the smallest, to a factor of 3.
    const bool is_singular = !(norm(scaled) * norm(of) < kSingular * std::abs(determinant));
    return {of, determinant, is_singular};
}

}  // namespace

bool is_singular(const glm::dmat3& eye_from_object) { return cofactors_of(scaled(eye_from_object)).is_singular; }

glm::dmat3 normal_matrix(const glm::dmat3& eye_from_object) {
    const Scaled m = scaled(eye_from_object);
    const Cofactors c = cofactors_of(m);
    if (c.is_singular) return glm::dmat3(0);
    glm::dmat3 result(c.of / c.determinant);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) result[column][row] = result[column][row] / m.rows[row] / m.columns[column];
    return result;
}

}  // namespace twinlight
