#include "scene/command/named_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

namespace twinlight {
namespace {

// GLU computes in floats, and its steps round.
bool fits(const glm::dmat4& made, const glm::dmat4& given) {
    constexpr double kRounding = 4 * 0x1p-24;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            const double size = std::max(std::abs(given[column][row]), 1.0);
            if (!(std::abs(made[column][row] - given[column][row]) <= kRounding * size)) return false;
        }
    return true;
}

// A number that a person writes.
double value_of(const std::string& text) { return std::strtod(text.c_str(), nullptr); }
std::string short_text(double x, int digits = 5) {
    return fmt::format("{}", value_of(fmt::format("{:.{}g}", x, digits)) + 0.0);  // 1000, not 1e+03; 0, not -0
}

// "4.0 / 3", or "1.5".
std::string aspect_text(double aspect) {
    for (int divisor = 3; divisor < 64; ++divisor) {
        const double whole = std::round(aspect * divisor);
        if (std::abs(value_of(short_text(aspect)) - aspect) < 1e-7) break;
        if (std::abs(whole / divisor - aspect) < 1e-7) return fmt::format("{:.0f}.0 / {}", whole, divisor);
    }
    return short_text(aspect);
}
double aspect_of(const std::string& text) {
    const std::size_t slash = text.find('/');
    return slash == text.npos ? value_of(text) : value_of(text) / value_of(text.substr(slash + 1));
}

std::string perspective(const glm::dmat4& m) {
    if (m[2][3] != -1 || m[3][3] != 0 || m[1][1] <= 0 || m[0][0] <= 0) return "";
    const std::string fovy = short_text(glm::degrees(2 * std::atan(1 / m[1][1])));
    const std::string aspect = aspect_text(m[1][1] / m[0][0]);
    const std::string near_text = short_text(m[3][2] / (m[2][2] - 1));
    const double near_z = value_of(near_text), far_z = m[3][2] / (m[2][2] + 1);
    // A float leaves few digits of a far plane.
    for (int digits = 1; digits <= 5; ++digits) {
        const std::string far_text = short_text(far_z, digits);
        if (!(near_z > 0 && value_of(far_text) > near_z && aspect_of(aspect) > 0)) continue;
        if (fits(glm::perspective(glm::radians(value_of(fovy)), aspect_of(aspect), near_z, value_of(far_text)), m))
            return fmt::format("gluPerspective({}, {}, {}, {})", fovy, aspect, near_text, far_text);
    }
    return "";
}

std::string look_at(const glm::dmat4& m) {
    const glm::dmat3 turn(m);
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) return "";
    // A person writes few decimals.
    const auto shortened = [](const glm::dvec3& v) { return glm::round(1000.0 * v) / 1000.0; };
    const glm::dmat3 back = glm::transpose(turn);
    const glm::dvec3 eye = shortened(back * -glm::dvec3(m[3])), forward = -back[2];
    if (eye == glm::dvec3(0)) return "";
    // The eye looks at the origin, at a place on an axis, or straight along one.
    const std::array<glm::dvec3, 5> centers{glm::dvec3(0), glm::dvec3(eye.x, 0, 0), glm::dvec3(0, eye.y, 0),
                                            glm::dvec3(0, 0, eye.z), shortened(eye + forward)};
    const std::array<glm::dvec3, 3> ups{glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)};
    for (const glm::dvec3& center : centers)
        for (const glm::dvec3& up : ups) {
            if (glm::length(glm::cross(center - eye, up)) == 0 || !fits(glm::lookAt(eye, center, up), m)) continue;
            std::string list;
            for (const glm::dvec3& v : {eye, center, up})
                for (int i = 0; i < 3; ++i) list += (list.empty() ? "" : ", ") + short_text(v[i]);
            return fmt::format("gluLookAt({})", list);
        }
    return "";
}

}  // namespace

std::string named_matrix(std::span<const Command> rest) {
    const auto is = [](const Command& command, CommandId of_floats, CommandId of_doubles) {
        return command.id == of_floats || command.id == of_doubles;
    };
    if (rest.empty()) return "";
    const Command& first = rest.front();
    if (!is(first, CommandId::glMultMatrixf, CommandId::glMultMatrixd) &&
        !is(first, CommandId::glLoadMatrixf, CommandId::glLoadMatrixd))
        return "";
    const glm::dmat4 m = glm::make_mat4(first.arguments.data());
    if (std::string found = perspective(m); !found.empty()) return found;
    // gluLookAt multiplies with the turn first, then with the translation.
    const bool is_moved = rest.size() > 1 && m[3] == glm::dvec4(0, 0, 0, 1) &&
                          is(rest[1], CommandId::glTranslatef, CommandId::glTranslated);
    if (!is_moved) return glm::dmat3(m) == glm::dmat3(1) ? "" : look_at(m);
    const auto& by = rest[1].arguments;
    return look_at(glm::translate(m, {by[0], by[1], by[2]}));
}

}  // namespace twinlight
