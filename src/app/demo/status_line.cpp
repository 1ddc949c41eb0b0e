#include "app/demo/status_line.h"

#include <imgui.h>

#include <string>

#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/keys.h"
#include "app/session/language.h"
#include "app/session/steps.h"
#include "base/text/translation.h"
#include "scene/scenes/caption.h"

namespace twinlight::demo {
namespace {

constexpr std::chrono::seconds kMessageTime(6);

}  // namespace

void StatusLine::show(session::Session& session, const Rectangle& bar, bool keeps_messages) {
    if (session.messages != messages_seen_) {
        messages_seen_ = session.messages;
        message_since_ = std::chrono::steady_clock::now();
    }
    const auto age = std::chrono::steady_clock::now() - message_since_;
    if (age > kMessageTime && !keeps_messages) session.message.clear();

    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    const ImVec2 from = corner(bar), to = far_corner(bar);
    draw.AddRectFilled(from, to, session.error.empty() ? kBar : IM_COL32(96, 34, 28, 255));
    const float y = text_y(bar);
    std::string scene = title_of(session);
    if (const std::string step = session::step_caption(commands(session)); !step.empty()) scene += tr(", ") + step;
    draw.AddText(fonts().bold, height_of(*fonts().bold), {12, y}, kText, scene.c_str());
    const float after_name = 12 + fonts().bold->CalcTextSizeA(height_of(*fonts().bold), 1e4F, 0, scene.c_str()).x + 18;
    const char* help = tr("Ctrl+O scenes   ? keys   right click: menu");
    const float help_x = to.x - ImGui::CalcTextSize(help).x - 12;
    if (session.error.empty()) {
        draw.AddText({help_x, y}, kDim, help);
        draw.PushClipRect(from, {help_x - 12, to.y});
    } else {
        draw.PushClipRect(from, to);
    }
    if (!session.error.empty()) {
        draw.AddText({after_name, y}, kText, session.error.c_str());
    } else if (!session.message.empty()) {
        draw.AddText({after_name, y}, kAccent, fitting({session.message}, help_x - 12 - after_name).c_str());
    } else {
        draw.AddText({after_name, y}, kDim,
                     fitting({session::lights_summary(session.scene.frame)}, help_x - 12 - after_name).c_str());
    }
    draw.PopClipRect();
}

void show_caption(const session::Session& session, const Rectangle& box) {
    const Caption caption = session::translated(caption_of(*session.opened));
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float left = corner(box).x + 16, room = static_cast<float>(box.width) - 26, line = ImGui::GetFontSize() + 4;
    const float top = corner(box).y + 5;
    ImGui::PushFont(fonts().bold);
    draw.AddText({left, top}, kText, fitting({caption.title, session::before_colon(caption.title)}, room).c_str());
    ImGui::PopFont();
    draw.AddText({left, top + line}, kDim,
                 fitting({caption.notice, session::first_sentence(caption.notice)}, room).c_str());
    if (!ImGui::IsMouseHoveringRect(corner(box), far_corner(box), false)) return;
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(wrapped(caption.all, 36 * ImGui::GetFontSize()).c_str());
    ImGui::EndTooltip();
}

void show_keys(int width, int height) {
    ImGui::SetNextWindowPos({static_cast<float>(width) / 2, static_cast<float>(height) / 2}, ImGuiCond_Always,
                            {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.97F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {24, 18});
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoInputs);
    ImGui::SetWindowFocus();
    bold_text(tr("Keys"));
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const session::Key& row : session::keys()) {
            if (row.label.empty()) continue;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::PushFont(fonts().code_bold);
            ImGui::TextUnformatted(tr(row.label).c_str());
            ImGui::PopFont();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(tr(row.what).c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace twinlight::demo
