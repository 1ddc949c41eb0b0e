#include "app/demo/widgets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twinlight::demo {

float text_y(const Rectangle& bar) {
    return static_cast<float>(bar.y) + (static_cast<float>(bar.height) - ImGui::GetFontSize()) / 2;
}

ImU32 color_of(const glm::dvec3& color, int alpha) {
    const auto code = [](double channel) { return static_cast<int>(std::lround(255 * std::clamp(channel, 0.0, 1.0))); };
    return IM_COL32(code(color.r), code(color.g), code(color.b), alpha);
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

void dim_text(const std::string& text) { colored_text(kDim, text); }

void bold_text(const std::string& text) {
    ImGui::PushFont(fonts().bold);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopFont();
}

void draw_code(ImVec2 at, ImU32 color, const std::string& text, bool is_bold) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* const font = is_bold && ImGui::GetFont() == fonts().code ? fonts().code_bold : ImGui::GetFont();
    list.AddText(font, ImGui::GetFontSize(), at, color, text.c_str());
}

bool text_field(const char* label, const char* hint, std::span<char> text, bool& takes_focus) {
    if (takes_focus) ImGui::SetKeyboardFocusHere();
    // Called once the field has the keys.
    const auto took_focus = [](ImGuiInputTextCallbackData* field) {
        if (std::exchange(*static_cast<bool*>(field->UserData), false)) {
            field->ClearSelection();
            field->CursorPos = field->BufTextLen;
        }
        return 0;
    };
    return ImGui::InputTextWithHint(label, hint, text.data(), text.size(),
                                    ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways,
                                    took_focus, &takes_focus);
}

void heading(const std::string& text) {
    ImGui::Dummy({0, ImGui::GetFontSize() / 3});
    bold_text(text);
}

void swatch(const Vec3<double>& color) {
    const float side = ImGui::GetFontSize();
    const ImVec2 from = plus(ImGui::GetCursorScreenPos(), {0, 1}), to = plus(from, {side, side});
    ImGui::Dummy({side, side});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(from, to, color_of({color.x, color.y, color.z}), 3);
    draw.AddRect(from, to, IM_COL32(255, 255, 255, 50), 3);
}

}  // namespace twinlight::demo
