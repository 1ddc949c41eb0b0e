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

// By name, the releases of Mesa that have the bug: those before the one of "fixed:  Mesa 25.0", and from that of "new:".
struct KnownReleases {
    std::string from, before;
};
inline std::map<std::string, KnownReleases> known_differences() {
    constexpr std::string_view kFixed = "fixed: ", kNew = "new: ", kMesa = "Mesa ";
    const auto number = [&](std::string_view line) {
        return std::string(line.substr(line.find(kMesa) + kMesa.size()));
    };
    std::map<std::string, KnownReleases> list;
    std::string name;
    std::ifstream file("golden/known_differences");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('[') && line.ends_with(']')) {
            name = line.substr(1, line.size() - 2);
            list[name];
        } else if (line.starts_with(kFixed)) {
            list[name].before = number(line);
        } else if (line.starts_with(kNew)) {
            list[name].from = number(line);
        }
    }
    return list;
}

// Whether the list says that this release of Mesa is right.
inline bool is_right(std::string_view name, const Driver& driver) {
    static const auto list = known_differences();
    const auto known = list.find(std::string(name));
    return driver.version.starts_with("Mesa ") && known != list.end() &&
           !Releases{.from = known->second.from, .before = known->second.before}.contain(driver);
}

// Nobody knows what a driver or release fixed that was not measured.
inline void expect_as_listed(std::string_view name, bool departs) {
    const Driver driver = current_driver();
    if (!compare::is_measured(driver)) return;
    if (is_right(name, driver))
        EXPECT_FALSE(departs) << name << ": listed as right in " << driver.version;
    else
        EXPECT_TRUE(departs) << name << ": the driver is right now";
}

}  // namespace twinlight
