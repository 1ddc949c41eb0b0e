// The course report's cube, cylinder, cone and sphere.
#include "scene/shape/report_shapes.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace twinlight {
namespace {

constexpr glm::dvec3 kUp(0, 1, 0);

// (cos theta, 0, sin theta) for i of n steps around y. Growing i turns clockwise seen from above.
glm::dvec3 around_y(double i, int n) {
    const double theta = 2 * std::numbers::pi * i / n;
    return {std::cos(theta), 0, std::sin(theta)};
}

// A fan around `centre` through the vertices rim(0), ..., rim(n) = rim(0), or in reverse order, so that it is
// counter-clockwise seen from the given side.
enum class SeenFrom { kAbove, kBelow };

template <class Rim>
ShapePart fan(const ShapeVertex& centre, int slices, SeenFrom seen_from, const Rim& rim) {
    ShapePart part{kGL_TRIANGLE_FAN, {centre}, {}};
    for (int i = 0; i <= slices; ++i) {
        const int step = seen_from == SeenFrom::kAbove ? slices - i : i;
        part.vertices.push_back(rim(step % slices));
    }
    return part;
}

std::vector<ShapePart> caps(double radius, double height, int slices) {
    const auto cap = [&](double y, const glm::dvec3& normal, SeenFrom seen_from) {
        const glm::dvec3 centre = y * kUp;
        return fan({centre, normal}, slices, seen_from, [&](int i) {
            return ShapeVertex{centre + radius * around_y(i, slices), normal};
        });
    };
    return {cap(height, kUp, SeenFrom::kAbove), cap(0, -kUp, SeenFrom::kBelow)};
}

}  // namespace

std::vector<ShapePart> report_cube(double size) {
    ShapePart part{kGL_TRIANGLES, {}, {}};
    for (const int axis : {0, 1, 2}) {
        for (const double sign : {1.0, -1.0}) {
            // The face's normal, and two edges that turn counter-clockwise around it.
            glm::dvec3 normal(0), u(0), v(0);
            normal[axis] = sign;
            u[(axis + 1) % 3] = sign;
            v[(axis + 2) % 3] = 1;
            const auto corner = [&](double s, double t) {
                return ShapeVertex{size / 2 * (normal + s * u + t * v), normal};
            };
            const std::array quad{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
            for (const std::size_t i : {0, 1, 2, 2, 3, 0}) part.vertices.push_back(quad[i]);
        }
    }
    return {part};
}

std::vector<ShapePart> report_cylinder(double radius, double height, int slices) {
    std::vector<ShapePart> parts = caps(radius, height, slices);
    ShapePart side{kGL_TRIANGLE_STRIP, {}, {}};
    for (int i = 0; i <= slices; ++i) {
        const glm::dvec3 normal = around_y(i % slices, slices);
        side.vertices.push_back({radius * normal, normal});
        side.vertices.push_back({radius * normal + height * kUp, normal});
    }
    parts.push_back(std::move(side));
    return parts;
}

std::vector<ShapePart> report_cylinder_triangles(double radius, double height, int slices) {
    std::vector<ShapePart> parts = caps(radius, height, slices);
    ShapePart side{kGL_TRIANGLES, {}, {}};
    struct Corner {
        int step;
        double y;
    };
    const auto add_triangle = [&](const std::array<Corner, 3>& corners) {
        glm::dvec3 sum(0);
        for (const Corner& corner : corners) sum += around_y(corner.step % slices, slices);
        const glm::dvec3 normal = glm::normalize(sum);
        for (const auto& [step, y] : corners) {
            side.vertices.push_back({radius * around_y(step % slices, slices) + y * kUp, normal});
        }
    };
    for (int i = 0; i < slices; ++i) {
        add_triangle({{{i, 0}, {i, height}, {i + 1, 0}}});
        add_triangle({{{i + 1, 0}, {i, height}, {i + 1, height}}});
    }
    parts.push_back(std::move(side));
    return parts;
}

std::vector<ShapePart> report_cone(double radius, double height, int slices) {
    const ShapePart side = fan({height * kUp, kUp}, slices, SeenFrom::kAbove, [&](int i) {
        const glm::dvec3 outward = around_y(i, slices);
        return ShapeVertex{radius * outward, glm::normalize(outward + radius / height * kUp)};
    });
    const ShapePart base = fan({{0, 0, 0}, -kUp}, slices, SeenFrom::kBelow, [&](int i) {
        return ShapeVertex{radius * around_y(i, slices), -kUp};
    });
    return {side, base};
}

std::vector<ShapePart> report_sphere(double radius, int slices, int stacks) {
    // x = r cos theta sin phi, y = r cos phi, z = r sin theta sin phi; phi grows from the pole at +y.
    const auto vertex = [&](int stack, int i) {
        const double phi = std::numbers::pi * stack / stacks;
        const glm::dvec3 normal = std::sin(phi) * around_y(i % slices, slices) + std::cos(phi) * kUp;
        return ShapeVertex{radius * normal, normal};
    };

    std::vector<ShapePart> parts{
        fan({radius * kUp, kUp}, slices, SeenFrom::kAbove, [&](int i) { return vertex(1, i); })};
    for (int stack = 1; stack + 1 < stacks; ++stack) {
        ShapePart strip{kGL_TRIANGLE_STRIP, {}, {}};
        for (int i = 0; i <= slices; ++i) {
            strip.vertices.push_back(vertex(stack + 1, i));
            strip.vertices.push_back(vertex(stack, i));
        }
        parts.push_back(std::move(strip));
    }
    parts.push_back(fan({-radius * kUp, -kUp}, slices, SeenFrom::kBelow, [&](int i) { return vertex(stacks - 1, i); }));
    return parts;
}

}  // namespace twinlight
