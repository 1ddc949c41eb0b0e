// Whether a program is C++: by its file's name, or its first word that C does not have. Needed only for programs that cannot be read
// as C.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/command/place.h"

namespace twinlight {

// ".cpp", ".cc", ".cxx" or ".c++" in any case, or ".C"; ".c" is C.
bool has_cpp_name(const std::string& file);

struct CppWord {
    std::string text;  // "#include <iostream>"
    Place place;
};

std::optional<CppWord> first_cpp_word(std::string_view text, const std::string& file);

}  // namespace twinlight
