#include "app/demo/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>
#include <string_view>
#include <utility>

#include "app/demo/overlays.h"
#include "app/demo/theme.h"
#include "scene/command/text.h"

namespace twinlight::demo {

void Panels::update(session::Session& session) {
    lint_.update(session);
    save_.update(session);
}

void Panels::show(session::Session& session, const session::Box& box, const Panes& panes) {
    ImGui::SetNextWindowPos({static_cast<float>(box.x), static_cast<float>(box.y)});
    ImGui::SetNextWindowSize({static_cast<float>(box.width), static_cast<float>(box.height)});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll)) {
        // A tab's content scrolls by itself.
        const char* opened = std::exchange(opened_, nullptr);
        const auto tab = [opened](const char* name, const std::string& title, const auto& content) {
            const bool bring = opened && std::string_view(opened) == name;
            if (!ImGui::BeginTabItem((title + "###" + name).c_str(), nullptr,
                                     bring ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None))
                return;
            ImGui::BeginChild(name);
            content();
            ImGui::EndChild();
            ImGui::EndTabItem();
        };
        tab("Commands", "Commands", [&] {
            ImGui::PushFont(fonts().code);
            for (const Command& command : commands(session).commands)
                ImGui::TextUnformatted(print_command(command).c_str());
            ImGui::PopFont();
        });
        tab("Probe", "Probe", [&] {
            const session::Probe probe = session.probe.value_or(session::Probe{});
            probe_.show(session, panes.colors_at(probe.x, probe.y));
        });
        tab("Shaders", "Shaders", [&] { shaders_.show(session); });
        tab("Lint", lint_.count() == 0 ? "Lint" : fmt::format("Lint ({})", lint_.count()), [&] {
            if (lint_.show(session)) opened_ = "Commands";
        });
        tab("Accuracy", "Accuracy", [&] { accuracy_.show(session); });
        tab("Save", "Save", [&] { save_.show(session); });
        tab("Overlays", "Overlays", [&] { overlays_panel(session); });
        ImGui::EndTabBar();
    }
    ImGui::End();
}

}  // namespace twinlight::demo
