// Shapes, tested by derivation: unit normals, positions on the surface, orientation, closed surfaces, order of
// vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scene/command/command.h"
#include "scene/shape/shape.h"

namespace twinlight::shapes_test {
namespace {

using Triangle = std::array<ShapeVertex, 3>;

constexpr double kRounding = 1e-14;  // a few roundings of double on lengths near 1

Command shape(CommandId id, std::vector<double> arguments) { return {id, std::move(arguments), {}}; }
Command pragma(Word kind, std::vector<double> sizes) {
    sizes.insert(sizes.begin(), static_cast<double>(static_cast<Enum>(kind)));
    return shape(CommandId::pragma_shape, std::move(sizes));
}

ShapeVertex sent(const ShapePart& part, std::size_t i) {
    return part.vertices[part.indices.empty() ? i : part.indices[i]];
}
std::size_t sent_count(const ShapePart& part) {
    return part.indices.empty() ? part.vertices.size() : part.indices.size();
}

// The triangles of a part with GL's orientation (2.6.1): every second triangle of a strip is swapped.
std::vector<Triangle> triangles(const ShapePart& part) {
    std::vector<Triangle> result;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        result.push_back({sent(part, a), sent(part, b), sent(part, c)});
    };
    const std::size_t n = sent_count(part);
    if (part.mode == kGL_TRIANGLES) {
        EXPECT_EQ(n % 3, 0u);
        for (std::size_t i = 0; i + 2 < n; i += 3) add(i, i + 1, i + 2);
    } else if (part.mode == kGL_TRIANGLE_STRIP) {
        for (std::size_t i = 0; i + 2 < n; ++i) i % 2 == 0 ? add(i, i + 1, i + 2) : add(i + 1, i, i + 2);
    } else if (part.mode == kGL_QUAD_STRIP) {
        for (std::size_t i = 0; i + 3 < n; i += 2) add(i, i + 1, i + 3), add(i, i + 3, i + 2);
    } else {
        EXPECT_EQ(part.mode, kGL_TRIANGLE_FAN);
        for (std::size_t i = 1; i + 1 < n; ++i) add(0, i, i + 1);
    }
    return result;
}

std::vector<Triangle> triangles(const std::vector<ShapePart>& parts) {
    std::vector<Triangle> result;
    for (const ShapePart& part : parts) {
        for (const Triangle& triangle : triangles(part)) result.push_back(triangle);
    }
    return result;
}

glm::dvec3 area_vector(const Triangle& t) {
    return glm::cross(t[1].position_object - t[0].position_object, t[2].position_object - t[0].position_object) / 2.0;
}

// Corners at the same position count as one point of the surface.
class Points {
  public:
    std::size_t number(const glm::dvec3& position) {
        constexpr double kApart = 1e-9;
        const std::array<std::int64_t, 3> key{std::llround(position.x / kApart), std::llround(position.y / kApart),
                                              std::llround(position.z / kApart)};
        return numbers_.try_emplace(key, numbers_.size()).first->second;
    }
    std::size_t count() const { return numbers_.size(); }

  private:
    std::map<std::array<std::int64_t, 3>, std::size_t> numbers_;
};

struct Topology {
    bool closed = true;  // each edge also occurs exactly once in the opposite direction
    int euler = 0;       // points - edges + faces: 2 for a sphere, 0 for a torus
};

Topology topology(const std::vector<ShapePart>& parts) {
    Points points;
    std::set<std::pair<std::size_t, std::size_t>> edges;
    Topology result;
    int faces = 0;
    for (const Triangle& triangle : triangles(parts)) {
        if (glm::length(area_vector(triangle)) < 1e-12) continue;  // at a pole a strip has triangles without area
        ++faces;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = points.number(triangle[i].position_object);
            const std::size_t to = points.number(triangle[(i + 1) % 3].position_object);
            if (!edges.emplace(from, to).second) result.closed = false;
        }
    }
    for (const auto& [from, to] : edges) result.closed = result.closed && edges.contains({to, from});
    result.euler = static_cast<int>(points.count()) - static_cast<int>(edges.size() / 2) + faces;
    return result;
}

double volume(const std::vector<ShapePart>& parts) {
    double sum = 0;
    for (const Triangle& t : triangles(parts)) {
        sum += glm::dot(t[0].position_object, glm::cross(t[1].position_object, t[2].position_object)) / 6;
    }
    return sum;
}

const std::vector<Command> kSolids = {
    shape(CommandId::glutSolidSphere, {1.5, 7, 5}),
    shape(CommandId::glutSolidCube, {2}),
    shape(CommandId::glutSolidCone, {1, 2, 9, 4}),
    shape(CommandId::glutSolidCylinder, {0.5, 2, 9, 3}),
    shape(CommandId::glutSolidTorus, {0.25, 1, 6, 11}),
    shape(CommandId::glutSolidTetrahedron, {}),
    shape(CommandId::glutSolidOctahedron, {}),
    shape(CommandId::glutSolidDodecahedron, {}),
    shape(CommandId::glutSolidIcosahedron, {}),
    shape(CommandId::glutSolidRhombicDodecahedron, {}),
    pragma(Word::cube, {2}),
    pragma(Word::cylinder, {0.5, 2, 9}),
    pragma(Word::cylinder_triangles, {0.5, 2, 9}),
    pragma(Word::cone, {1, 2, 9}),
    pragma(Word::sphere, {1.5, 7, 5}),
    pragma(Word::sphere, {1, 3, 2}),
};

std::string label(const Command& command) {
    std::string text(command.id == CommandId::pragma_shape ? word_name(command.word(0)) : command.name());
    for (const double argument : command.arguments) text += " " + std::to_string(argument);
    return text;
}

TEST(Shapes, HaveUnitNormalsButForTwoOfFreegluts) {
    for (const Command& solid : kSolids) {
        SCOPED_TRACE(label(solid));
        for (const ShapePart& part : shape_parts(solid)) {
            for (const ShapeVertex& v : part.vertices) {
                double length = 1;
                // Twice the area of a face, sqrt(3)/2 of its edge squared.
                const double edge_squared = 16 / (10 + 2 * std::sqrt(5.0));
                if (solid.id == CommandId::glutSolidIcosahedron) length = std::sqrt(3.0) / 2 * edge_squared;
                // Faces that touch neither tip have unit normals; freeglut's other normals are shorter.
                if (solid.id == CommandId::glutSolidRhombicDodecahedron && v.normal_object.z != 0)
                    length = std::sqrt(0.5);
                EXPECT_NEAR(glm::length(v.normal_object), length, kRounding);
            }
        }
    }
}

TEST(Shapes, WithFlatFacesHaveNormalsAtRightAnglesToThem) {
    for (const CommandId id :
         {CommandId::glutSolidTetrahedron, CommandId::glutSolidOctahedron, CommandId::glutSolidDodecahedron,
          CommandId::glutSolidIcosahedron, CommandId::glutSolidRhombicDodecahedron}) {
        for (const Triangle& triangle : triangles(shape_parts(shape(id, {})))) {
            const glm::dvec3 area = area_vector(triangle);
            for (const ShapeVertex& corner : triangle) {
                EXPECT_LE(glm::length(glm::cross(area, corner.normal_object)), kRounding);
            }
        }
    }
}

TEST(Shapes, AreClosedAndWoundAlike) {
    for (const Command& solid : kSolids) {
        SCOPED_TRACE(label(solid));
        const Topology found = topology(shape_parts(solid));
        EXPECT_TRUE(found.closed);
        EXPECT_EQ(found.euler, solid.id == CommandId::glutSolidTorus ? 0 : 2);
        EXPECT_GT(volume(shape_parts(solid)), 0);  // counter-clockwise seen from outside
    }
}

TEST(Shapes, HaveNormalsOnTheSideThatTheirTrianglesFace) {
    for (const Command& solid : kSolids) {
        SCOPED_TRACE(label(solid));
        for (const Triangle& triangle : triangles(shape_parts(solid))) {
            if (glm::length(area_vector(triangle)) < 1e-12) continue;
            for (const ShapeVertex& corner : triangle) {
                EXPECT_GT(glm::dot(area_vector(triangle), corner.normal_object), 0);
            }
        }
    }
}

// The volume of a prism over a regular polygon of n corners, and of a pyramid: the vertices are exactly on the surface.
TEST(Shapes, EncloseWhatTheirSizesSay) {
    const auto polygon = [](double radius, int n) {
        return n * radius * radius * std::sin(2 * std::numbers::pi / n) / 2;
    };
    EXPECT_NEAR(volume(shape_parts(shape(CommandId::glutSolidCube, {2}))), 8, 8 * kRounding);
    EXPECT_NEAR(volume(shape_parts(pragma(Word::cube, {2}))), 8, 8 * kRounding);
    EXPECT_NEAR(volume(shape_parts(shape(CommandId::glutSolidCylinder, {0.5, 2, 9, 3}))), 2 * polygon(0.5, 9),
                kRounding);
    EXPECT_NEAR(volume(shape_parts(pragma(Word::cylinder, {0.5, 2, 9}))), 2 * polygon(0.5, 9), kRounding);
    EXPECT_NEAR(volume(shape_parts(pragma(Word::cylinder_triangles, {0.5, 2, 9}))), 2 * polygon(0.5, 9), kRounding);
    EXPECT_NEAR(volume(shape_parts(shape(CommandId::glutSolidCone, {1, 3, 9, 4}))), polygon(1, 9), 3 * kRounding);
    EXPECT_NEAR(volume(shape_parts(pragma(Word::cone, {1, 3, 9}))), polygon(1, 9), 3 * kRounding);
}

TEST(Shapes, OfSpheresLieOnThemWithTheirNormalsAlongTheRadius) {
    for (const Command& sphere : {shape(CommandId::glutSolidSphere, {1.5, 7, 5}), pragma(Word::sphere, {1.5, 7, 5})}) {
        for (const ShapePart& part : shape_parts(sphere)) {
            for (const ShapeVertex& v : part.vertices) {
                EXPECT_LE(glm::distance(v.position_object, 1.5 * v.normal_object), 1.5 * kRounding);
            }
        }
    }
}

// (sqrt(x^2 + y^2) - outer)^2 + z^2 = inner^2, and the normal points away from the tube's centre.
TEST(Shapes, OfToriLieOnThem) {
    for (const ShapePart& part : shape_parts(shape(CommandId::glutSolidTorus, {0.25, 1, 6, 11}))) {
        for (const ShapeVertex& v : part.vertices) {
            const glm::dvec3& p = v.position_object;
            const double from_axis = std::hypot(p.x, p.y);
            const glm::dvec3 tube_centre(p.x / from_axis, p.y / from_axis, 0);
            EXPECT_LE(glm::distance(p - tube_centre, 0.25 * v.normal_object), kRounding);
        }
    }
}

// The side of a cone has the slope -h / r; its normal has the slope r / h and is perpendicular to it.
TEST(Shapes, OfConesHaveNormalsAtRightAnglesToTheSlant) {
    const ShapePart side = shape_parts(pragma(Word::cone, {1, 2, 8})).front();
    for (std::size_t i = 1; i < side.vertices.size(); ++i) {
        const ShapeVertex& v = side.vertices[i];
        EXPECT_NEAR(glm::dot(v.normal_object, glm::dvec3(0, 2, 0) - v.position_object), 0, kRounding);
        EXPECT_NEAR(v.normal_object.y / std::hypot(v.normal_object.x, v.normal_object.z), 0.5, kRounding);
    }
    EXPECT_EQ(side.vertices.front().position_object, glm::dvec3(0, 2, 0));
    EXPECT_EQ(side.vertices.front().normal_object, glm::dvec3(0, 1, 0));

    // freeglut's cone has the same slope along z.
    for (const ShapePart& part : shape_parts(shape(CommandId::glutSolidCone, {1, 2, 8, 3}))) {
        for (const ShapeVertex& v : part.vertices) {
            if (v.normal_object.z < 0) continue;  // the base
            EXPECT_NEAR(v.normal_object.z / std::hypot(v.normal_object.x, v.normal_object.y), 0.5, kRounding);
        }
    }
}

struct Batch {
    Enum mode;
    std::size_t count;
    friend bool operator==(const Batch&, const Batch&) = default;
};

std::vector<Batch> batches(const std::vector<ShapePart>& parts) {
    std::vector<Batch> result;
    for (const ShapePart& part : parts) result.push_back({part.mode, sent_count(part)});
    return result;
}

TEST(ReportShapes, AreOfTheReportsPrimitives) {
    constexpr Enum kFan = kGL_TRIANGLE_FAN, kStrip = kGL_TRIANGLE_STRIP;
    EXPECT_EQ(batches(shape_parts(pragma(Word::cube, {1}))), (std::vector<Batch>{{kGL_TRIANGLES, 36}}));
    // A fan has its centre and a closed circle; the side's strip has two vertices for each point of the circle.
    EXPECT_EQ(batches(shape_parts(pragma(Word::cylinder, {1, 1, 8}))),
              (std::vector<Batch>{{kFan, 10}, {kFan, 10}, {kStrip, 18}}));
    EXPECT_EQ(batches(shape_parts(pragma(Word::cylinder_triangles, {1, 1, 8}))),
              (std::vector<Batch>{{kFan, 10}, {kFan, 10}, {kGL_TRIANGLES, 48}}));
    EXPECT_EQ(batches(shape_parts(pragma(Word::cone, {1, 1, 8}))), (std::vector<Batch>{{kFan, 10}, {kFan, 10}}));
    EXPECT_EQ(batches(shape_parts(pragma(Word::sphere, {1, 8, 5}))),
              (std::vector<Batch>{{kFan, 10}, {kStrip, 18}, {kStrip, 18}, {kStrip, 18}, {kFan, 10}}));
}

TEST(ReportShapes, StandOnTheOriginAndAreTallAlongY) {
    for (const Command& tall : {pragma(Word::cylinder, {1, 3, 8}), pragma(Word::cone, {1, 3, 8})}) {
        double lowest = 1e9, highest = -1e9;
        for (const ShapePart& part : shape_parts(tall)) {
            for (const ShapeVertex& v : part.vertices) {
                lowest = std::min(lowest, v.position_object.y);
                highest = std::max(highest, v.position_object.y);
            }
        }
        EXPECT_EQ(lowest, 0);
        EXPECT_EQ(highest, 3);
    }
}

// Figure 3: along the side the strip's normals turn in equal steps, those of the separate triangles alternately by one
// third and two thirds of a slice.
TEST(ReportShapes, OfLoneTrianglesAreShadedUnevenly) {
    constexpr int kSlices = 12;
    constexpr double kSlice = 2 * std::numbers::pi / kSlices;
    const ShapePart side = shape_parts(pragma(Word::cylinder_triangles, {1, 1, kSlices})).back();
    const std::vector<Triangle> teeth = triangles(side);
    ASSERT_EQ(teeth.size(), 2u * kSlices);
    for (std::size_t i = 0; i + 1 < teeth.size(); ++i) {
        EXPECT_EQ(teeth[i][0].normal_object, teeth[i][1].normal_object);
        EXPECT_EQ(teeth[i][0].normal_object, teeth[i][2].normal_object);
        const double turn = std::acos(glm::dot(teeth[i][0].normal_object, teeth[i + 1][0].normal_object));
        // The mean of two normals at one border and one at the other is about a third of the way.
        EXPECT_NEAR(turn, i % 2 == 0 ? kSlice / 3 : kSlice * 2 / 3, 0.02 * kSlice);
    }
}

// Table 2.12: vertex i+2 colours triangle i of a strip or fan when flat shaded.
TEST(Shapes, HaveTheProvokingVerticesOfTheirOrder) {
    // freeglut's sphere: lower ring first, so the first triangle between two rings takes its colour from the lower one.
    const std::vector<ShapePart> sphere = shape_parts(shape(CommandId::glutSolidSphere, {1, 4, 4}));
    ASSERT_EQ(sphere.size(), 4u);
    EXPECT_NEAR(sent(sphere[1], 0).position_object.z, 0, kRounding);
    EXPECT_NEAR(sent(sphere[1], 1).position_object.z, std::sqrt(0.5), kRounding);
    EXPECT_LE(glm::distance(sent(sphere[1], 2).position_object, glm::dvec3(0, -1, 0)),
              kRounding);  // clockwise
    // In the top strip, each triangle with area has its last vertex on the ring, never at the pole.
    EXPECT_EQ(sent(sphere[0], 1).position_object, glm::dvec3(0, 0, 1));
    EXPECT_NEAR(sent(sphere[0], 2).position_object.z, std::sqrt(0.5), kRounding);

    // A face of glut's cube: the last vertex of its triangles.
    const ShapePart cube = shape_parts(shape(CommandId::glutSolidCube, {2})).front();
    EXPECT_EQ(sent(cube, 2).position_object, glm::dvec3(-1, -1, 1));
    EXPECT_EQ(sent(cube, 5).position_object, glm::dvec3(1, -1, 1));
}

TEST(FreeglutShapesOfNoCount, GiveNoParts) {
    for (const Command& nothing :
         {shape(CommandId::glutSolidSphere, {1, 0, 8}), shape(CommandId::glutSolidSphere, {1, 8, 1}),
          shape(CommandId::glutSolidSphere, {1, -8, 8}), shape(CommandId::glutWireSphere, {1, 8, -8}),
          shape(CommandId::glutSolidCone, {1, 1, -3, 1}), shape(CommandId::glutWireCone, {1, 1, 3, 0}),
          shape(CommandId::glutSolidCylinder, {1, 1, -2e9, 1}), shape(CommandId::glutWireCylinder, {1, 1, 0, 1}),
          shape(CommandId::glutSolidTorus, {1, 2, 1, 8}), shape(CommandId::glutWireTorus, {1, 2, 8, -2e9})}) {
        EXPECT_TRUE(shape_parts(nothing).empty()) << label(nothing);
    }
}

TEST(FreeglutShapesOfNoSize, HaveNoNanInThem) {
    for (const ShapePart& part : shape_parts(shape(CommandId::glutSolidCone, {0, 0, 5, 2}))) {
        for (const ShapeVertex& v : part.vertices) EXPECT_FALSE(std::isnan(glm::length(v.normal_object)));
    }
}

std::string refusal(const Command& command) {
    try {
        shape_parts(command);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(ShapeArguments, ThatMakeNoSenseAreRefusedWithTheRemedy) {
    EXPECT_EQ(refusal(pragma(Word::cube, {})), "shape(cube, size) needs 1 size, not 0");
    EXPECT_EQ(refusal(pragma(Word::cube, {0})), "size of shape(cube, size) is 0; it must be greater than 0");
    EXPECT_EQ(refusal(pragma(Word::sphere, {1, 8, 1})),
              "stacks of shape(sphere, radius, slices, stacks) is 1; it must be a whole number of 2 or more");
    EXPECT_EQ(refusal(pragma(Word::cone, {1, 2, 3.5})),
              "slices of shape(cone, radius, height, slices) is 3.5; it must be a whole number of 3 or more");
    EXPECT_EQ(refusal(pragma(Word::reflection, {})),
              "reflection is not a shape; expected cube, cylinder, cylinder_triangles, cone or sphere");
    EXPECT_EQ(refusal(shape(CommandId::glutSolidSphere, {1, 2e9, 2e9})),
              "glutSolidSphere would have more than 8000000 vertices; use fewer slices or stacks");
    EXPECT_NE(refusal(pragma(Word::sphere, {1, 1e300, 4})), "accepted");
    EXPECT_NE(refusal(pragma(Word::sphere, {std::nan(""), 8, 4})), "accepted");
    EXPECT_NE(refusal(pragma(Word::sphere, {1, std::nan(""), 4})), "accepted");
}

}  // namespace
}  // namespace twinlight::shapes_test
