// Separate from driver_name.cpp, so that a name can be parsed without a context.
#include <algorithm>
#include <array>
#include <charconv>

#include "render/context/driver_name.h"

namespace twinlight {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// GL_VERSION begins with a digit (6.1.5). GL_RENDERER may also contain ", 6", so the last match counts.
std::size_t end_of_renderer(std::string_view name) {
    std::size_t end = name.size();
    for (std::size_t at = name.find(", "); at != std::string_view::npos; at = name.find(", ", at + 1))
        if (at + 2 < name.size() && is_digit(name[at + 2])) end = at;
    return end;
}

// The first two words after the GL version and the profile.
std::string vendor_version(std::string_view version) {
    version.remove_prefix(std::min(version.find(' '), version.size() - 1) + 1);
    if (version.starts_with('(')) version.remove_prefix(std::min(version.find(')') + 2, version.size()));
    const std::size_t second = version.find(' ');
    return std::string(version.substr(0, second == std::string_view::npos ? second : version.find(' ', second + 1)));
}

// {25, 1, 0} of "25.1.0".
std::array<int, 3> parts_of(std::string_view number) {
    std::array<int, 3> parts{};
    const char* at = number.data();
    const char* const end = at + number.size();
    for (int& one : parts) {
        const auto [after, error] = std::from_chars(at, end, one);
        if (error != std::errc() || after == end || *after != '.') break;
        at = after + 1;
    }
    return parts;
}

}  // namespace

Driver parse_driver_name(std::string_view driver_name) {
    Driver driver;
    const std::size_t end = end_of_renderer(driver_name), provider = driver_name.rfind(", ");
    driver.renderer = driver_name.substr(0, std::min(end, provider));
    driver.name = driver.renderer.substr(0, driver.renderer.find(" ("));
    if (provider == std::string_view::npos) return driver;
    driver.provider = driver_name.substr(provider + 2);
    if (end < provider) driver.version = vendor_version(driver_name.substr(end + 2, provider - end - 2));
    return driver;
}

bool Driver::has_version(std::string_view release) const {
    return version == release || (version.starts_with(release) && version[release.size()] == '.');
}

std::string_view Driver::maker() const { return std::string_view(version).substr(0, version.find(' ')); }

std::string_view Driver::number() const {
    const std::string_view rest = std::string_view(version).substr(std::min(maker().size() + 1, version.size()));
    return rest.substr(0, rest.find_first_not_of("0123456789."));
}

bool is_earlier(std::string_view number, std::string_view other) { return parts_of(number) < parts_of(other); }

bool Releases::contain(const Driver& driver) const {
    const std::string_view number = driver.number();
    if (from.empty() && before.empty()) return true;
    return !number.empty() && !is_earlier(number, from) && (before.empty() || is_earlier(number, before));
}

}  // namespace twinlight
