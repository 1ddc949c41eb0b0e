// C's preprocessor for whole programs: #define, #undef, #if, #ifdef, #ifndef, #elif, #else, #endif.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/command/lexer.h"

namespace twinlight {

// The program's tokens with macros replaced; the last is kEnd. The tokens of a macro have the place of its use. #include,
// #error and foreign pragmas are skipped. Throws SceneError.
std::vector<Token> preprocess(std::string_view text, const std::string& file);

}  // namespace twinlight
