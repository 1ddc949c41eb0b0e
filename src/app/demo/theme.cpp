#include "app/demo/theme.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include "app/session/language.h"
#include "app/session/lesson_state.h"
#include "base/text/translation.h"

namespace twinlight::demo {
namespace {

// Debian's package fonts-dejavu-core.
constexpr const char* kFolder = "/usr/share/fonts/truetype/dejavu/";
constexpr float kTextSize = 15, kCodeSize = 14, kLargeCodeSize = 20;
constexpr float kSmallestSize = 13;  // smaller letters are hard to read  // in pixels at scale 1

// Of Debian's packages fonts-noto-cjk, fonts-droid-fallback, fonts-wqy-microhei and fonts-wqy-zenhei.
constexpr const char* kChineseFonts[] = {"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
                                         "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf",
                                         "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc",
                                         "/usr/share/fonts/truetype/wqy/wqy-zenhei.ttc"};

Fonts loaded;
double used_scale = 1;
bool chinese_loaded = false;

// Adds the letters of the Chinese window and lessons to the font that was loaded last.
void add_chinese(float size) {
    static ImVector<ImWchar> ranges;  // ImGui reads it when it makes the texture
    if (ranges.empty()) {
        ImFontGlyphRangesBuilder builder;
        for (const EmbeddedFile& page : kChineseLessonFiles)
            builder.AddText(page.text.data(), page.text.data() + page.text.size());
        for (const Translation& row : session::chinese()) builder.AddText(row.translated);
        for (const char* words : session::all_words(lesson::Language::kChinese)) builder.AddText(words);
        builder.BuildRanges(&ranges);
    }
    ImFontConfig config;
    config.MergeMode = true;
    ImGui::GetIO().Fonts->AddFontFromFileTTF(chinese_font().c_str(), size * static_cast<float>(used_scale), &config,
                                             ranges.Data);
}

ImFont* load_latin(const char* name, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const std::string file = std::string(kFolder) + name;
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return atlas.AddFontDefault();
    // Letters with accents, Greek, dashes, arrows and signs of mathematics.
    static const ImWchar kRanges[] = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027, 0x2190,
                                      0x2199, 0x2200, 0x22ff, 0x25a0, 0x25ff, 0};
    const float pixels = std::max(kSmallestSize, size * static_cast<float>(used_scale));
    return atlas.AddFontFromFileTTF(file.c_str(), pixels, nullptr, kRanges);
}

ImFont* load(const char* name, float size) {
    ImFont* const font = load_latin(name, size);
    if (chinese_loaded) add_chinese(size);
    return font;
}

}  // namespace

std::string chinese_font() {
    std::error_code ignored;
    for (const char* file : kChineseFonts)
        if (std::filesystem::exists(file, ignored)) return file;
    return "";
}
bool has_chinese_letters() { return chinese_loaded; }

const Fonts& fonts() { return loaded; }
double scale() { return used_scale; }

void set_theme(double scale, lesson::Language language) {
    used_scale = scale;
    chinese_loaded = language == lesson::Language::kChinese && !chinese_font().empty();
    loaded.text = load("DejaVuSans.ttf", kTextSize);
    loaded.bold = load("DejaVuSans-Bold.ttf", kTextSize);
    loaded.code = load("DejaVuSansMono.ttf", kCodeSize);
    loaded.code_large = load_latin("DejaVuSansMono.ttf", kLargeCodeSize);
    loaded.code_bold = load("DejaVuSansMono-Bold.ttf", kCodeSize);

    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.ChildRounding = style.FrameRounding = style.GrabRounding = style.TabRounding = style.PopupRounding = 4;
    style.WindowBorderSize = 0;
    style.FramePadding = {7, 4};
    style.ItemSpacing = {8, 6};
    style.WindowPadding = {12, 10};
    style.ScrollbarSize = 12;
    style.ScaleAllSizes(static_cast<float>(scale));

    const auto set = [&style](ImGuiCol which, int red, int green, int blue, int alpha = 255) {
        style.Colors[which] = ImGui::ColorConvertU32ToFloat4(IM_COL32(red, green, blue, alpha));
    };
    set(ImGuiCol_Text, 226, 229, 235);
    set(ImGuiCol_TextDisabled, 150, 156, 168);
    set(ImGuiCol_WindowBg, 30, 33, 39);
    set(ImGuiCol_ChildBg, 0, 0, 0, 0);
    set(ImGuiCol_PopupBg, 38, 41, 48, 250);
    set(ImGuiCol_TitleBg, 52, 57, 68);
    set(ImGuiCol_TitleBgActive, 52, 57, 68);
    set(ImGuiCol_ModalWindowDimBg, 0, 0, 0, 110);
    set(ImGuiCol_Border, 58, 63, 73);
    set(ImGuiCol_FrameBg, 44, 48, 57);
    set(ImGuiCol_FrameBgHovered, 56, 61, 72);
    set(ImGuiCol_FrameBgActive, 66, 72, 85);
    set(ImGuiCol_Button, 52, 57, 68);
    set(ImGuiCol_ButtonHovered, 68, 75, 89);
    set(ImGuiCol_ButtonActive, 84, 92, 108);
    set(ImGuiCol_Header, 52, 57, 68);
    set(ImGuiCol_HeaderHovered, 62, 68, 81);
    set(ImGuiCol_HeaderActive, 74, 81, 96);
    set(ImGuiCol_Tab, 38, 41, 48);
    set(ImGuiCol_TabHovered, 74, 81, 96);
    set(ImGuiCol_TabActive, 58, 63, 75);
    set(ImGuiCol_CheckMark, 240, 178, 72);
    set(ImGuiCol_SliderGrab, 200, 152, 72);
    set(ImGuiCol_SliderGrabActive, 240, 178, 72);
    set(ImGuiCol_Separator, 58, 63, 73);
    set(ImGuiCol_TextSelectedBg, 240, 178, 72, 90);
    set(ImGuiCol_NavHighlight, 240, 178, 72);
}

}  // namespace twinlight::demo
