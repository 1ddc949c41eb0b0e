// freeglut 3.4's solids with flat faces: one GL_TRIANGLES for a solid, one GL_LINE_LOOP per face for wires.
//
// Numbers, order and normals are those of freeglut's src/fg_geometry.c. Some of its normals are shorter than 1, which
// is visible without GL_NORMALIZE: those of the icosahedron have length 0.957, eight of the rhombic dodecahedron's have
// 0.707.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "scene/shape/freeglut_shapes.h"

namespace twinlight {
namespace {

struct Face {
    glm::dvec3 normal;
    std::vector<std::size_t> corners;  // counter-clockwise
};

// How freeglut cuts a face with 3, 4 or 5 corners into triangles.
std::span<const std::uint32_t> triangles_of(std::size_t corners) {
    static constexpr std::array<std::uint32_t, 3> kTriangle{0, 1, 2};
    static constexpr std::array<std::uint32_t, 6> kQuad{0, 1, 2, 0, 2, 3};
    static constexpr std::array<std::uint32_t, 9> kPentagon{0, 1, 2, 0, 2, 4, 4, 2, 3};
    if (corners == 3) return kTriangle;
    if (corners == 4) return kQuad;
    return kPentagon;
}

// Adds faces. A solid has one part for all its faces; triangles need no indices.
void send(std::vector<ShapePart>& parts, std::span<const glm::dvec3> points, std::span<const Face> faces, bool wire) {
    if (!wire && parts.empty()) parts.push_back({kGL_TRIANGLES, {}, {}});
    for (const Face& face : faces) {
        if (wire) parts.push_back({kGL_LINE_LOOP, {}, {}});
        ShapePart& part = parts.back();
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        for (const std::size_t corner : face.corners) part.vertices.push_back({points[corner], face.normal});
        if (wire || face.corners.size() == 3) continue;
        for (const std::uint32_t corner : triangles_of(face.corners.size())) part.indices.push_back(first + corner);
    }
}

std::vector<ShapePart> polyhedron(std::span<const glm::dvec3> points, std::span<const Face> faces, bool wire) {
    std::vector<ShapePart> parts;
    send(parts, points, faces, wire);
    return parts;
}

// ---- The tetrahedron, and the sponge of tetrahedra ----

struct Tetrahedron {
    std::array<glm::dvec3, 4> points;
    std::array<Face, 4> faces;
};

// The corners are at distance 1 from the origin. Each face points away from the corner opposite to it.
Tetrahedron tetrahedron() {
    const double x = -1.0 / 3, y = std::sqrt(2.0) / 3, z = std::sqrt(6.0) / 3;
    const std::array<glm::dvec3, 4> points{{{1, 0, 0}, {x, 2 * y, 0}, {x, -y, z}, {x, -y, -z}}};
    return {points,
            {{{-points[0], {1, 3, 2}}, {-points[1], {0, 2, 3}}, {-points[2], {0, 3, 1}}, {-points[3], {0, 1, 2}}}}};
}

// A sponge consists of four sponges of the level below, one at each corner, half as large.
void send_sponge(std::vector<ShapePart>& parts, const Tetrahedron& whole, int levels, const glm::dvec3& offset,
                 double scale, bool wire) {
    if (levels > 0) {
        for (const glm::dvec3& point : whole.points) {
            send_sponge(parts, whole, levels - 1, offset + scale / 2 * point, scale / 2, wire);
        }
        return;
    }
    std::array<glm::dvec3, 4> points;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = offset + scale * whole.points[i];
    send(parts, points, whole.faces, wire);
}

}  // namespace

std::vector<ShapePart> freeglut_cube(double size, bool wire) {
    const double h = size / 2;
    const std::array<glm::dvec3, 8> points{
        {{h, h, h}, {-h, h, h}, {-h, -h, h}, {h, -h, h}, {h, -h, -h}, {h, h, -h}, {-h, h, -h}, {-h, -h, -h}}};
    const std::array<Face, 6> faces{{{{0, 0, 1}, {0, 1, 2, 3}},
                                     {{1, 0, 0}, {0, 3, 4, 5}},
                                     {{0, 1, 0}, {0, 5, 6, 1}},
                                     {{-1, 0, 0}, {1, 6, 7, 2}},
                                     {{0, -1, 0}, {7, 4, 3, 2}},
                                     {{0, 0, -1}, {4, 7, 6, 5}}}};
    return polyhedron(points, faces, wire);
}

std::vector<ShapePart> freeglut_tetrahedron(bool wire) {
    const Tetrahedron whole = tetrahedron();
    return polyhedron(whole.points, whole.faces, wire);
}

std::vector<ShapePart> freeglut_octahedron(bool wire) {
    const std::array<glm::dvec3, 6> points{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    const double n = 1 / std::sqrt(3.0);
    const std::array<Face, 8> faces{{{{n, n, n}, {0, 1, 2}},
                                     {{n, n, -n}, {0, 5, 1}},
                                     {{n, -n, n}, {0, 2, 4}},
                                     {{n, -n, -n}, {0, 4, 5}},
                                     {{-n, n, n}, {3, 2, 1}},
                                     {{-n, n, -n}, {3, 1, 5}},
                                     {{-n, -n, n}, {3, 4, 2}},
                                     {{-n, -n, -n}, {3, 5, 4}}}};
    return polyhedron(points, faces, wire);
}

std::vector<ShapePart> freeglut_dodecahedron(bool wire) {
    constexpr double kLong = std::numbers::phi, kShort = kLong - 1;
    const std::array<glm::dvec3, 20> points{{
        {0, kLong, kShort},  {-1, 1, 1},          {-kShort, 0, kLong}, {kShort, 0, kLong},   {1, 1, 1},
        {0, kLong, -kShort}, {1, 1, -1},          {kShort, 0, -kLong}, {-kShort, 0, -kLong}, {-1, 1, -1},
        {0, -kLong, kShort}, {1, -1, 1},          {-1, -1, 1},         {0, -kLong, -kShort}, {-1, -1, -1},
        {1, -1, -1},         {kLong, -kShort, 0}, {kLong, kShort, 0},  {-kLong, kShort, 0},  {-kLong, -kShort, 0},
    }};
    const double s = 1 / std::hypot(1, kLong), l = kLong * s;
    const std::array<Face, 12> faces{{{{0, s, l}, {0, 1, 2, 3, 4}},
                                      {{0, s, -l}, {5, 6, 7, 8, 9}},
                                      {{0, -s, l}, {10, 11, 3, 2, 12}},
                                      {{0, -s, -l}, {13, 14, 8, 7, 15}},
                                      {{l, 0, s}, {3, 11, 16, 17, 4}},
                                      {{-l, 0, s}, {2, 1, 18, 19, 12}},
                                      {{l, 0, -s}, {7, 6, 17, 16, 15}},
                                      {{-l, 0, -s}, {8, 14, 19, 18, 9}},
                                      {{s, l, 0}, {17, 6, 5, 0, 4}},
                                      {{s, -l, 0}, {16, 11, 10, 13, 15}},
                                      {{-s, l, 0}, {18, 1, 0, 5, 9}},
                                      {{-s, -l, 0}, {19, 14, 13, 10, 12}}}};
    return polyhedron(points, faces, wire);
}

std::vector<ShapePart> freeglut_icosahedron(bool wire) {
    // Two corners on the x axis, and between them two rings of five corners, one turned by half a step.
    const double x = 1 / std::sqrt(5.0), radius = 2 * x;
    std::array<glm::dvec3, 12> points;
    points[0] = {1, 0, 0};
    points[11] = {-1, 0, 0};
    for (std::size_t i = 0; i < 5; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / 5;
        points[1 + i] = {x, radius * std::cos(angle), radius * std::sin(angle)};
    }
    for (std::size_t i = 0; i < 5; ++i) points[6 + i] = -points[1 + (5 - i) % 5];

    std::vector<Face> faces;
    static constexpr std::size_t kCorners[20][3] = {{0, 1, 2},   {0, 2, 3},  {0, 3, 4},  {0, 4, 5},  {0, 5, 1},
                                                    {1, 8, 2},   {2, 7, 3},  {3, 6, 4},  {4, 10, 5}, {5, 9, 1},
                                                    {1, 9, 8},   {2, 8, 7},  {3, 7, 6},  {4, 6, 10}, {5, 10, 9},
                                                    {11, 9, 10}, {11, 8, 9}, {11, 7, 8}, {11, 6, 7}, {11, 10, 6}};
    for (const auto& [a, b, c] : kCorners) {  // the length of the normal is twice the face's area
        faces.push_back({glm::cross(points[b] - points[a], points[c] - points[a]), {a, b, c}});
    }
    return polyhedron(points, faces, wire);
}

std::vector<ShapePart> freeglut_rhombic_dodecahedron(bool wire) {
    const double a = std::sqrt(0.5), h = 0.5;
    const std::array<glm::dvec3, 14> points{{{0, 0, 1},
                                             {a, 0, h},
                                             {0, a, h},
                                             {-a, 0, h},
                                             {0, -a, h},
                                             {a, a, 0},
                                             {-a, a, 0},
                                             {-a, -a, 0},
                                             {a, -a, 0},
                                             {a, 0, -h},
                                             {0, a, -h},
                                             {-a, 0, -h},
                                             {0, -a, -h},
                                             {0, 0, -1}}};
    const double n = a / 2;
    const std::array<Face, 12> faces{{{{n, n, h}, {0, 1, 5, 2}},
                                      {{-n, n, h}, {0, 2, 6, 3}},
                                      {{-n, -n, h}, {0, 3, 7, 4}},
                                      {{n, -n, h}, {0, 4, 8, 1}},
                                      {{0, 1, 0}, {5, 10, 6, 2}},
                                      {{-1, 0, 0}, {6, 11, 7, 3}},
                                      {{0, -1, 0}, {7, 12, 8, 4}},
                                      {{1, 0, 0}, {8, 9, 5, 1}},
                                      {{n, n, -h}, {5, 9, 13, 10}},
                                      {{-n, n, -h}, {6, 10, 13, 11}},
                                      {{-n, -n, -h}, {7, 11, 13, 12}},
                                      {{n, -n, -h}, {8, 12, 13, 9}}}};
    return polyhedron(points, faces, wire);
}

std::vector<ShapePart> freeglut_sponge(int levels, const glm::dvec3& offset, double scale, bool wire) {
    std::vector<ShapePart> parts;
    if (levels >= 0) send_sponge(parts, tetrahedron(), levels, offset, scale, wire);
    return parts;
}

}  // namespace twinlight
