// Separate from driver_name.cpp, so that a name can be parsed without a context.
#include <algorithm>

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

}  // namespace twinlight
