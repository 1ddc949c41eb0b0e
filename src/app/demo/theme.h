// Theme: the fonts and colours of the window's panels.
#pragma once

#include <imgui.h>

#include <string>

#include "judge/lesson/lesson.h"

namespace twinlight::demo {

struct Fonts {
    ImFont* text = nullptr;
    ImFont* bold = nullptr;
    ImFont* code = nullptr;  // every letter has the same width
    ImFont* code_bold = nullptr;
    ImFont* code_large = nullptr;  // the tutor's
};

// Loads the fonts and sets colours and spacing; `scale` is 1 for 96 dots per inch. Needs an ImGui context. Without the
// DejaVu fonts, all of them are ImGui's own.
// Chinese letters are loaded if that is the language and a font has them.
void set_theme(double scale, lesson::Language language);
bool has_chinese_letters();
// The file of a font with Chinese letters; empty if none is installed.
std::string chinese_font();
const Fonts& fonts();
double scale();

// The height of a line, in pixels. ImGui 1.92 renamed the member.
inline float height_of(const ImFont& font) {
#if IMGUI_VERSION_NUM >= 19200
    return font.LegacySize;
#else
    return font.FontSize;
#endif
}

inline constexpr ImU32 kBackground = IM_COL32(24, 26, 31, 255);
inline constexpr ImU32 kBar = IM_COL32(38, 41, 48, 255);
inline constexpr ImU32 kText = IM_COL32(226, 229, 235, 255);
inline constexpr ImU32 kDim = IM_COL32(150, 156, 168, 255);
inline constexpr ImU32 kAccent = IM_COL32(240, 178, 72, 255);  // the light of a lamp
inline constexpr ImU32 kGood = IM_COL32(126, 200, 130, 255);
inline constexpr ImU32 kBad = IM_COL32(240, 110, 96, 255);

// The parts of a call in C text.
inline constexpr ImU32 kFunctionColor = IM_COL32(206, 211, 220, 255);
inline constexpr ImU32 kSignColor = IM_COL32(126, 132, 145, 255);
inline constexpr ImU32 kNameColor = IM_COL32(140, 184, 222, 255);
inline constexpr ImU32 kNumberColor = IM_COL32(231, 214, 180, 255);

}  // namespace twinlight::demo
