#include "app/demo/widgets.h"

#include <algorithm>

#include "app/demo/theme.h"

namespace twinlight::demo {

void swatch(const Vec3<double>& color) {
    const auto channel = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
    const ImVec4 shown(channel(color.x), channel(color.y), channel(color.z), 1);
    const float side = ImGui::GetFontSize();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({from.x, from.y + 1}, {from.x + side, from.y + side + 1}, ImGui::ColorConvertFloat4ToU32(shown),
                       3);
    draw.AddRect({from.x, from.y + 1}, {from.x + side, from.y + side + 1}, IM_COL32(255, 255, 255, 50), 3);
}

void heading(const char* text) {
    ImGui::Dummy({0, ImGui::GetFontSize() / 3});
    bold_text(text);
}

void colored_text(ImU32 color, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

void colored_text_line(ImU32 color, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

}  // namespace twinlight::demo
