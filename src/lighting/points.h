// The lighting equation for many points at once, on the widest SIMD instructions that the processor has.
//
// The same templates as for one point (equation.h), over batches of doubles. What comes of it is what light_surface<double>
// gives, but for the rounding of powers: within 4 units in the last place of the sum of the terms' magnitudes.
#pragma once

#include <cstddef>
#include <vector>

#include "lighting/equation.h"
#include "math/arithmetic.h"

namespace twinlight::lighting {

// A number for each point, or one for all of them. All of a material's columns are of one length.
using Column = std::vector<double>;

struct Points {
    Surface<Column> surface;
    Material<Column> material;
    bool makes_unit_normals = false;  // the normals are made unit vectors first

    Points();  // none
    bool has_one_material() const { return material.shininess.size() == 1; }
    std::size_t size() const { return surface.position_eye.x.size(); }
    void add(const Surface<double>& point);
    void add(const Material<double>& of_point);  // one for each point, or one
};

// c_pri, c_sec and the alpha of each point; magnitudes are left out. Long doubles are lit one by one, with pow().
Lit<Column> light_points(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                         const Arithmetic& arithmetic = {});

// ---- The instruction sets ----

using LightPoints = void (*)(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                             const Arithmetic& arithmetic, Lit<Column>& lit);
struct InstructionSet {
    const char* name;  // "AVX-512"
    LightPoints light_points;
};
// Those that this processor has, the widest first; the last one all processors of its kind have.
const std::vector<InstructionSet>& instruction_sets();

}  // namespace twinlight::lighting
