// Grades answers; finds lessons in the embedded pages.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "judge/lesson/lesson.h"
#include "scene/command/text.h"

namespace twinlight::lesson {

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

Lesson load_lesson(std::string_view name, Language language) {
    const std::vector<EmbeddedFile>& files = language == Language::kChinese ? kChineseLessonFiles : kLessonFiles;
    const auto file = std::ranges::find(files, std::string(name) + ".md", &EmbeddedFile::name);
    if (file == files.end()) throw std::out_of_range(fmt::format("there is no lesson '{}'", name));
    Lesson lesson = read_lesson(file->text, name);
    lesson.language = language;
    return lesson;
}

std::shared_ptr<const CommandList> commands_of(const Lesson& lesson, const std::string& text) {
    return std::make_shared<CommandList>(read_scene(text, lesson.name + ".gl", lesson.name));
}

std::string letter_of(std::size_t choice) { return {static_cast<char>('A' + choice)}; }

const PredictionWords& prediction_words(Language language) {
    static constexpr PredictionWords kEnglish = {"{} is right.", "{} is wrong; {} is right."};
    static constexpr PredictionWords kChinese = {"{} 正确。", "{} 不对，正确的是 {}。"};
    return language == Language::kChinese ? kChinese : kEnglish;
}

std::string verdict_on_prediction(const Lesson& lesson, std::size_t choice) {
    const PredictionWords& words = prediction_words(lesson.language);
    const std::string right = letter_of(lesson.right_choice);
    return choice == lesson.right_choice ? fmt::format(fmt::runtime(words.right), right)
                                         : fmt::format(fmt::runtime(words.wrong), letter_of(choice), right);
}

namespace {

std::string number_text(double value, Language language) {
    if (std::isinf(value)) return language == Language::kChinese ? "无穷远" : "infinitely far";
    return fmt::format("{:.3g}", value);
}

}  // namespace

Grader::Grader(const Lesson& lesson) : lesson_(lesson), start_(commands_of(lesson, lesson.scene)) {}

Grade Grader::grade(std::shared_ptr<const CommandList> answer) const {
    std::optional<Work> work;
    try {
        work.emplace(std::move(answer), &start_);
    } catch (const SceneError& error) {
        return {false, "", error.what()};
    }
    for (const Check& check : checks_of(lesson_.name)) {
        const double value = check.measure(*work);
        if (value >= check.low && value <= check.high) continue;  // not for NaN
        const auto reason = std::ranges::find(lesson_.reasons, check.key, &std::pair<std::string, std::string>::first);
        if (reason == lesson_.reasons.end())
            throw std::out_of_range(lesson_.name + " has no check " + std::string(check.key));
        std::string text = reason->second;
        const std::string number = number_text(value, lesson_.language);
        for (std::size_t at; (at = text.find("{value}")) != std::string::npos;) text.replace(at, 7, number);
        return {false, std::string(check.key), std::move(text)};
    }
    return {true};
}

}  // namespace twinlight::lesson
