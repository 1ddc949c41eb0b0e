// Pieces of GLSL text: files with directives, and libraries of functions and uniforms (described in shader_assembly.h).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace twinlight::programmable {

using Words = std::map<std::string, std::string, std::less<>>;

struct Scope {
    std::map<std::string, bool, std::less<>> switches;  // for #if
    Words inserts;                                      // for #insert: whole lines
    Words words;                                        // identifiers and their replacements
};

// The text of a file in shaders/, precise/ or kept/.
std::string_view file_text(std::string_view name);

// The text with the words replaced, each where it is a whole identifier.
std::string with_words(std::string_view text, const Words& words);

// The file's text after its directives.
std::string preprocessed(std::string_view file, const Scope& scope);

// One definition in a library, a function, a uniform or a uniform's struct, with the comment above it.
struct Definition {
    std::string name;
    std::string text;
    bool is_uniform = false;  // or a uniform's struct
};
std::vector<Definition> definitions(std::string_view file, const Words& words);

// The definitions of the library that the text uses, directly or through others, in the library's order. A function in
// a library uses only definitions above it.
std::vector<Definition> used_definitions(const std::vector<Definition>& library, std::string_view text);

}  // namespace twinlight::programmable
