// Small widgets that several panels use, and the window's measures as ImGui has them.
#pragma once

#include <imgui.h>

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/demo/theme.h"
#include "app/session/layout.h"
#include "app/session/probe_arrows.h"
#include "base/math/vec3.h"

namespace twinlight::demo {

inline constexpr ImU32 kResultRow = IM_COL32(44, 48, 57, 255);  // behind the row of a result

// A window that shows nothing but what is put into it.
inline constexpr ImGuiWindowFlags kPlainWindow = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                                                 ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// ---- Measures ----

inline float at_scale(float pixels) { return pixels * static_cast<float>(scale()); }
inline ImVec2 plus(ImVec2 a, ImVec2 b) { return {a.x + b.x, a.y + b.y}; }
inline ImVec2 corner(const Rectangle& box) { return {static_cast<float>(box.x), static_cast<float>(box.y)}; }
inline ImVec2 far_corner(const Rectangle& box) {
    return {static_cast<float>(box.x + box.width), static_cast<float>(box.y + box.height)};
}
inline ImVec2 size_of(const Rectangle& box) { return {static_cast<float>(box.width), static_cast<float>(box.height)}; }
// Where a line of text starts that is in the middle of a bar's height.
float text_y(const Rectangle& bar);
// Channels are clamped to [0, 1].
ImU32 color_of(const glm::dvec3& color, int alpha = 255);

// ---- Text ----

void dim_text(const std::string& text);  // wrapped
void bold_text(const std::string& text);
void colored_text(ImU32 color, const std::string& text);       // wrapped
void colored_text_line(ImU32 color, const std::string& text);  // as wide as it is
// Draws a line of code into the window, at a place on the screen. Emits no widget.
void draw_code(ImVec2 at, ImU32 color, const std::string& text, bool is_bold);
// A field for one line. Returns whether Enter was pressed. If `takes_focus`, it gets the keys, with the cursor at the end, and then
// clears that.
bool text_field(const char* label, const char* hint, std::span<char> text, bool& takes_focus);
// Breaks lines for the room that is left, as ImGui does not: only at blanks, so that "2.14.6" stays whole; Chinese text after each
// character, but not before a closing mark.
// `width`: instead of that room.
std::string wrapped(const std::string& text, float width = 0);
// The next item, a radio button with this label, stays in the line of the last one if there is room.
void same_line_for(const char* label);
// The title of a part of a panel.
void heading(const std::string& text);

inline constexpr ImU32 kShadow = IM_COL32(0, 0, 0, 150);
void draw_arrow(ImDrawList& draw, const ImVec2& from, const ImVec2& to, ImU32 color);
// Texts on dark boxes. One that would lie over another is moved down or up, by whole lines.
class Labels {
  public:
    explicit Labels(ImDrawList& draw) : draw_(draw) {}
    void add(ImVec2 at, ImU32 color, const std::string& text);

  private:
    ImDrawList& draw_;
    std::vector<ImVec4> taken_;  // left, top, right, bottom
};
// As high as a line of text.
void draw_tick(const ImVec2& at);
// Marks the probed pixel: white lines on dark ones, visible on every picture.
void draw_cross(ImDrawList& draw, const ImVec2& at);
// The cross, and the arrows with their names. `place_of`: where a point in eye coordinates is in the window.
void draw_probe(ImDrawList& draw, const session::ProbeArrows& arrows,
                const std::function<std::optional<ImVec2>(const glm::dvec3&)>& place_of);

// The first of these texts that is not wider than `room`; if none fits, the last one, cut, with dots.
std::string fitting(const std::vector<std::string>& texts, float room);
// The same for the text of a combo box that is as wide as the panel.
std::string fitting_in_combo(const std::string& text);

// A square of this colour, as high as a line of text. Channels are clamped to [0, 1].
void swatch(const Vec3<double>& color);

}  // namespace twinlight::demo
