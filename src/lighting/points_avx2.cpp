// Compiled for AVX2 and FMA (Makefile).
#if defined(__AVX2__)
#include "lighting/points_kernel.h"

namespace twinlight::lighting {

void light_points_avx2(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                       const Arithmetic& arithmetic, Lit<Column>& lit) {
    light_points_on<xsimd::default_arch>(model, lights, points, arithmetic, lit);
}

}  // namespace twinlight::lighting
#endif
