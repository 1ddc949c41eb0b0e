// The clipboard that other programs share, by the program xclip: GLUT has none. It also holds the text after the window has closed.
#pragma once

#include <string>

namespace twinlight::demo {

// Without xclip, the clipboard is the window's own.
bool shares_clipboard();
void copy_text(const std::string& text);
std::string copied_text();
// For ImGui's fields. Needs its context.
void give_imgui_the_clipboard();

}  // namespace twinlight::demo
