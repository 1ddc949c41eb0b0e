// Calls that are typed or pasted as C text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "app/session/session.h"

namespace twinlight::session {

// Inserts them after the selected call and its group, at the end if none is selected; or instead of the call `replaced`. Throws
// SceneError.
void insert_calls(Session& session, std::string_view text, std::optional<std::size_t> replaced = {});
// The selected call as text, up to glEnd for a glBegin; empty if none is selected.
std::string selected_calls(const Session& session);
// The first call from `start` on, in a circle, whose text has the pattern, in upper or lower case.
std::optional<std::size_t> find_call(const Session& session, std::string_view pattern, std::size_t start);
// Whether the pattern occurs in the text, in upper or lower case. An empty pattern occurs in every text.
bool has_text(std::string_view text, std::string_view pattern);

}  // namespace twinlight::session
