// How far meshes are from their surfaces: an edge along a circle is inside it by r (1 - cos(pi / slices)).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "app/session/edits.h"
#include "app/session/mesh_error.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session::session_mesh_error_test {
namespace {

constexpr double kArithmetic = 1e-12;  // sines, cosines and roots of lengths near 1

MeshError error_of_shape(const std::string& text) {
    const Frame frame = make_frame(read_scene(text, "test.gl", "test"), StateOptions{});
    return mesh_error(frame, 0, frame.draws().size());
}

double sagitta(double radius, int slices) { return radius * (1 - std::cos(std::numbers::pi / slices)); }

TEST(SessionMeshError, IsTheSagittaOnACylinder) {
    EXPECT_NEAR(error_of_shape("#pragma twinlight shape(cylinder, 2, 3, 16)\n").distance, sagitta(2, 16), kArithmetic);
    EXPECT_NEAR(error_of_shape("glutSolidCylinder(1, 3, 12, 5);").distance, sagitta(1, 12), kArithmetic);
}

TEST(SessionMeshError, OnAConeIsTheSagittaTimesTheCosineOfItsSlope) {
    // Height 3 and radius 4: the side is inclined by atan(4/3), whose cosine is 3/5.
    EXPECT_NEAR(error_of_shape("#pragma twinlight shape(cone, 4, 3, 16)\n").distance, sagitta(4, 16) * 3 / 5,
                kArithmetic);
}

TEST(SessionMeshError, OnASphereIsThatOfItsCoarsestRing) {
    // With many stacks only the slices count: the middle of an edge on the equator.
    const MeshError error = error_of_shape("glutSolidSphere(2, 12, 200);");
    EXPECT_GE(error.distance, sagitta(2, 12) - kArithmetic);
    EXPECT_LE(error.distance, sagitta(2, 12) * 1.01);
    EXPECT_NEAR(error.of_size, error.distance / 2, 1e-6);  // the poles are at +-2
}

TEST(SessionMeshError, AQuarterForTwiceTheSlices) {
    for (const char* shape : {"glutSolidSphere(1, 24, 12);", "glutSolidTorus(0.3, 1, 24, 48);",
                              "GLUquadric* q = gluNewQuadric(); gluCylinder(q, 1, 0.5, 2, 24, 4);"}) {
        const CommandList coarse = read_scene(shape, "test.gl", "test");
        const Frame a = make_frame(coarse, StateOptions{}),
                    b = make_frame(change_tessellation(coarse, 2), StateOptions{});
        const double ratio = mesh_error(a, 0, a.draws().size()).distance / mesh_error(b, 0, b.draws().size()).distance;
        EXPECT_NEAR(ratio, 4, 0.15) << shape;  // the terms of higher order of 1 - cos(pi / 24)
    }
}

TEST(SessionMeshError, AShapeWithFlatFacesHasNone) { EXPECT_FALSE(error_of_shape("glutSolidCube(1);").has_surfaces); }

}  // namespace
}  // namespace twinlight::session::session_mesh_error_test
