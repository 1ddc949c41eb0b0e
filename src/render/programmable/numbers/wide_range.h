// Detects Draws whose distances are too different for eye coordinates in floats.
//
// A shader usually gets the vector from a vertex to a light as the difference of their eye coordinates. That loses the vector if
// both are far away and close together, and squares of its length overflow or vanish if lengths have very different sizes. In a
// wide range the way has two parts. The first leads to the vertex that is nearest to the light. It is taken in object coordinates,
// where vertices are exactly the floats that the program gave, and is then multiplied with the matrix's upper 3x3. The second leads
// from there to the light, in eye coordinates; double precision computes it once per Draw. No vertex is nearer to the light, so
// neither part is much longer than the whole, and their sum loses no digits.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/effect/plan.h"

namespace twinlight::programmable {

// Of Draws with one state and one plan, whose vertex facts are those of all their vertices.
bool has_wide_range(std::span<const Draw* const> draws, const Plan& plan);
inline bool has_wide_range(const Draw& draw, const Plan& plan) {
    const Draw* const one = &draw;
    return has_wide_range({&one, 1}, plan);
}

// The same matrix for points, divided by its last element if it does nothing else to w, as the shadow matrix of a directional light.
glm::dmat4 keeping_w(const glm::dmat4& eye_from_object);

// Bounds on x, y and z, and on w, of matrix * position, if the position's components are at most `reach`.
double reach_xyz(const glm::dmat4& matrix, const glm::dvec4& reach);
double reach_w(const glm::dmat4& matrix, const glm::dvec4& reach);

// x rounded down to a power of two; 1 if x is not positive, or infinite.
double power_of_two(double x);
// What to divide homogeneous coordinates by, whose largest x, y or z is `longest` and whose largest w is `w`: neither this scale nor
// its inverse is a denormal, and products with it do not overflow. Not all come down to 1: the driver divides what it interpolates
// by w of clip coordinates, which is as large as the distance. Beside a far x, y or z a small w would become a denormal, which
// Mesa 25 takes for 0.
double homogeneous_scale(double longest, double w);
// What to divide clip coordinates by, whose scale does not matter: 1 unless their w is near the limits of floats. The driver divides
// colours by w before it interpolates them, and they would become denormals.
double clip_scale(const glm::dmat4& clip_from_object, const glm::dvec4& reach_object);

// The places that lighting measures distances to: positional lights, and the eye with a local viewer.
std::vector<glm::dvec3> places_eye(const Plan& plan);

// Beyond this, sums of squares of a few float components, scaled down, could leave the floats.
inline constexpr double kMostDistant = 1e37;

// For a matrix that keeps w: the vertex that is nearest to a place, and the rest of the way, in eye coordinates.
struct NearestVertex {
    glm::dvec4 vertex_object{0, 0, 0, 1};  // the origin if all vertices are directions, or more than kMostDistant away
    glm::dvec3 way_eye{0};                 // from the vertex to the place
};
NearestVertex nearest_vertex(const Draw& draw, const glm::dvec3& place_eye);

}  // namespace twinlight::programmable
