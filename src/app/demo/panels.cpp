#include "app/demo/panels.h"

#include <imgui.h>

#include <string_view>

#include "app/demo/theme.h"
#include "scene/command/text.h"

namespace twinlight::demo {

void Panels::show(session::Session& session, const session::Box& box, const Panes& panes) {
    ImGui::SetNextWindowPos({static_cast<float>(box.x), static_cast<float>(box.y)});
    ImGui::SetNextWindowSize({static_cast<float>(box.width), static_cast<float>(box.height)});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll)) {
        // A tab's content scrolls by itself.
        const auto tab = [this](const char* name, const auto& content) {
            const bool bring = opened_ && std::string_view(opened_) == name;
            if (!ImGui::BeginTabItem(name, nullptr, bring ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None))
                return;
            ImGui::BeginChild(name);
            content();
            ImGui::EndChild();
            ImGui::EndTabItem();
        };
        tab("Commands", [&] {
            ImGui::PushFont(fonts().code);
            for (const Command& command : commands(session).commands)
                ImGui::TextUnformatted(print_command(command).c_str());
            ImGui::PopFont();
        });
        tab("Probe", [&] {
            const session::Probe probe = session.probe.value_or(session::Probe{});
            probe_.show(session, panes.colors_at(probe.x, probe.y));
        });
        ImGui::EndTabBar();
        opened_ = nullptr;
    }
    ImGui::End();
}

}  // namespace twinlight::demo
