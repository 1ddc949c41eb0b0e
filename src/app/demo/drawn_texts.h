// The texts of the window's last frame, and where they are cut or lie over each other; for tests.
#pragma once

#include <imgui.h>

#include <array>
#include <string>
#include <vector>

namespace twinlight::demo {

// The middles of the letters that are cut at the left or at the right, in pixels. Letters that are cut above or
// below are not meant: a list that scrolls cuts them.
std::vector<std::array<int, 2>> cut_letters(const ImDrawData& data);

// The middles of the letters that lie over another one of their window, in pixels.
std::vector<std::array<int, 2>> overlapping_letters(const ImDrawData& data);

// The lines of text that are in sight, without code: what the fonts for code show. Empty with ImGui 1.92 and later.
std::vector<std::string> drawn_texts(const ImDrawData& data);

}  // namespace twinlight::demo
