// What Mesa's softpipe needs before the first context, whoever makes that.
#pragma once

#include <cstdlib>
#include <string_view>

namespace twinlight {

// softpipe's vertices are left to Mesa's own interpreter: compiled by LLVM they would be llvmpipe's once more, no second
// opinion, and Mesa 22.3 crashes in LLVM over some programs.
inline void give_softpipe_its_own_vertices() {
    const char* driver = std::getenv("GALLIUM_DRIVER");
    constexpr int kKeep = 0;  // what the user set
    if (driver && std::string_view(driver) == "softpipe") ::setenv("DRAW_USE_LLVM", "0", kKeep);
}

}  // namespace twinlight
