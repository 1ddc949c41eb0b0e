// Whether a program is C++: its first word that C does not have. Asked only about programs that cannot be read as C.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/command/place.h"

namespace twinlight {

struct CppWord {
    std::string text;  // "#include <iostream>"
    Place place;
};

std::optional<CppWord> first_cpp_word(std::string_view text, const std::string& file);

}  // namespace twinlight
