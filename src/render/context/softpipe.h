// A setting that Mesa's softpipe needs before the first context is created.
#pragma once

#include <cstdlib>
#include <string_view>

namespace twinlight {

// Makes softpipe run vertex programs in Mesa's own interpreter. With LLVM it would use llvmpipe's code and give no
// second opinion; and Mesa 22.3 crashes in LLVM with some programs.
inline void keep_llvm_out_of_softpipe() {
    const char* driver = std::getenv("GALLIUM_DRIVER");
    constexpr int kKeep = 0;  // keeps the user's setting
    if (driver && std::string_view(driver) == "softpipe") ::setenv("DRAW_USE_LLVM", "0", kKeep);
}

}  // namespace twinlight
