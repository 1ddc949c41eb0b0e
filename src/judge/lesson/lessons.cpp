// Our lessons: their order, their pages.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "judge/lesson/lesson.h"

namespace twinlight::lesson {

std::span<const std::string_view> names() {
    static constexpr std::array<std::string_view, 17> kNames = {
        "light-and-camera", "sun-or-lamp",    "second-light",       "attenuation",     "spot-direction", "shininess",
        "local-viewer",     "coarse-mesh",    "saturation",         "missing-normals", "scaled-normals", "two-sides",
        "provoking-vertex", "color-material", "textured-highlight", "transparency",    "overlay"};
    return kNames;
}

std::optional<Language> find_language(std::string_view name) {
    if (name == "en") return Language::kEnglish;
    if (name == "zh") return Language::kChinese;
    return {};
}

Language users_language() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(name);
        if (value && *value) return std::string_view(value).starts_with("zh") ? Language::kChinese : Language::kEnglish;
    }
    return Language::kEnglish;
}

std::string_view text_of_lesson(std::string_view name, Language language) {
    const std::vector<EmbeddedFile>& files = language == Language::kChinese ? kChineseLessonFiles : kLessonFiles;
    const auto file = std::ranges::find(files, std::string(name) + ".md", &EmbeddedFile::name);
    if (file == files.end()) throw std::out_of_range(fmt::format("there is no lesson '{}'", name));
    return file->text;
}

Lesson load_lesson(std::string_view name, Language language) {
    const std::string_view text = text_of_lesson(name, language);
    if (language == Language::kEnglish) return read_lesson(text, name);
    const Lesson original = load_lesson(name, Language::kEnglish);
    Lesson lesson = read_lesson(text, name, "", &original);
    lesson.language = language;
    return lesson;
}

}  // namespace twinlight::lesson
