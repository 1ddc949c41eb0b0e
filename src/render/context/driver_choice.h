// Environment variables that choose Mesa's driver. With a name that it does not know, Mesa gives no driver, or crashes.
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

namespace twinlight {

// What is wrong with GALLIUM_DRIVER, and how to correct it; empty if it names a software driver or is not set.
inline std::string wrong_gallium_driver() {
    const char* driver = std::getenv("GALLIUM_DRIVER");
    const std::string_view name = driver ? driver : "";
    if (name.empty() || name == "llvmpipe" || name == "softpipe") return "";
    return "the environment variable GALLIUM_DRIVER is '" + std::string(name) +
           "'; set it to llvmpipe or softpipe, or unset it";
}

// The same for all such variables: a likely reason where there is no driver.
inline std::string wrong_driver_choice() {
    if (std::string wrong = wrong_gallium_driver(); !wrong.empty()) return wrong;
    for (const char* variable : {"MESA_LOADER_DRIVER_OVERRIDE", "LIBGL_DRIVERS_PATH"})
        if (const char* value = std::getenv(variable); value && *value)
            return std::string("the environment variable ") + variable + " is '" + value + "'; unset it";
    return "";
}

}  // namespace twinlight
