// Pieces of GLSL text: files with directives, and libraries of functions and uniforms (described in shader_assembly.h).
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace twinlight::programmable {

// Visits each identifier (or number), and the text between them with is_identifier false.
template <class Visit>
void for_each_token(std::string_view text, const Visit& visit) {
    constexpr std::string_view kInIdentifiers = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    while (!text.empty()) {
        const bool is_identifier = kInIdentifiers.find(text.front()) != kInIdentifiers.npos;
        const std::size_t end =
            is_identifier ? text.find_first_not_of(kInIdentifiers) : text.find_first_of(kInIdentifiers);
        visit(text.substr(0, end), is_identifier);
        text.remove_prefix(std::min(end, text.size()));
    }
}

using Words = std::map<std::string, std::string, std::less<>>;

struct Scope {
    std::map<std::string, bool, std::less<>> switches;  // for #if
    Words inserts;                                      // for #insert: whole lines
    Words words;                                        // identifiers and their replacements
};

// The text of a file in shaders/ or export/.
std::string_view file_text(std::string_view name);

// The text with the words replaced, each where it is a whole identifier.
std::string with_words(std::string_view text, const Words& words);

// The text with a variable replaced, but not a member of that name.
std::string with_variable(std::string_view text, std::string_view variable, std::string_view replacement);

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

// The text of the definition; of a struct NameParameters only the members that the text uses, as Name.member or Name[0].member.
std::string with_used_members(const Definition& definition, std::string_view text);

// Throws std::logic_error if a shader uses a name "u_..." that none of its lines "uniform ..." declares.
void check_uniforms_are_declared(std::string_view shader);

}  // namespace twinlight::programmable
