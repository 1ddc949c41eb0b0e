// Finds texts of the window that are cut, for tests.
#pragma once

#include <imgui.h>

#include <array>
#include <vector>

namespace twinlight::demo {

// The middles of the letters that are cut at the left or at the right, in pixels. Letters that are cut above or
// below are not meant: a list that scrolls cuts them.
std::vector<std::array<int, 2>> cut_letters(const ImDrawData& data);

}  // namespace twinlight::demo
