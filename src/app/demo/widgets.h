// Small widgets that several panels use.
#pragma once

#include <imgui.h>

#include <string>

#include "base/math/vec3.h"

namespace twinlight::demo {

inline constexpr ImU32 kResultRow = IM_COL32(44, 48, 57, 255);  // behind the row of a result

// A square of this colour, as high as a line of text. Channels are clamped to [0, 1].
void swatch(const Vec3<double>& color);
// The title of a part of a panel.
void heading(const char* text);
void colored_text(ImU32 color, const std::string& text);       // wrapped
void colored_text_line(ImU32 color, const std::string& text);  // as wide as it is

}  // namespace twinlight::demo
