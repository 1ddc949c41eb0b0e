// Compiled for AVX-512 (Makefile).
#if defined(__AVX512F__)
#include "lighting/points_kernel.h"

namespace twinlight::lighting {

void light_points_avx512(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                         const Arithmetic& arithmetic, Lit<Column>& lit) {
    light_points_on<xsimd::default_arch>(model, lights, points, arithmetic, lit);
}

}  // namespace twinlight::lighting
#endif
