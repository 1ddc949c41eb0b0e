// Shapes are what freeglut sends: mode by mode, vertex by vertex, against a recording of the real library.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "recording.h"
#include "scene/command/command.h"
#include "scene/shape/shape.h"
#include "xvfb.h"

namespace twinlight::freeglut_shapes_test {
namespace {

const std::vector<std::string> kCalls = {
    "glutSolidCube 1",
    "glutWireCube 1",
    "glutSolidCube 2.5",
    "glutWireCube 0.3",
    "glutSolidCube 0",
    "glutSolidCube -1",
    // slices, stacks: usual, odd, the least that draws, the most that does not
    "glutSolidSphere 1 16 12",
    "glutWireSphere 1 16 12",
    "glutSolidSphere 0.7 7 5",
    "glutWireSphere 0.7 7 5",
    "glutSolidSphere 1 64 32",
    "glutSolidSphere -2 5 3",
    "glutSolidSphere 1 1 2",
    "glutWireSphere 1 1 2",
    "glutSolidSphere 1 2 3",
    "glutSolidSphere 1 3 2",
    "glutWireSphere 1 3 2",
    "glutSolidSphere 1 0 5",
    "glutWireSphere 1 0 5",
    "glutSolidSphere 1 5 1",
    "glutWireSphere 1 5 1",
    "glutSolidSphere 1 5 0",
    "glutSolidSphere 1 5 -3",
    "glutSolidCone 1 2 16 8",
    "glutWireCone 1 2 16 8",
    "glutSolidCone 0.4 0.3 7 1",
    "glutWireCone 0.4 0.3 7 1",
    "glutSolidCone 1 1 1 1",
    "glutWireCone 1 1 1 1",
    "glutSolidCone 1 -2 5 3",
    "glutSolidCone 0 1 4 2",
    "glutSolidCone 1 0 4 2",
    "glutSolidCone 1 1 0 3",
    "glutSolidCone 1 1 5 0",
    "glutWireCone 1 1 5 -1",
    "glutSolidCylinder 1 2 16 4",
    "glutWireCylinder 1 2 16 4",
    "glutSolidCylinder 0.5 0.25 9 1",
    "glutWireCylinder 0.5 0.25 9 1",
    "glutSolidCylinder 1 1 1 1",
    "glutSolidCylinder 1 -1 5 2",
    "glutSolidCylinder 1 1 0 3",
    "glutWireCylinder 1 1 5 0",
    "glutSolidTorus 0.25 1 12 24",
    "glutWireTorus 0.25 1 12 24",
    "glutSolidTorus 0.3 0.5 5 7",
    "glutWireTorus 0.3 0.5 5 7",
    "glutSolidTorus 0.3 0.5 2 2",
    "glutWireTorus 0.3 0.5 2 2",
    "glutSolidTorus 1 0.5 3 4",
    "glutSolidTorus 0.3 0.5 1 5",
    "glutSolidTorus 0.3 0.5 5 1",
    "glutWireTorus 0.3 0.5 0 5",
    "glutWireTorus 0.3 0.5 5 -2",
    "glutSolidTetrahedron",
    "glutWireTetrahedron",
    "glutSolidOctahedron",
    "glutWireOctahedron",
    "glutSolidDodecahedron",
    "glutWireDodecahedron",
    "glutSolidIcosahedron",
    "glutWireIcosahedron",
    "glutSolidRhombicDodecahedron",
    "glutWireRhombicDodecahedron",
    "glutSolidSierpinskiSponge 3 0.5 -1 2 1.5",
    "glutWireSierpinskiSponge 3 0.5 -1 2 1.5",
    "glutSolidSierpinskiSponge 0 0 0 0 -1",
    "glutWireSierpinskiSponge 1 0 0 0 1",
    "glutSolidSierpinskiSponge 6 1 1 1 1",
    "glutSolidSierpinskiSponge -1 0 0 0 1",
    "glutWireSierpinskiSponge -1 0 0 0 1",
    "glutSolidTeapot 1",
    "glutWireTeapot 1",
    "glutSolidTeacup 1",
    "glutWireTeacup 1",
    "glutSolidTeaspoon 1",
    "glutWireTeaspoon 1",
    // another size keeps the first one's normals
    "glutSolidTeapot 0.3",
    "glutSolidTeacup 12",
    "glutWireTeaspoon 0",
    "glutSolidTeapot -2",
    // beyond 65535 vertices the 16-bit indices wrap
    "glutSolidSphere 1 300 220",
    "glutSolidTorus 0.3 1 300 220",
};

Command parse(const std::string& call) {
    std::istringstream words(call);
    std::string name;
    words >> name;
    Command command;
    command.id = find_command(name).value();
    for (double argument = 0; words >> argument;) command.arguments.push_back(argument);
    return command;
}

constexpr double kHalfUlp = 0x1p-24;

// "Sphere" of glutSolidSphere and glutWireSphere.
std::string_view kind_of(const Command& command) {
    const std::string_view name = command.name();
    return name.substr(std::string_view(name.starts_with("glutSolid") ? "glutSolid" : "glutWire").size());
}

bool is_of_tea_set(std::string_view kind) { return kind == "Teapot" || kind == "Teacup" || kind == "Teaspoon"; }

bool has_counts(std::string_view kind) {
    return kind == "Sphere" || kind == "Cone" || kind == "Cylinder" || kind == "Torus";
}

// The sum of the lengths among the arguments.
double size_of(const Command& command) {
    const std::string_view kind = kind_of(command);
    double size = command.arguments.empty() ? 1 : 0;
    for (std::size_t i = kind == "SierpinskiSponge" ? 1 : 0; i + (has_counts(kind) ? 2 : 0) < command.arguments.size();
         ++i) {
        size += std::abs(command.number(i));
    }
    return size;
}

// What freeglut's floats can differ from doubles by, relative to the shape's size.
double float_tolerance(const Command& command) {
    const std::string_view kind = kind_of(command);
    if (!has_counts(kind)) {
        // The table's number, size or offset, their product, their sum.
        constexpr double kProduct = 4 * kHalfUlp;
        return kProduct;
    }
    // An angle is float(pi) / n * i: one rounding each of pi, the quotient and the product.
    constexpr double kAngle = 2 * std::numbers::pi * 3 * kHalfUlp;
    // cos and sin rounded, times one another, times the radius, itself rounded.
    constexpr double kProducts = 5 * kHalfUlp;
    // A cone or cylinder climbs by adding a rounded step for each stack.
    const bool climbs = kind == "Cone" || kind == "Cylinder";
    const double stacks = climbs ? std::abs(command.arguments.back()) : 0;
    return kAngle + kProducts + 2 * stacks * kHalfUlp;
}

// ---- The tea set ----

// Bernstein polynomials: 4 roundings; control points: 3; two sums of four products: 5 each, with weights of 4 each.
constexpr double kPatchRoundings = 3 + 2 * (4 + 5);
constexpr double kLargestPoint = 1.8;  // of the control points, for size 1

// The vertices of each patch's grid, row by row, from the solid's or the wires' parts.
class Grids {
  public:
    Grids(const std::vector<ShapePart>& parts, bool wire) : wire_(wire), side_(wire ? 10 : 8) {
        for (std::size_t p = 0; p < (wire ? parts.size() / 2 : 1); ++p) {  // wires: the columns come first
            for (const ShapeVertex& v : parts[p].vertices) points_.push_back(v.position_object);
        }
        columns_ = wire ? parts.size() / 2 : 0;
        if (!wire) indices_ = parts.front().indices;
    }

    // How far apart the two tangents' lines are at a vertex, over the least of the cells that it is a corner of: the normal turns
    // by an error of a tangent over this. 0 where the grid has no area.
    double height(std::size_t part, std::size_t vertex) const {
        if (!wire_) return height_at(indices_[vertex]);
        const bool along_column = part < columns_;
        const std::size_t line = along_column ? part : part - columns_;
        const std::size_t grid = line / side_, i = line % side_;
        // Points are stored column by column.
        return height_at(grid * side_ * side_ + (along_column ? i * side_ + vertex : vertex * side_ + i));
    }

  private:
    double height_at(std::size_t index) const {
        const std::size_t row = index / side_ % side_, column = index % side_;
        const auto step = [&](bool forward, std::size_t stride) {
            return points_[forward ? index + stride : index - stride] - points_[index];
        };
        double least = 1e9;
        for (const bool down : {false, true}) {
            for (const bool right : {false, true}) {
                if ((down ? row + 1 == side_ : row == 0) || (right ? column + 1 == side_ : column == 0)) continue;
                const glm::dvec3 a = step(down, side_), b = step(right, 1);
                least = std::min(least, glm::length(glm::cross(a, b)) / (glm::length(a) + glm::length(b)));
            }
        }
        return least;
    }

    bool wire_;
    std::size_t side_;
    std::size_t columns_ = 0;
    std::vector<glm::dvec3> points_;
    std::vector<std::uint32_t> indices_;
};

double expect_same_tea_set(const Command& command, const RecordedCall& recording) {
    const std::vector<ShapePart> parts = shape_parts(command);
    const double size = size_of(command);
    const double position = kPatchRoundings * kHalfUlp * kLargestPoint * size;
    // The weights of a tangent add up to 6; one step of the grid is a seventh or a ninth of it. Normals are those of size 1.
    constexpr double kStep = 6 * kPatchRoundings * kHalfUlp * kLargestPoint / 7;
    const Grids grids(shape_parts({command.id, {1}, {}}), command.name().starts_with("glutWire"));
    return expect_same(sent_parts(parts), recording.parts, [&](std::size_t p, std::size_t i) {
        constexpr double kAnyNormal = 2;
        return Tolerance{position, std::min(kStep / grids.height(p, i), kAnyNormal), kHalfUlp};
    });
}

class FreeglutShapes : public testing::Test {
  protected:
    void SetUp() override {
        if (!server_.running()) GTEST_SKIP() << server_.reason();
    }
    Xvfb server_;
};

TEST_F(FreeglutShapes, AreWhatTheLibrarySends) {
    const std::vector<RecordedCall> recordings = record(kCalls, server_.display());
    ASSERT_EQ(recordings.size(), kCalls.size());
    double worst = 0;
    for (const RecordedCall& recording : recordings) {
        SCOPED_TRACE(recording.call);
        const Command command = parse(recording.call);
        if (is_of_tea_set(kind_of(command))) {
            worst = std::max(worst, expect_same_tea_set(command, recording));
            continue;
        }
        const double tolerance = float_tolerance(command);
        worst = std::max(worst, expect_same(sent_parts(shape_parts(command)), recording.parts, [&](auto, auto) {
                             return Tolerance{tolerance * size_of(command), tolerance, tolerance};
                         }));
    }
    // The bound is not slack: freeglut's floats are really seen.
    EXPECT_GT(worst, 0.05);
    RecordProperty("worst", fmt::format("{:.2g}", worst));
}

}  // namespace
}  // namespace twinlight::freeglut_shapes_test
