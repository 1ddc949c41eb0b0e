// The name of the driver, and its parts.
#pragma once

#include <string>
#include <string_view>

namespace twinlight {

// "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile) Mesa 22.3.6, OSMesa": GL_RENDERER, GL_VERSION and the
// provider of the current context.
std::string driver_name();

// The parts of such a name. A missing part is empty.
struct Driver {
    std::string renderer;  // "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string name;      // "llvmpipe"
    std::string version;   // "Mesa 22.3.6", "NVIDIA 535.54.03"
    std::string provider;  // "OSMesa"

    // Whether the version is this release or one of its patches: "Mesa 22.3.6" is one of "Mesa 22.3".
    bool has_version(std::string_view release) const;
    // "Mesa" and "25.1.0" of "Mesa 25.1.0-devel".
    std::string_view maker() const;
    std::string_view number() const;
};
Driver parse_driver_name(std::string_view driver_name);
Driver current_driver();  // of the current context

// Whether one number of a release is lower than another: "22.3.6" and "25.0". What is missing is 0.
bool is_earlier(std::string_view number, std::string_view other);

// Releases of a driver, by their numbers: `from` and all after it, up to but without `before`. "" is no limit.
struct Releases {
    std::string_view from{}, before{};  // "25.0"

    bool contain(const Driver& driver) const;
};

}  // namespace twinlight
