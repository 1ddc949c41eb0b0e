// Grades answers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "judge/lesson/lesson.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"

namespace twinlight::lesson {

std::shared_ptr<const CommandList> commands_of(const Lesson& lesson, const std::string& text) {
    const std::string file = lesson.name + ".gl";
    if (lesson.folder.empty()) return std::make_shared<CommandList>(read_scene(text, file, lesson.name));
    return std::make_shared<CommandList>(
        read_text_of((std::filesystem::path(lesson.folder) / file).string(), lesson.name, text));
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
    if (std::isnan(value)) return "?";
    if (std::isinf(value)) return language == Language::kChinese ? "无穷远" : "infinitely far";
    return fmt::format("{:.3g}", value);
}

}  // namespace

Grader::Grader(const Lesson& lesson) : lesson_(lesson), start_(commands_of(lesson, lesson.scene)) {}

Marks::Result Grader::result(const Check& check, const Work& work) const {
    const double value = check.condition.measure(work);
    if (check.condition.holds(value)) return {check.key, true};
    std::string text = check.reason;
    const std::string number = number_text(value, lesson_.language);
    for (std::size_t at; (at = text.find("{value}")) != std::string::npos;) text.replace(at, 7, number);
    return {check.key, false, std::move(text)};
}

Grade Grader::grade(std::shared_ptr<const CommandList> answer) const {
    std::optional<Work> work;
    try {
        work.emplace(std::move(answer), &start_);
    } catch (const SceneError& error) {
        return {false, "", error.what()};
    }
    for (const Check& check : lesson_.checks)
        if (const Marks::Result one = result(check, *work); !one.is_passed) return {false, one.key, one.reason};
    return {true};
}

const std::vector<bool>& Grader::passed_at_start() const {
    if (passed_at_start_.empty())
        for (const Check& check : lesson_.checks) passed_at_start_.push_back(result(check, start_).is_passed);
    return passed_at_start_;
}

int Grader::most_points() const { return static_cast<int>(std::ranges::count(passed_at_start(), false)); }

Marks Grader::marks(const Work& answer) const {
    Marks marks{.most = most_points()};
    for (std::size_t i = 0; i < lesson_.checks.size(); ++i) {
        marks.results.push_back(result(lesson_.checks[i], answer));
        const bool is_passed = marks.results.back().is_passed;
        if (is_passed != passed_at_start()[i]) marks.points += is_passed ? 1 : -1;
    }
    marks.points = std::max(marks.points, 0);
    return marks;
}

}  // namespace twinlight::lesson
