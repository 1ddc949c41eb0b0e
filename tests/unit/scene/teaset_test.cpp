// Newell's tea set: position, orientation, symmetry, and the texture coordinates of its patches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/shape/freeglut_shapes.h"

namespace twinlight::teaset_test {
namespace {

constexpr std::size_t kPatch = 8 * 8;  // vertices per patch of a solid

std::vector<ShapePart> solids() {
    return {freeglut_teapot(1, false).front(), freeglut_teacup(1, false).front(), freeglut_teaspoon(1, false).front()};
}

// The data are exactly symmetric in their five decimals.
constexpr double kDigits = 1e-5;

bool has_vertex_near(const std::vector<ShapeVertex>& vertices, const glm::dvec3& position) {
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](const ShapeVertex& v) { return glm::distance(v.position_object, position) <= kDigits; });
}

TEST(TeaSet, IsAsHighAsItsDataSay) {
    // The pot reaches from z = 0 to the top of the lid at 3.15; half of that is one unit of size.
    double lowest = 1e9, highest = -1e9;
    const ShapePart teapot = freeglut_teapot(2, false).front();
    for (const ShapeVertex& v : teapot.vertices) {
        lowest = std::min(lowest, v.position_object.y);
        highest = std::max(highest, v.position_object.y);
    }
    EXPECT_NEAR(lowest, -1.575, 1e-14);
    EXPECT_NEAR(highest, 1.575, 1e-14);
}

TEST(TeaSet, LooksOutwardClockwise) {
    for (const ShapePart& part : solids()) {
        double volume = 0;
        for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
            const ShapeVertex& a = part.vertices[part.indices[i]];
            const ShapeVertex& b = part.vertices[part.indices[i + 1]];
            const ShapeVertex& c = part.vertices[part.indices[i + 2]];
            const glm::dvec3 area =
                glm::cross(b.position_object - a.position_object, c.position_object - a.position_object) / 2.0;
            volume += glm::dot(a.position_object, glm::cross(b.position_object, c.position_object)) / 6;
            // Tiny triangles at the top of the lid and the tip of the spoon are folded.
            constexpr double kSpeck = 1e-5;
            if (glm::length(area) < kSpeck) continue;
            EXPECT_LT(glm::dot(area, a.normal_object + b.normal_object + c.normal_object), 0) << "triangle " << i / 3;
        }
        EXPECT_LT(volume, 0);
    }
}

TEST(TeaSet, IsTheSameAfterAQuarterTurnButForHandleAndSpout) {
    const auto check = [](const ShapePart& part, std::size_t turned_patches) {
        const std::vector<ShapeVertex> body(
            part.vertices.begin(), part.vertices.begin() + static_cast<std::ptrdiff_t>(turned_patches * kPatch));
        for (std::size_t i = 0; i < body.size(); i += 7) {
            const glm::dvec3& p = body[i].position_object;
            EXPECT_TRUE(has_vertex_near(body, {p.z, p.y, -p.x})) << "vertex " << i;
        }
    };
    check(freeglut_teapot(1, false).front(), 24);
    check(freeglut_teacup(1, false).front(), 24);
}

TEST(TeaSet, OfPotAndCupIsTheSameInTheMirror) {
    for (const ShapePart& part : {freeglut_teapot(1, false).front(), freeglut_teacup(1, false).front()}) {
        for (std::size_t i = 0; i < part.vertices.size(); i += 5) {
            const glm::dvec3& p = part.vertices[i].position_object;
            EXPECT_TRUE(has_vertex_near(part.vertices, {p.x, p.y, -p.z})) << "vertex " << i;
        }
    }
}

TEST(TeaSet, HasUnitNormalsOrNoneWhereAPatchIsPinched) {
    int pinched = 0;
    for (const ShapePart& part : solids()) {
        for (const ShapeVertex& v : part.vertices) {
            const double length = glm::length(v.normal_object);
            if (length == 0) {
                ++pinched;
            } else {
                EXPECT_NEAR(length, 1, 1e-14);
            }
        }
    }
    EXPECT_EQ(pinched,
              6);  // corners of the last four patches, at the end of the spoon, where two control points coincide
}

TEST(TeaSet, HasOneTextureOverEachPatch) {
    for (const ShapePart& part : solids()) {
        EXPECT_TRUE(part.sends_tex_coords);
        for (std::size_t first = 0; first < part.vertices.size(); first += kPatch) {
            EXPECT_EQ(part.vertices[first].tex_coord, glm::dvec2(0, 0));
            EXPECT_EQ(part.vertices[first + 7].tex_coord, glm::dvec2(0, 1));
            EXPECT_EQ(part.vertices[first + 56].tex_coord, glm::dvec2(1, 0));
            EXPECT_EQ(part.vertices[first + 63].tex_coord, glm::dvec2(1, 1));
        }
    }
    for (const ShapePart& part : freeglut_teapot(1, true)) EXPECT_FALSE(part.sends_tex_coords);
}

TEST(TeaSet, KeepsItsNormalsWhateverItsSize) {
    const ShapePart one = freeglut_teapot(1, false).front();
    for (const double size : {0.0, -2.0, 1e-200}) {
        const ShapePart other = freeglut_teapot(size, false).front();
        for (std::size_t i = 0; i < one.vertices.size(); ++i) {
            EXPECT_EQ(other.vertices[i].normal_object, one.vertices[i].normal_object);
            EXPECT_EQ(other.vertices[i].position_object, size * one.vertices[i].position_object);
        }
    }
}

}  // namespace
}  // namespace twinlight::teaset_test
