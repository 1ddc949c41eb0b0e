#include "judge/compare/releases.h"

#include <fmt/format.h>

namespace twinlight::compare {

std::string_view counts_as(const Driver& driver) {
    std::string_view found;
    for (const std::string_view release : kMeasuredReleases) {
        Driver measured;
        measured.version = release;
        if (measured.maker() == driver.maker() && (found.empty() || !is_earlier(driver.number(), measured.number())))
            found = release;
    }
    return found;
}

bool has_measured_release(const Driver& driver) {
    const std::string_view release = counts_as(driver);
    return !release.empty() && driver.has_version(release);
}

std::string measured_note(const Driver& driver) {
    const std::string_view release = counts_as(driver);
    if (release.empty() || driver.has_version(release)) return "";
    return fmt::format("measured on {}; this is {}", release, driver.number());
}

std::string unmeasured_words(const Driver& driver) {
    if (measured_note(driver).empty()) return "";
    return fmt::format("{} was not measured and counts as {}: bugs that it fixed or added are not listed.",
                       driver.version, counts_as(driver));
}

}  // namespace twinlight::compare
