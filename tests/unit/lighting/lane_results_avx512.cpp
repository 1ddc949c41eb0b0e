// Compiled for AVX-512 (Makefile).
#if defined(__AVX512F__)
#include "lane_results.h"

namespace twinlight::lighting {

LaneCounts double_lanes_avx512(const LaneArrays& arrays) { return lane_results<double, xsimd::default_arch>(arrays); }
LaneCounts float_lanes_avx512(const LaneArrays& arrays) { return lane_results<float, xsimd::default_arch>(arrays); }

}  // namespace twinlight::lighting
#endif
