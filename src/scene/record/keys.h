// Keys that are sent to the window of a program, by xdotool.
#pragma once

#include <string>
#include <vector>

namespace twinlight::trace {

// X's names of the keys in a text: "w", "space" for a blank, "Left" for <Left>. Throws SceneError for a name that never ends.
std::vector<std::string> keys_of(const std::string& text);

// The command that waits for the first window of a display and sends it keys, one after another. Throws SceneError if xdotool is
// missing.
std::vector<std::string> sender_of(const std::vector<std::string>& keys);

}  // namespace twinlight::trace
