// The lighting equation for many points at once, on the widest SIMD instructions that the processor has.
//
// The same templates as for one point (equation.h), over batches of doubles. The results are light_surface<double>'s, except
// for the rounding of powers: within 4 units in the last place of the sum of the terms' magnitudes.
#pragma once

#include <cstddef>
#include <vector>
#include <xsimd/xsimd.hpp>

#include "base/math/arithmetic.h"
#include "lighting/equation.h"

namespace twinlight::lighting {

// A number for each point, or one for all of them. They begin where a line of the cache does.
using Column = std::vector<double, xsimd::aligned_allocator<double, 64>>;
// Its number for any point.
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
    Material<Column> material;        // whose columns are all of one length
    bool makes_unit_normals = false;  // the normals are made unit vectors first

    Points() { clear(); }
    void clear();  // all points, and the material
    bool has_one_material() const { return material.shininess.size() == 1; }
    std::size_t size() const { return surface.position_eye.x.size(); }
    void add(const SurfacePoint<double>& point);
    void add(const Material<double>& of_point);  // one for each point, or one
};

// c_pri, c_sec and the alpha of each point, in the place of what `lit` has; magnitudes are left out. c_sec is one for all
// where it is not separate, alpha where the material is. Long doubles are lit one by one, with pow().
void light_points(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                  const Arithmetic& arithmetic, Lit<Column>& lit);

// ---- The instruction sets ----

// Into columns that have their length; of c_sec, where it is separate. Alphas are left out.
using LightPoints = void (*)(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                             const Arithmetic& arithmetic, Lit<Column>& lit);
struct InstructionSet {
    const char* name;  // "AVX-512"
    LightPoints light_points;
};
// Those that this processor has, the widest first; the last one all processors of its kind have.
const std::vector<InstructionSet>& instruction_sets();

}  // namespace twinlight::lighting
