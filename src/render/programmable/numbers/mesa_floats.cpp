#include "render/programmable/numbers/mesa_floats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace twinlight::programmable {
namespace {

float dot(const glm::vec3& a, const glm::vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// main/macros.h, NORMALIZE_3FV.
glm::vec3 unit(const glm::vec3& v) {
    const float square = dot(v, v);
    return square != 0 ? v * (1.0F / std::sqrt(square)) : v;
}

// ---- Matrices ----

enum class Inversion { kGeneral, kGeneral3x3, kNoRotation, kSimilarity, kTranspose };

struct Kind {
    Inversion inversion = Inversion::kGeneral;
    bool keeps_lengths = false;
};

constexpr float kNear = 1e-6F;
bool is_near(float a, float b) { return (a - b) * (a - b) <= kNear * kNear; }
bool is_nearer(float a, float b) { return (a - b) * (a - b) < kNear * kNear; }

// math/m_matrix.c, analyse_from_scratch: matrix types and flags, and the inversion that inv_mat_tab and
// invert_matrix_3d choose.
Kind kind_of(const glm::mat4& m) {
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) return {};
    const bool is_diagonal =
        m[0][1] == 0 && m[0][2] == 0 && m[1][0] == 0 && m[1][2] == 0 && m[2][0] == 0 && m[2][1] == 0;
    const bool is_2d = m[0][2] == 0 && m[1][2] == 0 && m[2][0] == 0 && m[2][1] == 0 && m[2][2] == 1 && m[3][2] == 0;
    if (is_diagonal && is_2d) return {Inversion::kNoRotation, m[0][0] == 1 && m[1][1] == 1};
    if (is_diagonal) {
        const bool is_uniform = is_nearer(m[0][0], m[1][1]) && is_nearer(m[0][0], m[2][2]);
        return {Inversion::kNoRotation, is_uniform && is_near(m[0][0], 1)};
    }
    const glm::vec3 x(m[0]), y(m[1]), z(m[2]);
    if (is_2d) {
        const float xx = x.x * x.x + x.y * x.y, yy = y.x * y.x + y.y * y.y, xy = x.x * y.x + x.y * y.y;
        const bool is_rotation = is_near(xx, 1) && is_near(yy, 1) && is_near(xy, 0);
        return {is_rotation ? Inversion::kTranspose : Inversion::kGeneral3x3, is_rotation};
    }
    const float xx = dot(x, x), yy = dot(y, y), zz = dot(z, z), xy = dot(x, y);
    if (!is_nearer(xx, yy) || !is_nearer(xx, zz)) return {Inversion::kGeneral3x3};
    const glm::vec3 off(x.y * y.z - x.z * y.y - z.x, x.z * y.x - x.x * y.z - z.y, x.x * y.y - x.y * y.x - z.z);
    if (!is_nearer(xy, 0) || !(dot(off, off) < kNear * kNear)) return {Inversion::kGeneral3x3};
    const bool scales = !is_near(xx, 1);
    return {scales ? Inversion::kSimilarity : Inversion::kTranspose, !scales};
}

// util/u_math.c, util_invert_mat4x4: Gaussian elimination; pivots bubble up row by row.
glm::mat3 general_inverse(const glm::mat4& m) {
    std::array<std::array<float, 8>, 4> rows{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k) rows[i][k] = m[static_cast<int>(k)][static_cast<int>(i)];
        rows[i][4 + i] = 1;
    }
    for (std::size_t pivot = 0; pivot < 4; ++pivot) {
        for (std::size_t i = 3; i > pivot; --i)
            if (std::abs(rows[i][pivot]) > std::abs(rows[i - 1][pivot])) std::swap(rows[i], rows[i - 1]);
        if (rows[pivot][pivot] == 0) return glm::mat3(1);
        for (std::size_t i = pivot + 1; i < 4; ++i) {
            const float factor = rows[i][pivot] / rows[pivot][pivot];
            for (std::size_t k = pivot + 1; k < 8; ++k) rows[i][k] -= factor * rows[pivot][k];
        }
    }
    for (std::size_t i = 4; i-- > 0;) {
        const float reciprocal = 1.0F / rows[i][i];
        for (std::size_t k = 4; k < 8; ++k) {
            for (std::size_t j = 3; j > i; --j) rows[i][k] -= rows[j][k] * rows[i][j];
            rows[i][k] *= reciprocal;
        }
    }
    glm::mat3 inverse;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            inverse[column][row] = rows[static_cast<std::size_t>(row)][4 + static_cast<std::size_t>(column)];
    return inverse;
}

// invert_matrix_3d_general: cofactors. The determinant sums its positive terms and its negative terms separately.
glm::mat3 inverse_3x3(const glm::mat4& m) {
    const float terms[] = {m[0][0] * m[1][1] * m[2][2],  m[0][1] * m[1][2] * m[2][0],  m[0][2] * m[1][0] * m[2][1],
                           -m[0][2] * m[1][1] * m[2][0], -m[0][1] * m[1][0] * m[2][2], -m[0][0] * m[1][2] * m[2][1]};
    float positive = 0, negative = 0;
    for (const float term : terms) (term >= 0 ? positive : negative) += term;
    const float determinant = positive + negative;
    if (determinant == 0) return glm::mat3(1);
    const float reciprocal = 1.0F / determinant;
    glm::mat3 inverse;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const int r1 = (column + 1) % 3, r2 = (column + 2) % 3, c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            inverse[column][row] = (m[c1][r1] * m[c2][r2] - m[c2][r1] * m[c1][r2]) * reciprocal;
        }
    }
    return inverse;
}

glm::mat3 inverse_of(const glm::mat4& m, Inversion inversion) {
    switch (inversion) {
        case Inversion::kGeneral: return general_inverse(m);
        case Inversion::kGeneral3x3: return inverse_3x3(m);
        case Inversion::kTranspose: return glm::transpose(glm::mat3(m));
        case Inversion::kNoRotation: {
            if (m[0][0] == 0 || m[1][1] == 0 || m[2][2] == 0) return glm::mat3(1);
            glm::mat3 inverse(1);
            for (int i = 0; i < 3; ++i) inverse[i][i] = 1.0F / m[i][i];
            return inverse;
        }
        case Inversion::kSimilarity: {
            const glm::vec3 first_row(m[0][0], m[1][0], m[2][0]);
            const float square = dot(first_row, first_row);
            return square == 0 ? glm::mat3(1) : glm::transpose(glm::mat3(m)) * (1.0F / square);
        }
    }
    return glm::mat3(1);
}

}  // namespace

glm::mat4 mesa_product(const glm::mat4& a, const glm::mat4& b) {
    glm::mat4 product;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            product[column][row] = a[0][row] * b[column][0] + a[1][row] * b[column][1] + a[2][row] * b[column][2] +
                                   a[3][row] * b[column][3];
    return product;
}

MesaMatrix mesa_matrix(const glm::mat4& matrix) {
    const Kind kind = kind_of(matrix);
    return {inverse_of(matrix, kind.inversion), kind.keeps_lengths};
}

float mesa_normal_scale(const MesaMatrix& modelview) {
    if (modelview.keeps_lengths) return 1;
    const glm::mat3& m = modelview.inverse;
    const glm::vec3 third_row(m[0][2], m[1][2], m[2][2]);
    return 1.0F / std::sqrt(dot(third_row, third_row));
}

bool mesa_lights_in_eye_space(const LightingState& lighting, const MesaMatrix& modelview) {
    const LightModel& model = lighting.light_model;
    return model.local_viewer || model.color_control != kGL_SINGLE_COLOR || !modelview.keeps_lengths ||
           std::ranges::any_of(lighting.lights, [](const LightSource& light) {
               return light.enabled && (!light.is_directional() || light.has_cutoff());
           });
}

MesaLight mesa_light(const LightSource& light, const glm::mat4& modelview, const MesaMatrix& facts, bool eye_space) {
    const glm::vec4 eye(light.position_eye);
    MesaLight result;
    result.position = glm::vec3(eye);
    glm::vec3 eye_z(0, 0, 1);
    if (!eye_space) {
        // Only a direction gets here: with a positional light the driver lights in eye coordinates.
        const glm::mat3& m = facts.inverse;
        for (int row = 0; row < 3; ++row)
            result.position[row] = m[0][row] * eye.x + m[1][row] * eye.y + m[2][row] * eye.z;
        eye_z = {modelview[0][2], modelview[1][2], modelview[2][2]};
    }
    if (eye.w != 0) {
        result.position *= 1.0F / eye.w;
    } else {
        result.position = unit(result.position);
        result.half_dir = unit(result.position + eye_z);
    }
    // With a spotlight the driver lights in eye coordinates. It normalises the direction twice.
    result.spot_direction = unit(unit(glm::vec3(light.spot_direction_eye)));
    const auto cutoff_deg = static_cast<float>(light.spot_cutoff_deg);
    const auto cutoff = static_cast<float>(static_cast<double>(cutoff_deg) * std::numbers::pi / 180.0);
    result.spot_cutoff_cosine = std::max(std::cos(cutoff), 0.0F);
    return result;
}

}  // namespace twinlight::programmable
