// twinlight lesson: lists the lessons, prints one, writes its scene, grades answers.
#include "judge/lesson/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/cli/command_line.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"

namespace twinlight::cli {

namespace {

using lesson::Language;
using lesson::Lesson;

struct LessonArguments {
    std::string name, output, prediction;
    std::vector<std::string> answers;
    Language language = lesson::users_language();
    bool json = false, changed = false;
};

// What the program itself says in the lesson's language.
struct Words {
    const char *right, *wrong, *not_read, *summary, *next;
};
constexpr Words kEnglish = {
    "right",
    "wrong",
    "not read",
    "{} of {} right.\n",
    "To see whether your prediction is right: twinlight lesson {0} --predict A\n"
    "To write the scene to start from:        twinlight lesson {0} -o {0}.gl\n"
    "To check your answer:                    twinlight lesson {0} --check {0}.gl\n",
};
constexpr Words kChinese = {
    "正确",
    "错误",
    "无法读取",
    "{1} 份中有 {0} 份正确。\n",
    "查看预测是否正确：twinlight lesson {0} --predict A\n"
    "写出起始场景：    twinlight lesson {0} -o {0}.gl\n"
    "检查你的答案：    twinlight lesson {0} --check {0}.gl\n",
};
const Words& words_of(Language language) { return language == Language::kChinese ? kChinese : kEnglish; }

Lesson load(const LessonArguments& arguments) { return load_lesson(arguments.name, arguments.language); }

int list(const LessonArguments& arguments) {
    nlohmann::ordered_json json = {{"lessons", nlohmann::ordered_json::array()}};
    std::string text;
    std::size_t width = 0;
    for (const std::string_view name : lesson::names()) width = std::max(width, name.size());
    for (const std::string_view name : lesson::names()) {
        const Lesson lesson = lesson::load_lesson(name, arguments.language);
        json["lessons"].push_back({{"name", name}, {"title", lesson.title}});
        text += fmt::format("{:{}}  {}\n", name, width, lesson.title);
    }
    write_result(arguments.json ? json.dump(2) + "\n" : text);
    return kFine;
}

int print(const LessonArguments& arguments) {
    const Lesson lesson = load(arguments);
    if (arguments.json) {
        nlohmann::ordered_json json = {
            {"name", lesson.name},       {"title", lesson.title},
            {"about", lesson.about},     {"question", lesson.question},
            {"scene", lesson.scene},     {"prediction", lesson.prediction},
            {"choices", lesson.choices}, {"right_choice", lesson::letter_of(lesson.right_choice)},
            {"seen", lesson.seen},       {"changed", lesson.changed},
            {"task", lesson.task}};
        for (const auto& [key, reason] : lesson.reasons) json["checks"][key] = reason;
        write_result(json.dump(2) + "\n");
        return kFine;
    }
    std::string text = fmt::format("{}\n\n{}\n\n{}\n\n{}\n{}\n", lesson.title, lesson.about, lesson.question,
                                   lesson.scene, lesson.prediction);
    for (std::size_t i = 0; i < lesson.choices.size(); ++i)
        text += fmt::format("  {}. {}\n", lesson::letter_of(i), lesson.choices[i]);
    text += fmt::format("\n{}\n\n", lesson.task);
    text += fmt::format(fmt::runtime(words_of(arguments.language).next), lesson.name);
    write_result(text);
    return kFine;
}

int predict(const LessonArguments& arguments) {
    const Lesson lesson = load(arguments);
    const std::string last = lesson::letter_of(lesson.choices.size() - 1);
    if (arguments.prediction.size() != 1 || arguments.prediction < "A" || arguments.prediction > last)
        throw UsageError(fmt::format("--predict: '{}' is not a letter from A to {}", arguments.prediction, last));
    const char* const blank = lesson.language == Language::kChinese ? "" : " ";
    write_result(lesson::verdict_on_prediction(lesson, static_cast<std::size_t>(arguments.prediction[0] - 'A')) +
                 blank + lesson.seen + "\n");
    return kFine;
}

int write_scene(const LessonArguments& arguments) {
    const Lesson lesson = load(arguments);
    const std::string& text = arguments.changed ? lesson.changed : lesson.scene;
    write_output(arguments.output, text);
    return kFine;
}

int check(const LessonArguments& arguments) {
    const Lesson lesson = load(arguments);
    const Words& words = words_of(arguments.language);
    const lesson::Grader grader(lesson);
    nlohmann::ordered_json json = {{"lesson", lesson.name}, {"answers", nlohmann::ordered_json::array()}};
    std::string text;
    std::size_t width = 0, right = 0;
    bool all_read = true;
    for (const std::string& file : arguments.answers) width = std::max(width, file.size());
    for (const std::string& file : arguments.answers) {
        lesson::Grade grade;
        bool is_read = true;
        try {
            grade = grader.grade(load_commands(file));
        } catch (const SceneError& error) {
            grade.reason = one_line(error.what());
        } catch (const FileError& error) {
            grade.reason = one_line(error.what());
            all_read = is_read = false;
        }
        right += grade.is_right;
        const char* verdict = grade.is_right ? words.right : is_read ? words.wrong : words.not_read;
        text += fmt::format("{:{}}  {}", one_line(file), width, verdict);
        if (!grade.check.empty()) text += fmt::format("  {}:", grade.check);
        if (!grade.reason.empty()) text += fmt::format("{}{}", grade.check.empty() ? "  " : " ", grade.reason);
        text += "\n";
        nlohmann::ordered_json one = {{"file", file}, {"right", grade.is_right}};
        if (!is_read) one["right"] = nullptr;
        one["check"] = grade.check.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(grade.check);
        one["reason"] = grade.reason;
        json["answers"].push_back(one);
    }
    json["right"] = right;
    if (arguments.answers.size() > 1) text += fmt::format(fmt::runtime(words.summary), right, arguments.answers.size());
    // A file's name may hold any bytes; JSON is UTF-8.
    write_result(arguments.json ? json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n"
                                : text);
    return !all_read ? kBadInput : right == arguments.answers.size() ? kFine : kDifferent;
}

int run_lesson(const LessonArguments& arguments) {
    const int wants = !arguments.answers.empty() + !arguments.output.empty() + !arguments.prediction.empty();
    if (wants > 1) throw UsageError("use only one of --check, --predict and -o");
    if (arguments.changed && arguments.output.empty()) throw UsageError("--changed needs -o FILE");
    if (arguments.name.empty()) {
        if (wants > 0) throw UsageError("NAME is required; 'twinlight lesson' lists the lessons");
        return list(arguments);
    }
    if (!arguments.answers.empty()) return check(arguments);
    if (!arguments.prediction.empty()) return predict(arguments);
    return arguments.output.empty() ? print(arguments) : write_scene(arguments);
}

}  // namespace

Subcommand add_lesson(CLI::App& app) {
    const auto arguments = std::make_shared<LessonArguments>();
    CLI::App* lesson = app.add_subcommand("lesson", "List the lessons, print one, or check answers to it");
    lesson->add_option("NAME", arguments->name, "print this lesson")->type_name("");
    lesson
        ->add_option("--check", arguments->answers,
                     "check answers: scenes in C or whole GLUT programs; prints right or wrong with the reason")
        ->type_name("FILE...")
        ->check(not_empty());
    lesson->add_option("--predict", arguments->prediction, "check a prediction: a letter, such as A")
        ->type_name("LETTER")
        ->check(not_empty());
    lesson->add_option("-o", arguments->output, "write the scene to start from to this file; - for standard output")
        ->type_name("FILE")
        ->check(not_empty());
    lesson->add_flag("--changed", arguments->changed, "with -o: write the scene with the change that was predicted");
    lesson
        ->add_option_function<std::string>(
            "--language",
            [arguments](const std::string& name) {
                const auto language = lesson::find_language(name);
                if (!language) throw CLI::ValidationError("--language", "'" + name + "' is not one of en, zh");
                arguments->language = *language;
            },
            "English or Chinese (default: the environment's language)")
        ->type_name("en|zh");
    lesson->add_flag("--json", arguments->json, "print one JSON object instead of text");
    lesson->footer(
        "'twinlight-demo --lesson NAME' opens a lesson in the window.\n"
        "Exit status: 0 success; with --check: 0 all answers are right, 1 some are wrong; 2 bad usage, or a "
        "file that\ncannot be read.");
    return {lesson, [arguments] { return run_lesson(*arguments); }};
}

}  // namespace twinlight::cli
