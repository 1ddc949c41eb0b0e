#include "app/memory.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/program.h"

namespace twinlight {

namespace {

// In GB with two digits, rounded up.
std::string gigabytes(double bytes) {
    const double step = std::pow(10, std::floor(std::log10(bytes)) - 1);
    return fmt::format("{:.4g}", std::ceil(bytes / step) * step / 1e9);
}

}  // namespace

void check_fits(const MemoryBudget& memory, int width, int height, std::uint64_t pictures, std::uint64_t besides) {
    if (pictures + besides <= memory.bytes) return;
    std::vector<std::string> remedies;
    if (memory.has_size && besides < memory.bytes && pictures > 0) {
        const double share = std::sqrt(static_cast<double>(memory.bytes - besides) / static_cast<double>(pictures));
        const int narrower = static_cast<int>(share * width), lower = static_cast<int>(share * height);
        if (narrower >= kMinSide && lower >= kMinSide && share < 1)
            remedies.push_back(fmt::format("--size {}x{}", narrower, lower));
    }
    const std::string needed = gigabytes(static_cast<double>(pictures + besides));
    if (memory.has_option) remedies.push_back("--memory " + needed);
    throw UsageError(fmt::format("{}pictures of {} x {} need {} GB of memory, but {:.4g} are allowed{}{}",
                                 10 * besides > pictures ? "the scene and its " : "", width, height, needed,
                                 static_cast<double>(memory.bytes) / 1e9, remedies.empty() ? "" : "; try ",
                                 fmt::join(remedies, " or ")));
}

}  // namespace twinlight
