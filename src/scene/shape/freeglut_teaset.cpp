// freeglut 3.4's teapot, teacup and teaspoon (its src/fg_teapot.c): Bezier patches, each evaluated on a grid of 8 x 8
// vertices for a solid and 10 x 10 for wires.
//
// A solid is one GL_TRIANGLES with two triangles per cell of the grid. Seen from outside they are clockwise, so
// programs may need glFrontFace(GL_CW). Wires are one GL_LINE_STRIP for each row and column of each grid.
#include <array>
#include <glm/geometric.hpp>

#include "base/math/directions.h"
#include "scene/shape/freeglut_shapes.h"
#include "scene/shape/teaset_patches.h"

namespace twinlight {
namespace {

struct Teaset {
    const BezierPatches& patches;
    double size;
    double z_offset;  // the height that moves to the origin
    bool copies;      // the first patches are rotated to all four quadrants, the others mirrored
    bool has_poles;   // the first rows of patches 3 and 5 are single points: the top and the bottom
};

constexpr std::size_t kQuarterPatches = 6;
constexpr std::size_t kTopPatch = 3, kBottomPatch = 5;

using Row = std::array<double, 4>;

// The cubic Bernstein polynomials at x, and their derivatives.
Row bernstein(double x) {
    const double y = 1 - x;
    return {y * y * y, 3 * x * y * y, 3 * x * x * y, x * x * x};
}
Row bernstein_derivative(double x) {
    const double y = 1 - x;
    return {-3 * y * y, 3 * y * y - 6 * x * y, 6 * x * y - 3 * x * x, 3 * x * x};
}

// The sum over rows i and columns j of u_i v_j p_ij.
glm::dvec3 weighted(const std::array<glm::dvec3, 16>& points, const Row& u, const Row& v) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < 16; ++i) sum += u[i / 4] * v[i % 4] * points[i];
    return sum;
}

// The vertices of a patch, row by row.
class Grid {
  public:
    explicit Grid(std::size_t side) : side_(side), vertices_(side * side) {}

    static Grid of_patch(const std::array<glm::dvec3, 16>& points, std::size_t side) {
        Grid grid(side);
        const double last = static_cast<double>(side - 1);
        for (std::size_t i = 0; i < grid.vertices_.size(); ++i) {
            const std::size_t row = i / side, column = i % side;
            const double u = static_cast<double>(row) / last, v = static_cast<double>(column) / last;
            const glm::dvec3 along_v = weighted(points, bernstein(u), bernstein_derivative(v));
            const glm::dvec3 along_u = weighted(points, bernstein_derivative(u), bernstein(v));
            // RULING: the normal is 0 where a patch has none (freeglut divides 0 by 0).
            grid.vertices_[i] = {
                weighted(points, bernstein(u), bernstein(v)), unit(glm::cross(along_v, along_u)), {u, v}};
        }
        return grid;
    }

    // Normals do not depend on the size, as in freeglut.
    void scale(double size) {
        for (ShapeVertex& vertex : vertices_) vertex.position_object *= size;
    }

    // If the first row is a single point, it has no tangent, so its normals cannot be computed.
    void set_normals_of_first_row(const glm::dvec3& normal) {
        for (std::size_t i = 0; i < side_; ++i) vertices_[i].normal_object = normal;
    }

    // The grid rotated by `quarters` * 90 degrees around y.
    Grid turned(int quarters) const {
        Grid grid = *this;
        for (ShapeVertex& vertex : grid.vertices_) {
            for (glm::dvec3* v : {&vertex.position_object, &vertex.normal_object}) {
                for (int i = 0; i < quarters; ++i) *v = {v->z, v->y, -v->x};
            }
        }
        return grid;
    }

    // The grid mirrored in z. The rows are reversed, so that triangles keep their orientation; texture coordinates
    // stay.
    Grid mirrored() const {
        Grid grid = *this;
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const ShapeVertex& from = vertices_[(side_ - 1 - i / side_) * side_ + i % side_];
            grid.vertices_[i].position_object = from.position_object * glm::dvec3(1, 1, -1);
            grid.vertices_[i].normal_object = from.normal_object * glm::dvec3(1, 1, -1);
        }
        return grid;
    }

    const std::vector<ShapeVertex>& vertices() const { return vertices_; }
    const ShapeVertex& at(std::size_t row, std::size_t column) const { return vertices_[row * side_ + column]; }

  private:
    std::size_t side_;
    std::vector<ShapeVertex> vertices_;
};

std::vector<Grid> grids(const Teaset& set, std::size_t side) {
    std::vector<Grid> result;
    for (std::size_t p = 0; p < set.patches.patches.size(); ++p) {
        std::array<glm::dvec3, 16> points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec3& point = set.patches.points[set.patches.patches[p][i]];
            points[i] = glm::dvec3(point.x, point.z - set.z_offset, -point.y) / 2.0;
        }
        Grid grid = Grid::of_patch(points, side);
        grid.scale(set.size);
        if (set.has_poles && p == kTopPatch) grid.set_normals_of_first_row({0, 1, 0});
        if (set.has_poles && p == kBottomPatch) grid.set_normals_of_first_row({0, -1, 0});
        result.push_back(grid);
        if (!set.copies) continue;
        if (p < kQuarterPatches) {
            for (const int quarters : {1, 2, 3}) result.push_back(grid.turned(quarters));
        } else {
            result.push_back(grid.mirrored());
        }
    }
    return result;
}

std::vector<ShapePart> solid(const Teaset& set) {
    constexpr std::size_t kSide = 8;
    ShapePart part{kGL_TRIANGLES, {}, {}};
    part.sends_tex_coords = true;
    for (const Grid& grid : grids(set, kSide)) {
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.insert(part.vertices.end(), grid.vertices().begin(), grid.vertices().end());
        for (std::uint32_t row = 0; row + 1 < kSide; ++row) {
            for (std::uint32_t column = 0; column + 1 < kSide; ++column) {
                const std::uint32_t here = first + row * kSide + column, below = here + kSide;
                part.indices.insert(part.indices.end(), {here, below, below + 1, here, below + 1, here + 1});
            }
        }
    }
    return {part};
}

// All columns of all grids first, then all rows.
std::vector<ShapePart> wires(const Teaset& set) {
    constexpr std::size_t kSide = 10;
    std::vector<ShapePart> parts;
    const std::vector<Grid> all = grids(set, kSide);
    for (const bool along_columns : {true, false}) {
        for (const Grid& grid : all) {
            for (std::size_t i = 0; i < kSide; ++i) {
                ShapePart part{kGL_LINE_STRIP, {}, {}};
                for (std::size_t k = 0; k < kSide; ++k) {
                    part.vertices.push_back(along_columns ? grid.at(k, i) : grid.at(i, k));
                }
                parts.push_back(std::move(part));
            }
        }
    }
    return parts;
}

std::vector<ShapePart> parts_of(const Teaset& set, bool wire) { return wire ? wires(set) : solid(set); }

// freeglut divides the sizes of cup and spoon by this.
constexpr double kSmaller = 2.5;

}  // namespace

std::vector<ShapePart> freeglut_teapot(double size, bool wire) {
    return parts_of({kTeapotPatches, size, 1.575, true, true}, wire);
}

std::vector<ShapePart> freeglut_teacup(double size, bool wire) {
    return parts_of({kTeacupPatches, size / kSmaller, 1.5121, true, false}, wire);
}

std::vector<ShapePart> freeglut_teaspoon(double size, bool wire) {
    return parts_of({kTeaspoonPatches, size / kSmaller, -0.0315, false, false}, wire);
}

}  // namespace twinlight
