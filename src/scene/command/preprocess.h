// C's preprocessor for whole programs: #define, #undef, #if, #ifdef, #ifndef, #elif, #else, #endif, #include of files beside the
// program.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/command/lexer.h"
#include "scene/command/text.h"

namespace twinlight {

struct PreprocessedText {
    std::vector<Token> tokens{};
    std::map<std::string, std::string_view, std::less<>> included{};  // the texts of the files, by their paths
    std::deque<std::string> made{};  // what tokens and `included` point into, beside the text

    std::string_view keep(std::string text) { return made.emplace_back(std::move(text)); }
};

// The program's tokens with macros replaced; the last is kEnd. The tokens of a macro have the place of its use, those of an included
// file have its path in their places, such as "homework/lamp.h". Other #include lines, #error and foreign pragmas are skipped.
// Throws SceneError.
PreprocessedText preprocess(std::string_view text, const std::string& file, const TextLoader& load_text);

}  // namespace twinlight
