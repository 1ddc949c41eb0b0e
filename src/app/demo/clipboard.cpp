#include "app/demo/clipboard.h"

#include <imgui.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace twinlight::demo {
namespace {

// What was copied or pasted last; ImGui reads it from here.
std::string& last_text() {
    static std::string text;
    return text;
}

}  // namespace

bool shares_clipboard() {
    static const bool kShares = std::system("command -v xclip >/dev/null 2>&1") == 0;
    return kShares;
}

void copy_text(const std::string& text) {
    last_text() = text;
    if (!shares_clipboard()) return;
    std::signal(SIGPIPE, SIG_IGN);  // if xclip cannot connect to the display
    // It stays in the background, so it must not hold this program's output open.
    FILE* pipe = ::popen("xclip -selection clipboard >/dev/null 2>&1", "w");
    if (!pipe) return;
    std::fwrite(text.data(), 1, text.size(), pipe);
    ::pclose(pipe);
}

std::string copied_text() {
    if (!shares_clipboard()) return last_text();
    // The program that has the text may not answer.
    FILE* pipe = ::popen("timeout 1 xclip -selection clipboard -out 2>/dev/null", "r");
    if (!pipe) return "";
    std::string text;
    std::array<char, 4096> piece;
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), pipe)) text.append(piece.data(), count);
    ::pclose(pipe);
    return text;
}

void give_imgui_the_clipboard() {
#if IMGUI_VERSION_NUM >= 19110
    ImGui::GetPlatformIO().Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) { copy_text(text); };
    ImGui::GetPlatformIO().Platform_GetClipboardTextFn = [](ImGuiContext*) {
        return (last_text() = copied_text()).c_str();
    };
#else
    ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { copy_text(text); };
    ImGui::GetIO().GetClipboardTextFn = [](void*) { return (last_text() = copied_text()).c_str(); };
#endif
}

}  // namespace twinlight::demo
