#include "app/demo/panels.h"

#include <imgui.h>

#include <string_view>

#include "app/demo/overlays.h"

namespace twinlight::demo {

void Panels::show(session::Session& session, const session::Box& box, const Panes&) {
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
        tab("Commands", [&] { commands_.show(session); });
        tab("Lights", [&] { lights_.show(session); });
        tab("Overlays", [&] { overlays_panel(session); });
        ImGui::EndTabBar();
        opened_ = nullptr;
    }
    ImGui::End();
}

}  // namespace twinlight::demo
