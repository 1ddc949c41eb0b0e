// A file that travels inside the binary (the Makefile's `embed` writes the tables).
#pragma once

#include <string_view>
#include <vector>

namespace twinlight {

struct EmbeddedFile {
    std::string_view name;  // without its folder
    std::string_view text;
};

}  // namespace twinlight
