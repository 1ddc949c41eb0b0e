#include "app/demo/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>
#include <utility>

#include "app/demo/overlays.h"
#include "app/demo/theme.h"

namespace twinlight::demo {
namespace {

// Tabs are in as many rows as they need. Returns whether this one was clicked.
bool tab_button(const char* name, const std::string& title, bool is_shown) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x / 2;
    const float width = ImGui::CalcTextSize(title.c_str()).x + 2 * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - style.WindowPadding.x;
    if (ImGui::GetItemRectMax().x + gap + width <= right && ImGui::GetCursorPosY() > style.WindowPadding.y + 1)
        ImGui::SameLine(0, gap);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(is_shown ? ImGuiCol_Button : ImGuiCol_WindowBg));
    ImGui::PushStyleColor(ImGuiCol_Text, is_shown ? kText : kDim);
    const bool clicked = ImGui::Button((title + "###" + name).c_str());
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
    save_.update(session);
}

void Panels::show(session::Session& session, const session::Box& box, const Panes& panes) {
    ImGui::SetNextWindowPos({static_cast<float>(box.x), static_cast<float>(box.y)});
    ImGui::SetNextWindowSize({static_cast<float>(box.width), static_cast<float>(box.height)});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    const std::string lint = lint_.count() == 0 ? "Lint" : fmt::format("Lint ({})", lint_.count());
    const std::pair<const char*, std::string> tabs[] = {
        {"Commands", "Commands"}, {"Lights", "Lights"}, {"Probe", "Probe"},       {"Shaders", "Shaders"},
        {"Overlays", "Overlays"}, {"Lint", lint},       {"Accuracy", "Accuracy"}, {"Save", "Save"}};
    for (const auto& [name, title] : tabs)
        if (tab_button(name, title, shown_ == name)) shown_ = name;
    ImGui::Separator();

    // A tab's content scrolls by itself.
    ImGui::BeginChild(shown_.c_str());
    if (shown_ == "Commands") commands_.show(session);
    if (shown_ == "Lights") lights_.show(session);
    if (shown_ == "Probe") {
        const session::Probe probe = session.probe.value_or(session::Probe{});
        probe_.show(session, panes.colors_at(probe.x, probe.y));
    }
    if (shown_ == "Shaders") shaders_.show(session);
    if (shown_ == "Overlays") overlays_panel(session);
    const bool shows_command = shown_ == "Lint" && lint_.show(session);
    if (shown_ == "Accuracy") accuracy_.show(session);
    if (shown_ == "Save") save_.show(session);
    ImGui::EndChild();
    if (shows_command) shown_ = "Commands";
    ImGui::End();
}

}  // namespace twinlight::demo
