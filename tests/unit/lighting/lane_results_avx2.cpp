// Compiled for AVX2 and FMA (Makefile).
#if defined(__AVX2__)
#include "lane_results.h"

namespace twinlight::lighting {

LaneCounts double_lanes_avx2(const LaneArrays& arrays) { return lane_results<double, xsimd::default_arch>(arrays); }
LaneCounts float_lanes_avx2(const LaneArrays& arrays) { return lane_results<float, xsimd::default_arch>(arrays); }

}  // namespace twinlight::lighting
#endif
