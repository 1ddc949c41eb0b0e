// Reads golden/known_differences.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "judge/compare/departures.h"
#include "render/context/driver_name.h"

namespace twinlight {

// By name, the releases that have mended each: "mended:  Mesa 25.0, Mesa 25.1".
inline std::map<std::string, std::set<std::string>> known_differences() {
    constexpr std::string_view kMended = "mended: ";
    std::map<std::string, std::set<std::string>> list;
    std::string name;
    std::ifstream file("golden/known_differences");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('[') && line.ends_with(']')) {
            name = line.substr(1, line.size() - 2);
            list[name];
        } else if (line.starts_with(kMended)) {
            std::istringstream releases(line.substr(kMended.size()));
            for (std::string release; std::getline(releases >> std::ws, release, ',');) list[name].insert(release);
        }
    }
    return list;
}

inline bool is_mended(std::string_view name, const Driver& driver) {
    static const auto list = known_differences();
    const auto known = list.find(std::string(name));
    return known != list.end() &&
           std::ranges::any_of(known->second, [&](const std::string& release) { return driver.has_version(release); });
}

// Nobody has looked at the departures of a driver or release that is not listed.
inline void expect_as_listed(std::string_view name, bool departs) {
    const Driver driver = current_driver();
    if (!compare::is_listed(driver)) return;
    if (is_mended(name, driver))
        EXPECT_FALSE(departs) << name << ": listed as mended in " << driver.version;
    else
        EXPECT_TRUE(departs) << name << ": the driver keeps to the text now";
}

}  // namespace twinlight
