// Lights many points at once with the widest SIMD instructions of the processor.
//
// It uses the templates of equation.h with batches of doubles or floats. In doubles the results equal those of
// light_surface<double>, except for the rounding of powers: at most 4 units in the last place of the sum of the terms'
// magnitudes.
#pragma once

#include <cstddef>
#include <vector>
#include <xsimd/xsimd.hpp>

#include "base/math/arithmetic.h"
#include "lighting/equation.h"

namespace twinlight::lighting {

// One number for each point, or a single one for all points. Aligned to cache lines.
using Column = std::vector<double, xsimd::aligned_allocator<double, 64>>;
// Reads the number of any point from a column of either kind.
class Each {
  public:
    explicit Each(const Column& column) : first_(column.data()), step_(column.size() == 1 ? 0 : 1) {}
    double operator[](std::size_t point) const { return first_[point * step_]; }

  private:
    const double* first_;
    std::size_t step_;
};
inline Vec3<Each> each(const Vec3<Column>& columns) { return {Each(columns.x), Each(columns.y), Each(columns.z)}; }
inline Vec3<double> at(const Vec3<Each>& columns, std::size_t point) {
    return {columns.x[point], columns.y[point], columns.z[point]};
}

struct Points {
    SurfacePoint<Column> surface;
    Material<Column> material;        // all its columns have one length: size() or 1
    bool makes_unit_normals = false;  // normalise the normals first

    Points() { clear(); }
    void clear();  // removes all points and the material
    bool has_one_material() const { return material.shininess.size() == 1; }
    std::size_t size() const { return surface.position_eye.x.size(); }
    void add(const SurfacePoint<double>& point);
    void add(const Material<double>& point_material);  // call once for each point, or once in total
};

// Replaces the contents of `lit` by c_pri, c_sec and alpha of each point. c_sec has a single entry if it is not
// separate, alpha if there is one material. Long doubles are computed point by point, with pow().
void light_points(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                  const Arithmetic& arithmetic, Lit<Column>& lit);

// ---- The instruction sets ----

// Writes c_pri, and c_sec if it is separate, into columns that already have their length. Does not write alpha.
using LightPoints = void (*)(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                             const Arithmetic& arithmetic, Lit<Column>& lit);
struct InstructionSet {
    const char* name;  // "AVX-512"
    LightPoints light_points;
};
// The instruction sets of this processor, the widest first. The last one exists on every processor of this
// architecture.
const std::vector<InstructionSet>& instruction_sets();

}  // namespace twinlight::lighting
