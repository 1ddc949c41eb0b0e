// The releases of drivers on which the known bugs were measured.
#pragma once

#include <string>
#include <string_view>

#include "render/context/driver_name.h"

namespace twinlight::compare {

// The releases on which the known bugs were measured; those of one maker from old to new. A release includes its patches: Mesa
// 22.3.6 is one of "Mesa 22.3". Any other release counts as the newest measured one before it, or else as the oldest.
inline constexpr std::string_view kMeasuredReleases[] = {"Mesa 22.3", "Mesa 25.0", "Mesa 25.1",
                                                         "Mesa 26.0", "Mesa 26.1", "NVIDIA 580"};

// The measured release that the driver's release is, or counts as. Empty if no release of its maker was measured.
std::string_view counts_as(const Driver& driver);
// Whether it is one of these releases.
bool has_measured_release(const Driver& driver);
// "measured on Mesa 26.1; this is 26.2.0"; empty for a measured release, or if no release of its maker was measured.
std::string measured_note(const Driver& driver);
// "Mesa 26.2.0 was not measured and counts as Mesa 26.1: bugs that it fixed or added are not listed."; empty as above.
std::string unmeasured_words(const Driver& driver);

}  // namespace twinlight::compare
