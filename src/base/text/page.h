// The text of pages: templates, and bytes as text.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace twinlight {

// Replaces each {{name}} with its value; a {{name}} inside a value stays. Throws std::logic_error for a name without a
// value.
std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

// Escapes text for HTML, also inside attributes.
std::string escaped(std::string_view text);

// RFC 4648 section 4.
std::string base64(std::string_view bytes);

}  // namespace twinlight
