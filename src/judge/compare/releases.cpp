#include "judge/compare/releases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace twinlight::compare {

namespace {

// "Mesa" and "25.1.0" of "Mesa 25.1.0-devel".
std::string_view maker_of(std::string_view version) { return version.substr(0, version.find(' ')); }
std::string_view number_of(std::string_view version) {
    const std::string_view number = version.substr(std::min(maker_of(version).size() + 1, version.size()));
    return number.substr(0, number.find_first_not_of("0123456789."));
}

// {25, 1, 0} of "25.1.0". What is missing is 0.
std::array<int, 3> numbers_of(std::string_view number) {
    std::array<int, 3> numbers{};
    const char* at = number.data();
    const char* const end = at + number.size();
    for (int& one : numbers) {
        const auto [after, error] = std::from_chars(at, end, one);
        if (error != std::errc() || after == end || *after != '.') break;
        at = after + 1;
    }
    return numbers;
}

bool is_before(std::string_view number, std::string_view other) { return numbers_of(number) < numbers_of(other); }

}  // namespace

std::string_view counts_as(const Driver& driver) {
    std::string_view found;
    for (const std::string_view release : kMeasuredReleases)
        if (maker_of(release) == maker_of(driver.version) &&
            (found.empty() || !is_before(number_of(driver.version), number_of(release))))
            found = release;
    return found;
}

bool has_measured_release(const Driver& driver) {
    const std::string_view release = counts_as(driver);
    return !release.empty() && driver.has_version(release);
}

std::string measured_note(const Driver& driver) {
    const std::string_view release = counts_as(driver);
    if (release.empty() || driver.has_version(release)) return "";
    return fmt::format("measured on {}; this is {}", release, number_of(driver.version));
}

std::string unmeasured_words(const Driver& driver) {
    if (measured_note(driver).empty()) return "";
    return fmt::format("{} was not measured and counts as {}: bugs that it fixed or added are not listed.",
                       driver.version, counts_as(driver));
}

bool Releases::contain(const Driver& driver) const {
    const std::string_view number = number_of(driver.version);
    if (from.empty() && before.empty()) return true;
    return !number.empty() && !is_before(number, from) && (before.empty() || is_before(number, before));
}

}  // namespace twinlight::compare
