#include "render/reference/vertices/tex_gen.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "base/math/normal_matrix.h"
#include "base/math/vec3.h"
#include "lighting/real.h"
#include "render/reference/textures/texture.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::reference {

namespace {

// u: the unit vector from the origin to the vertex. A negative w turns it around.
glm::dvec3 direction_to(const glm::dvec4& position_eye) {
    const glm::dvec3 u = vec3_cast<glm::dvec3>(lighting::unit(vec3_cast<Vec3<double>>(glm::dvec3(position_eye))));
    return position_eye.w < 0 ? -u : u;
}

// r = u - 2 n_f (n_f . u).
glm::dvec3 reflected(const glm::dvec4& position_eye, const glm::dvec3& normal_eye) {
    const glm::dvec3 u = direction_to(position_eye);
    return u - 2.0 * normal_eye * glm::dot(normal_eye, u);
}

// m / 2, where m = 2 sqrt(r_x^2 + r_y^2 + (r_z + 1)^2).
double half_m(const glm::dvec3& r) { return glm::length(r + glm::dvec3(0, 0, 1)); }

template <class Matrix, class Vector>
Vector magnitudes(const Matrix& m, const Vector& v) {
    Vector sum(0);
    for (int i = 0; i < Vector::length(); ++i) sum += glm::abs(m[i]) * std::abs(v[i]);
    return sum;
}

}  // namespace

glm::dvec4 generated_tex_coord(const TextureUnit& unit, const Vertex& vertex, const glm::dvec4& tex_coord,
                               const glm::dvec4& position_eye, const glm::dvec3& normal_eye) {
    glm::dvec4 result = tex_coord;
    for (const GeneratedCoordinate& one : unit.generated) {
        const int i = one.coordinate;
        switch (one.mode) {
            case kGL_OBJECT_LINEAR: result[i] = glm::dot(one.plane, vertex.position_object); break;
            case kGL_EYE_LINEAR: result[i] = glm::dot(one.plane, position_eye); break;
            case kGL_SPHERE_MAP: {
                // RULING: where m is 0, the coordinate is 1/2.
                const glm::dvec3 r = reflected(position_eye, normal_eye);
                result[i] = quotient(r[i], 2 * half_m(r)) + 0.5;
                break;
            }
            case kGL_REFLECTION_MAP: result[i] = reflected(position_eye, normal_eye)[i]; break;
            case kGL_NORMAL_MAP: result[i] = normal_eye[i]; break;
            default: break;
        }
    }
    return result;
}

double generated_error(const Draw& draw, const TextureUnit& unit, const Vertex& vertex, const StageVertex& staged) {
    if (unit.generated.empty()) return 0;
    // Float arithmetic: a product with a matrix, and the driver's inverse of the modelview matrix, each in a few dozen
    // roundings of half a unit in the last place.
    constexpr double kRoundings = 64 * 0x1p-24;
    const glm::dvec4 eye_sums = magnitudes(draw.eye_from_object, vertex.position_object);
    const glm::dvec3 eye(staged.position_eye);
    const double u_error =
        std::min(2.0, kRoundings * (1 + quotient(glm::length(glm::dvec3(eye_sums)), glm::length(eye))));
    const glm::dmat3 to_eye = normal_matrix(glm::dmat3(draw.eye_from_object));
    const double n = glm::length(staged.normal_eye), before = glm::length(to_eye * vertex.normal_object);
    const double n_error =
        kRoundings * (n + n * quotient(glm::length(magnitudes(to_eye, vertex.normal_object)), before));
    const double r_error = (1 + 2 * n * n) * u_error + 4 * n * n_error;
    glm::dvec4 errors(0);
    for (const GeneratedCoordinate& one : unit.generated) {
        double& error = errors[one.coordinate];
        switch (one.mode) {
            case kGL_OBJECT_LINEAR: error = glm::dot(glm::abs(one.plane), glm::abs(vertex.position_object)); break;
            case kGL_EYE_LINEAR: error = glm::dot(glm::abs(one.plane), eye_sums); break;
            case kGL_SPHERE_MAP: {
                // s = r_x / m + 1/2: the errors of r_x and of m, which is at least r_x.
                const double m = 2 * half_m(reflected(staged.position_eye, staged.normal_eye));
                error = m > 0 ? std::min(1.0, 3 * r_error / m) : 1;
                break;
            }
            case kGL_REFLECTION_MAP: error = r_error; break;
            default: error = n_error; break;
        }
        if (!one.needs_normal()) error *= kRoundings;
    }
    const glm::dvec4 after = magnitudes(unit.texture_matrix, errors);
    const bool has_r = unit.texture->needs_r(), has_q = !unit.texture->is_cube();
    return std::max({after.x, after.y, has_r ? after.z : 0, has_q ? after.w : 0});
}

}  // namespace twinlight::reference
