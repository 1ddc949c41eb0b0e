#include "app/demo/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "app/demo/overlays.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/tutor.h"
#include "base/text/translation.h"

namespace twinlight::demo {
namespace {

using session::Panel;

// Tabs are in as many rows as they need. Returns whether this one was clicked. `widest`: its longest title, so that no other tab
// moves when the title changes.
bool tab_button(const char* name, const std::string& title, const std::string& widest, bool is_shown) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x / 2;
    const float width = ImGui::CalcTextSize(widest.c_str()).x + 2 * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - style.WindowPadding.x;
    if (ImGui::GetItemRectMax().x + gap + width <= right && ImGui::GetCursorPosY() > style.WindowPadding.y + 1)
        ImGui::SameLine(0, gap);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(is_shown ? ImGuiCol_Button : ImGuiCol_WindowBg));
    ImGui::PushStyleColor(ImGuiCol_Text, is_shown ? kText : kDim);
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5F});
    const bool clicked = ImGui::Button((title + "###" + name).c_str(), {width, 0});
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    if (is_shown) {
        const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRectFilled({from.x + 6, to.y - 2}, {to.x - 6, to.y}, kAccent);
    }
    return clicked;
}

}  // namespace

void Panels::update(session::Session& session) {
    lint_.update(session);
    lesson_.update(session);
    save_.update(session);
}

void Panels::show(session::Session& session, const Rectangle& box, const Panes& panes) {
    ImGui::SetNextWindowPos(corner(box));
    ImGui::SetNextWindowSize(size_of(box));
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    for (const session::PanelName& panel : session::kPanels) {
        std::string title = tr(panel.title), widest = title;
        if (panel.value == Panel::kLint) {
            widest += " (99)";
            if (lint_.count() > 0) title += fmt::format(" ({})", lint_.count());
        }
        if (tab_button(panel.key, title, widest, session.panel == panel.value)) session.panel = panel.value;
    }
    ImGui::Separator();

    // A tab's content scrolls by itself.
    ImGui::BeginChild(static_cast<ImGuiID>(session.panel) + 1);
    switch (session.panel) {
        case Panel::kCommands: commands_.show(session); break;
        case Panel::kLights: lights_.show(session); break;
        case Panel::kProbe: {
            const session::Probe probe = session.probe.value_or(session::Probe{});
            probe_.show(session, panes.colors_at(probe.x, probe.y));
            break;
        }
        case Panel::kShaders: shaders_.show(session); break;
        case Panel::kOverlays: overlays_panel(session); break;
        case Panel::kLint:
            if (lint_.show(session)) session.panel = Panel::kCommands;
            break;
        case Panel::kAccuracy: accuracy_.show(session); break;
        case Panel::kSave: save_.show(session); break;
        case Panel::kLesson: lesson_.show(session); break;
    }
    ImGui::EndChild();
    ImGui::End();
}

void Panels::show_tutor(session::Session& session, const Rectangle& box) {
    ImGui::SetNextWindowPos(corner(box));
    ImGui::SetNextWindowSize(size_of(box));
    ImGui::Begin("tutor", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    commands_.show_calls(session, session::tutor_calls(commands(session)));
    ImGui::End();
    if (session.probe && !session.probe->is_vertex && !ImGui::GetIO().WantCaptureMouse)
        probe_.show_under_pointer(session);
}

}  // namespace twinlight::demo
