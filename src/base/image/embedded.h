// Files embedded in the program. tools/embed.sh writes tables of them.
#pragma once

#include <string_view>
#include <vector>

namespace twinlight {

struct EmbeddedFile {
    std::string_view name;  // without its folder
    std::string_view text;
};

}  // namespace twinlight
