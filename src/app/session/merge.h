// Merges two changes of one text, line by line, as version control does.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace twinlight::session {

// `base` with both changes. Empty if they change the same line, or lines side by side, in different ways.
std::optional<std::string> merged(std::string_view base, std::string_view mine, std::string_view theirs);

}  // namespace twinlight::session
