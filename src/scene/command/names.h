// GL's names and Twinlight's words, and their values (enums.def, words.def).
//
// kGL_LIGHT0 is GL_LIGHT0, kGLU_FILL is GLU_FILL. So most of the library works without GL's headers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twinlight {

using Enum = std::uint32_t;

#define ENUM(name, value) inline constexpr Enum kGL_##name = value;
#define GLU_ENUM(name, value) inline constexpr Enum kGLU_##name = value;
#include "scene/command/enums.def"
#undef ENUM
#undef GLU_ENUM

enum class Word : Enum {
#define WORD(word) word,
#include "scene/command/words.def"
#undef WORD
};

struct NamedValue {
    std::string_view name;  // "GL_LIGHT0", or a word
    Enum value;
};

const std::vector<NamedValue>& gl_names();  // every row of enums.def, in its order
const std::vector<NamedValue>& words();     // every row of words.def, in its order

std::optional<Enum> find_gl_name(std::string_view name);
// The same, and for the name of an extension such as GL_TEXTURE0_ARB the core name with the same meaning.
std::optional<Enum> find_gl_name_or_extension(std::string_view name);
std::optional<Enum> find_word(std::string_view word);

std::string_view word_name(Word word);
// "GL_LIGHT0"; a value without a name in hexadecimal. 0 to 9 have many meanings (GL_FALSE, GL_POINTS, ...) and are
// printed as numbers; primitive_name() gives the names of glBegin's modes.
std::string enum_name(Enum value);
std::string primitive_name(Enum mode);
std::string bit_names(Enum mask);  // "GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT"

// The candidate most similar to a misspelt name (Damerau-Levenshtein distance); nullopt if none is similar.
std::optional<std::string_view> nearest(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace twinlight
