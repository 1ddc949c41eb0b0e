#include "scene/command/cpp_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <vector>

#include "base/image/file.h"
#include "base/text/translation.h"
#include "scene/command/lexer.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

// All words and signs, with the lines of #include as kDirective; up to what is no C or C++.
std::vector<Token> words_of(std::string_view text, const std::string& file) {
    std::vector<Token> words;
    Lexer lexer(text, file, Lexer::Language::kProgram);
    try {
        while (words.size() < kMaxProgramTokens) {
            Token token = lexer.next();
            if (token.kind == TokenKind::kEnd) break;
            if (token.kind == TokenKind::kDirective && token.text == "include") token.text = lexer.skip_line();
            words.push_back(std::move(token));
        }
    } catch (const SceneError&) {
    }
    words.resize(words.size() + 2);
    return words;
}

bool is_any(const Token& token, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](std::string_view word) { return token.is(word); });
}

// #include <iostream>: headers of C end in .h.
bool is_cpp_header(const Token& token) {
    if (token.kind != TokenKind::kDirective) return false;
    const std::size_t open = token.text.find('<'), close = token.text.find('>');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return false;
    return !token.text.substr(open, close - open).ends_with(".h");
}

}  // namespace

bool has_cpp_name(const std::string& file) {
    static constexpr std::array kExtensions = {".cpp", ".cc", ".cxx", ".c++"};
    return std::filesystem::path(file).extension() == ".C" ||
           std::ranges::find(kExtensions, extension_of(file)) != kExtensions.end();
}

std::optional<CppWord> first_cpp_word(std::string_view text, const std::string& file) {
    const std::vector<Token> words = words_of(text, file);
    std::set<std::string_view> types = {"int",     "float",    "double", "char",  "bool",
                                        "GLfloat", "GLdouble", "GLint",  "GLuint"};
    for (std::size_t i = 0; i + 2 < words.size(); ++i) {
        const Token &word = words[i], &next = words[i + 1], &after = words[i + 2];
        const bool names_type = is_any(word, {"struct", "class"}) && next.kind == TokenKind::kName;
        if (names_type) types.insert(next.text);
        const bool is_name = next.kind == TokenKind::kName;
        const bool is_reference = types.contains(word.text) && next.is("&") && after.kind == TokenKind::kName;
        if (is_cpp_header(word))
            return CppWord{fmt::format("#include {}", word.text.substr(word.text.find('<'))), word.place};
        if (is_reference) return CppWord{tr("the reference {}& {}", word.text, after.text), word.place};
        const bool is_word = is_any(word, {"template", "namespace", "using", "virtual", "nullptr", "constexpr",
                                           "static_cast", "operator"}) ||
                             (is_any(word, {"class", "new", "delete", "typename", "throw", "auto"}) && is_name) ||
                             (is_any(word, {"public", "private", "protected"}) && next.is(":")) ||
                             (is_any(word, {"try", "catch"}) && is_any(next, {"{", "("})) ||
                             (word.is("delete") && next.is("[")) || (word.is("auto") && next.is("&"));
        if (is_word) return CppWord{tr("the word '{}'", word.text), word.place};
        if (word.kind == TokenKind::kName && next.is("::")) return CppWord{fmt::format("{}::", word.text), word.place};
    }
    return std::nullopt;
}

}  // namespace twinlight
