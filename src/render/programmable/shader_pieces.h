// Pieces of GLSL text: files with directives, and libraries of functions and uniforms (shader_assembly.h says what they are).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace twinlight::programmable {

using Words = std::map<std::string, std::string, std::less<>>;

struct Scope {
    std::map<std::string, bool, std::less<>> switches;  // of #if
    Words inserts;                                      // of #insert: whole lines
    Words words;                                        // whole identifiers, and what they become
};

// The file's text with its directives carried out.
std::string carried_out(std::string_view file, const Scope& scope);

// What a library defines: a function, or a uniform, with the comment above it.
struct Definition {
    std::string name;
    std::string text;
    bool is_uniform = false;
};
std::vector<Definition> definitions(std::string_view file, const Words& words);

// Those of the library that the text names, directly or through others, in the library's order. A library's functions name only
// what is before them.
std::vector<Definition> called_for(const std::vector<Definition>& library, std::string_view text);

}  // namespace twinlight::programmable
