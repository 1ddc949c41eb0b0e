#include "app/demo/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace twinlight::demo {
namespace {

// The byte after the character of UTF-8 at this byte.
std::size_t after_character(const std::string& text, std::size_t at) {
    for (++at; at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80;) ++at;
    return at;
}

}  // namespace

std::string wrapped(const std::string& text, float width) {
    if (width <= 0) width = ImGui::GetContentRegionAvail().x;
    std::string result, line;
    std::size_t last_break = 0;  // in `line`
    bool was_chinese = false;    // the last character, after which a line may end
    const auto width_of = [](const std::string& part) { return ImGui::CalcTextSize(part.c_str()).x; };
    for (std::size_t at = 0, next = 0; at < text.size(); at = next) {
        next = after_character(text, at);
        const std::string character = text.substr(at, next - at);
        const bool is_closing = std::string_view("，。、；：？！）”……").find(character) != std::string_view::npos;
        const bool is_chinese = character.size() > 2 && !is_closing;
        if (is_chinese || (!is_closing && was_chinese) || (!line.empty() && line.back() == ' '))
            last_break = line.size();
        was_chinese = character.size() > 2 && character != "（" && character != "“";
        if (character == "\n") {
            result += line + "\n";
            line.clear();
            last_break = 0;
            continue;
        }
        line += character;
        if (last_break == 0 || width_of(line) <= width) continue;
        result += line.substr(0, last_break) + "\n";
        line.erase(0, last_break);
        last_break = 0;
    }
    return result + line;
}

float text_y(const Rectangle& bar) {
    return static_cast<float>(bar.y) + (static_cast<float>(bar.height) - ImGui::GetFontSize()) / 2;
}

ImU32 color_of(const glm::dvec3& color, int alpha) {
    const auto code = [](double channel) { return static_cast<int>(std::lround(255 * std::clamp(channel, 0.0, 1.0))); };
    return IM_COL32(code(color.r), code(color.g), code(color.b), alpha);
}

void colored_text(ImU32 color, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(wrapped(text).c_str());
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
    ImGui::TextUnformatted(wrapped(text).c_str());
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

void same_line_for(const char* label) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float needed =
        style.ItemSpacing.x + ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize(label).x;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (ImGui::GetItemRectMax().x + needed <= right) ImGui::SameLine();
}

std::string fitting(const std::vector<std::string>& texts, float room) {
    const auto fits = [room](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x <= room; };
    for (const std::string& text : texts)
        if (fits(text)) return text;
    std::string cut = texts.back();
    // A character of UTF-8 is cut as a whole.
    while (!cut.empty() && !fits(cut + "...")) {
        while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80) cut.pop_back();
        if (!cut.empty()) cut.pop_back();
    }
    return cut + "...";
}

std::string fitting_in_combo(const std::string& text) {
    const float arrow = ImGui::GetFrameHeight(), padding = 2 * ImGui::GetStyle().FramePadding.x;
    return fitting({text}, ImGui::GetContentRegionAvail().x - arrow - padding);
}

void draw_arrow(ImDrawList& draw, const ImVec2& from, const ImVec2& to, ImU32 color) {
    const ImVec2 along{to.x - from.x, to.y - from.y};
    const float length = std::sqrt(along.x * along.x + along.y * along.y);
    if (length < 1) return;
    const float head = std::min(at_scale(11), length);
    const ImVec2 dir{along.x / length, along.y / length};
    const ImVec2 neck{to.x - head * dir.x, to.y - head * dir.y};
    for (const auto& [ink, width] : {std::pair{kShadow, 5.0F}, {color, 2.5F}}) draw.AddLine(from, neck, ink, width);
    draw.AddTriangleFilled(to, {neck.x - head * 0.5F * dir.y, neck.y + head * 0.5F * dir.x},
                           {neck.x + head * 0.5F * dir.y, neck.y - head * 0.5F * dir.x}, color);
}

void Labels::add(ImVec2 at, ImU32 color, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const auto is_free = [&](float y) {
        return std::ranges::none_of(taken_, [&](const ImVec4& other) {
            return at.x < other.z && other.x < at.x + size.x && y < other.w && other.y < y + size.y;
        });
    };
    for (const float line : {0.0F, 1.0F, -1.0F, 2.0F, -2.0F, 3.0F, -3.0F, 4.0F, -4.0F, 5.0F, -5.0F})
        if (const float y = at.y + line * (size.y + 3); is_free(y)) {
            at.y = y;
            break;
        }
    taken_.push_back({at.x, at.y, at.x + size.x, at.y + size.y});
    draw_.AddRectFilled({at.x - 4, at.y - 1}, {at.x + size.x + 4, at.y + size.y + 1}, kShadow, 4);
    draw_.AddText(at, color, text.c_str());
}

void draw_tick(const ImVec2& at) {
    const float size = ImGui::GetFontSize();
    const ImVec2 points[] = {{at.x + 0.15F * size, at.y + 0.55F * size},
                             {at.x + 0.4F * size, at.y + 0.8F * size},
                             {at.x + 0.9F * size, at.y + 0.2F * size}};
    ImGui::GetWindowDrawList()->AddPolyline(points, 3, kGood, ImDrawFlags_None, at_scale(2));
}

void draw_cross(ImDrawList& draw, const ImVec2& at) {
    for (const auto& [color, width] : {std::pair{IM_COL32(0, 0, 0, 200), 3.0F}, {IM_COL32_WHITE, 1.0F}}) {
        draw.AddLine({at.x - 12, at.y}, {at.x - 4, at.y}, color, width);
        draw.AddLine({at.x + 4, at.y}, {at.x + 12, at.y}, color, width);
        draw.AddLine({at.x, at.y - 12}, {at.x, at.y - 4}, color, width);
        draw.AddLine({at.x, at.y + 4}, {at.x, at.y + 12}, color, width);
    }
}

void draw_probe(ImDrawList& draw, const session::ProbeArrows& arrows,
                const std::function<std::optional<ImVec2>(const glm::dvec3&)>& place_of) {
    const auto from = place_of(arrows.place_eye);
    if (!from) return;
    draw_cross(draw, *from);
    Labels labels(draw);
    for (const session::ProbeArrow& arrow : arrows.arrows) {
        constexpr std::array kColors = {IM_COL32(89, 230, 128, 255), IM_COL32(120, 180, 255, 255),
                                        IM_COL32(255, 225, 120, 255), IM_COL32(255, 120, 210, 255)};
        const ImU32 color = kColors[static_cast<std::size_t>(arrow.kind)];
        const auto to = place_of(arrows.tip_eye(arrow));
        if (!to) continue;
        draw_arrow(draw, *from, *to, color);
        labels.add(plus(*to, {5, -ImGui::GetFontSize()}), color, arrow.name);
    }
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
