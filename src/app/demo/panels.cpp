#include "app/demo/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "app/demo/overlays.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/tutor.h"
#include "base/text/translation.h"

namespace twinlight::demo {
namespace {

using session::Panel;

struct Tab {
    Panel panel;
    std::string title;
    float width;  // with its longest title, so that no other tab moves when the title changes
};

float tab_width(const std::string& title) {
    return ImGui::CalcTextSize(title.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

// In the order of kPanels; but a lesson that is open comes first.
std::vector<Tab> tabs(const session::Session& session, std::size_t findings) {
    std::vector<Tab> result;
    for (const session::PanelName& panel : session::kPanels) {
        const std::string title = tr(panel.title);
        const bool has_findings = panel.value == Panel::kLint && findings > 0;
        result.push_back({panel.value, has_findings ? fmt::format("{} ({})", title, findings) : title,
                          tab_width(panel.value == Panel::kLint ? title + " (99)" : title)});
    }
    const auto lesson = std::ranges::find(result, Panel::kLesson, &Tab::panel);
    if (session.lesson) std::rotate(result.begin(), lesson, lesson + 1);
    return result;
}

// How many tabs are in the row; the others are under "More".
std::size_t fitting_tabs(const std::vector<Tab>& tabs, float gap) {
    const float room = ImGui::GetContentRegionAvail().x;
    float used = -gap;
    for (const Tab& tab : tabs) used += gap + tab.width;
    if (used <= room) return tabs.size();
    used += gap + tab_width(tr("More"));
    std::size_t count = tabs.size();
    while (count > 1 && used > room) used -= gap + tabs[--count].width;
    return count;
}

bool tab_button(const std::string& label, float width, bool is_shown) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(is_shown ? ImGuiCol_Button : ImGuiCol_WindowBg));
    ImGui::PushStyleColor(ImGuiCol_Text, is_shown ? kText : kDim);
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5F});
    const bool clicked = ImGui::Button(label.c_str(), {width, 0});
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    if (is_shown) {
        const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRectFilled({from.x + 6, to.y - 2}, {to.x - 6, to.y}, kAccent);
    }
    return clicked;
}

// One row, and the menu "More" with the tabs that do not fit.
void show_tabs(session::Session& session, const std::vector<Tab>& tabs) {
    const float gap = ImGui::GetStyle().ItemSpacing.x / 4;
    const std::size_t in_row = fitting_tabs(tabs, gap);
    const auto label = [](const Tab& tab) { return fmt::format("{}###{}", tab.title, static_cast<int>(tab.panel)); };
    for (std::size_t i = 0; i < in_row; ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        if (tab_button(label(tabs[i]), tabs[i].width, session.panel == tabs[i].panel)) session.panel = tabs[i].panel;
    }
    if (in_row == tabs.size()) return;
    const std::span<const Tab> under_more = std::span(tabs).subspan(in_row);
    const auto shown = std::ranges::find(under_more, session.panel, &Tab::panel);
    const bool shows_one = shown != under_more.end();
    ImGui::SameLine(0, gap);
    if (tab_button(tr("More"), tab_width(tr("More")), shows_one)) ImGui::OpenPopup("more tabs");
    const ImVec2 below{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y};
    if (shows_one) bold_text(shown->title);
    ImGui::SetNextWindowPos(below);
    if (!ImGui::BeginPopup("more tabs")) return;
    for (const Tab& tab : under_more)
        if (ImGui::MenuItem(label(tab).c_str(), nullptr, session.panel == tab.panel)) session.panel = tab.panel;
    ImGui::EndPopup();
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
    show_tabs(session, tabs(session, lint_.count()));
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
