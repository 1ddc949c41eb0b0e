// The matrix commands (2.11.2), GLU's (gluPerspective, gluLookAt, gluOrtho2D) and the viewport (2.11.1).

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <tuple>
#include <utility>

#include "base/math/directions.h"
#include "base/math/normal_matrix.h"
#include "scene/state/not_finite.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// Stack depths: the minimum of the specification (table 6.20), and the depth in Mesa.
constexpr std::size_t kModelviewStackDepth = 32;
constexpr std::size_t kProjectionStackDepth = 32;
constexpr std::size_t kTextureStackDepth = 10;

// Drivers clamp viewports to GL_MAX_VIEWPORT_DIMS and GL_VIEWPORT_BOUNDS_RANGE (GL 4.1, section 2.14.1). Mesa's values.
constexpr double kMaxViewportSize = 16384;
constexpr double kMinViewportPosition = -32768, kMaxViewportPosition = 32767;

double radians(double degrees) { return degrees * (M_PI / 180); }

// Rotate (2.11.2); the axis has a length. Sine and cosine are of the angle beyond a multiple of 90 degrees, so that those of a right
// angle are exact and small ones keep their digits: pi is rounded, so sin(pi) is not 0.
glm::dmat4 rotation(double angle_deg, const glm::dvec3& axis) {
    const double turn_deg = std::remainder(angle_deg, 360), rest_deg = std::remainder(turn_deg, 90);
    const double quarter_turns = (turn_deg - rest_deg) / 90;  // -2 to 2
    double c = std::cos(radians(rest_deg)), s = std::sin(radians(rest_deg));
    if (std::abs(quarter_turns) == 2) c = -c, s = -s;
    if (quarter_turns == 1) std::tie(c, s) = std::pair(-s, c);
    if (quarter_turns == -1) std::tie(c, s) = std::pair(s, -c);
    // For a small angle, 1 - c would lose digits.
    const double half = std::sin(radians(rest_deg / 2)), one_minus_c = quarter_turns == 0 ? 2 * half * half : 1 - c;
    const glm::dvec3 u = glm::normalize(axis);
    const glm::dmat3 cross({0, u.z, -u.y}, {-u.z, 0, u.x}, {u.y, -u.x, 0});
    return glm::dmat4(c * glm::dmat3(1) + one_minus_c * glm::outerProduct(u, u) + s * cross);
}

// 2.11.2: the matrices of Frustum and Ortho.
glm::dmat4 frustum_matrix(double l, double r, double b, double t, double n, double f) {
    glm::dmat4 m(0);
    m[0] = {2 * n / (r - l), 0, 0, 0};
    m[1] = {0, 2 * n / (t - b), 0, 0};
    m[2] = {(r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1};
    m[3] = {0, 0, -2 * f * n / (f - n), 0};
    return m;
}

glm::dmat4 ortho_matrix(double l, double r, double b, double t, double n, double f) {
    glm::dmat4 m(1);
    m[0][0] = 2 / (r - l);
    m[1][1] = 2 / (t - b);
    m[2][2] = -2 / (f - n);
    m[3] = {-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1};
    return m;
}

}  // namespace

State::MatrixStack& State::stack() {
    if (a_.matrix_mode == kGL_MODELVIEW) return modelview_;
    return a_.matrix_mode == kGL_PROJECTION ? projection_ : texture_[a_.active_unit];
}

std::size_t State::matrix_depth(Enum mode) const {
    if (mode == kGL_MODELVIEW) return modelview_.size();
    return mode == kGL_PROJECTION ? projection_.size() : texture_[a_.active_unit].size();
}

std::size_t State::stack_limit() const {
    if (a_.matrix_mode == kGL_MODELVIEW) return kModelviewStackDepth;
    return a_.matrix_mode == kGL_PROJECTION ? kProjectionStackDepth : kTextureStackDepth;
}

// RULING: a product that no float holds is refused, like such a number in a command.
void State::multiply(const Command& c, const glm::dmat4& matrix) {
    const glm::dmat4 product = stack().back().matrix * matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!is_in_float_range(product[column][row]))
                return raise(kGL_INVALID_VALUE, c,
                             "{} makes an element of the {} matrix {:.2g}; the largest float is 3.4e+38", c.name(),
                             enum_name(a_.matrix_mode), product[column][row]);
    stack().back().matrix = product;
}

void State::matrix_mode(const Command& c) {
    if (known(c, c.enumerant(0), {kGL_MODELVIEW, kGL_PROJECTION, kGL_TEXTURE})) a_.matrix_mode = c.enumerant(0);
}

void State::load_identity(const Command&) { stack().back().matrix = glm::dmat4(1); }

void State::push_matrix(const Command& c) {
    if (stack().size() >= stack_limit()) {
        return raise(kGL_STACK_OVERFLOW, c, "the {} stack is full ({} matrices); a glPopMatrix is missing",
                     enum_name(a_.matrix_mode), stack_limit());
    }
    stack().push_back({stack().back().matrix, c.place});
}

void State::pop_matrix(const Command& c) {
    if (stack().size() == 1) {
        return raise(kGL_STACK_UNDERFLOW, c, "glPopMatrix without a glPushMatrix on the {} stack",
                     enum_name(a_.matrix_mode));
    }
    stack().pop_back();
}

// Matrices are given by columns (2.11.2), as in GLM.
void State::load_matrix(const Command& c) { stack().back().matrix = glm::make_mat4(c.arguments.data()); }
void State::mult_matrix(const Command& c) { multiply(c, glm::make_mat4(c.arguments.data())); }

// 2.11.2: the same, by rows.
void State::load_transpose_matrix(const Command& c) {
    stack().back().matrix = glm::transpose(glm::make_mat4(c.arguments.data()));
}
void State::mult_transpose_matrix(const Command& c) { multiply(c, glm::transpose(glm::make_mat4(c.arguments.data()))); }

// 2.12: the inverse of the current modelview matrix transforms planes to eye coordinates. RULING: if the matrix is
// singular, every point is inside; the specification leaves this undefined.
void State::clip_plane(const Command& c) {
    const Enum plane = c.enumerant(0);
    if (plane < kGL_CLIP_PLANE0 || plane >= kGL_CLIP_PLANE0 + kMaxClipPlanes) {
        return raise(kGL_INVALID_ENUM, c, "glClipPlane is given {}; expected GL_CLIP_PLANE0 to GL_CLIP_PLANE0 + 7",
                     enum_name(plane));
    }
    const glm::dvec4 equation(c.number(1), c.number(2), c.number(3), c.number(4));
    const bool singular = is_singular(glm::dmat3(modelview())) || glm::determinant(modelview()) == 0;
    glm::dvec4& equation_eye = a_.clip_planes[plane - kGL_CLIP_PLANE0].equation_eye;
    equation_eye = singular ? glm::dvec4(0) : glm::transpose(glm::inverse(modelview())) * equation;
    for (int i = 0; i < 4; ++i)  // nearly singular: the inverse overflows
        if (!std::isfinite(equation_eye[i])) equation_eye = glm::dvec4(0);
}

void State::rotate(const Command& c) {
    const glm::dvec3 axis(c.number(1), c.number(2), c.number(3));
    if (glm::length(axis) == 0) return;  // RULING: no axis, no rotation (2.11.2 leaves it open; Mesa does the same)
    multiply(c, rotation(c.number(0), axis));
}

void State::scale(const Command& c) {
    multiply(c, glm::scale(glm::dmat4(1), glm::dvec3(c.number(0), c.number(1), c.number(2))));
}

void State::translate(const Command& c) {
    multiply(c, glm::translate(glm::dmat4(1), glm::dvec3(c.number(0), c.number(1), c.number(2))));
}

void State::frustum(const Command& c) {
    const double l = c.number(0), r = c.number(1), b = c.number(2), t = c.number(3), n = c.number(4), f = c.number(5);
    if (n <= 0 || f <= 0 || l == r || b == t || n == f) {
        return raise(kGL_INVALID_VALUE, c,
                     "glFrustum needs near > 0, far > 0, near != far, left != right and bottom != top");
    }
    multiply(c, frustum_matrix(l, r, b, t, n, f));
}

void State::ortho(const Command& c) {
    const double l = c.number(0), r = c.number(1), b = c.number(2), t = c.number(3), n = c.number(4), f = c.number(5);
    if (l == r || b == t || n == f)
        return raise(kGL_INVALID_VALUE, c, "glOrtho needs left != right, bottom != top and near != far");
    multiply(c, ortho_matrix(l, r, b, t, n, f));
}

void State::ortho_2d(const Command& c) {
    const double l = c.number(0), r = c.number(1), b = c.number(2), t = c.number(3);
    if (l == r || b == t) return raise(kGL_INVALID_VALUE, c, "gluOrtho2D needs left != right and bottom != top");
    multiply(c, ortho_matrix(l, r, b, t, -1, 1));
}

// GLU ignores a view without extent and raises no error.
void State::perspective(const Command& c) {
    const double half_angle = radians(c.number(0) / 2), aspect = c.number(1), n = c.number(2), f = c.number(3);
    if (n == f || aspect == 0 || std::sin(half_angle) == 0) return;  // then GLU calls no GL command
    if (open_) return raise_inside(c);
    const double cotangent = std::cos(half_angle) / std::sin(half_angle);
    glm::dmat4 m(0);
    m[0][0] = cotangent / aspect;
    m[1][1] = cotangent;
    m[2] = {0, 0, -(f + n) / (f - n), -1};
    m[3] = {0, 0, -2 * n * f / (f - n), 0};
    multiply(c, m);
}

void State::look_at(const Command& c) {
    const glm::dvec3 eye(c.number(0), c.number(1), c.number(2));
    const glm::dvec3 center(c.number(3), c.number(4), c.number(5));
    const glm::dvec3 up(c.number(6), c.number(7), c.number(8));
    const glm::dvec3 forward_dir = twinlight::unit(center - eye);
    const glm::dvec3 side_dir = twinlight::unit(glm::cross(forward_dir, up));
    const glm::dvec3 up_dir = glm::cross(side_dir, forward_dir);
    glm::dmat4 m(1);
    for (int i = 0; i < 3; ++i) {
        m[i][0] = side_dir[i];
        m[i][1] = up_dir[i];
        m[i][2] = -forward_dir[i];
    }
    multiply(c, glm::translate(m, -eye));
}

void State::viewport(const Command& c) {
    const double width = c.number(2), height = c.number(3);
    if (width < 0 || height < 0)
        return raise(kGL_INVALID_VALUE, c, "glViewport is given the size {} x {}; it cannot be negative", width,
                     height);
    const auto position = [](double v) {
        return static_cast<int>(std::clamp(v, kMinViewportPosition, kMaxViewportPosition));
    };
    const auto size = [](double v) { return static_cast<int>(std::min(v, kMaxViewportSize)); };
    a_.raster.viewport = {position(c.number(0)), position(c.number(1)), size(width), size(height)};
}

}  // namespace twinlight
