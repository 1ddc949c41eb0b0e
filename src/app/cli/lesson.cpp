// twinlight lesson: lists the lessons, prints one, writes its scene, grades answers.
#include "judge/lesson/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/lesson_class.h"
#include "app/cli/lint_files.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"

namespace twinlight::cli {

namespace {

using lesson::Language;
using lesson::Lesson;

struct LessonArguments {
    std::string name, output, prediction, csv;
    std::vector<std::string> answers;
    Language language = lesson::users_language();
    bool json = false, changed = false, measures = false, runs_programs = false;
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
    "To write the starting scene:             twinlight lesson {0} -o {0}.gl\n"
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
    Json json = {{"lessons", Json::array()}};
    std::string text;
    std::size_t width = 0;
    for (const std::string_view name : lesson::names()) width = std::max(width, name.size());
    for (const std::string_view name : lesson::names()) {
        const Lesson lesson = lesson::load_lesson(name, arguments.language);
        json["lessons"].push_back({{"name", name}, {"title", lesson.title}});
        text += fmt::format("{:{}}  {}\n", name, width, lesson.title);
    }
    write_result(arguments.json ? dumped_lines(json) : text);
    return kFine;
}

int print(const LessonArguments& arguments) {
    const Lesson lesson = load(arguments);
    if (arguments.json) {
        Json json = {{"name", lesson.name},       {"title", lesson.title},
                     {"about", lesson.about},     {"question", lesson.question},
                     {"scene", lesson.scene},     {"prediction", lesson.prediction},
                     {"choices", lesson.choices}, {"right_choice", lesson::letter_of(lesson.right_choice)},
                     {"seen", lesson.seen},       {"changed", lesson.changed},
                     {"task", lesson.task}};
        for (const lesson::Check& check : lesson.checks) json["checks"][check.key] = check.reason;
        write_result(dumped_lines(json));
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
    if (extension_of(arguments.output) == ".md") {
        if (arguments.changed) throw UsageError("--changed writes a scene, not a lesson; give -o FILE.gl");
        if (!lesson.folder.empty()) throw UsageError("-o: only a built-in lesson can be written; copy the file");
        write_output(arguments.output, lesson::text_of_lesson(lesson.name, arguments.language));
        return kFine;
    }
    const std::string& text = arguments.changed ? lesson.changed : lesson.scene;
    write_output(arguments.output, text);
    return kFine;
}

int check(const LessonArguments& arguments) {
    const Lesson lesson = load(arguments);
    const Words& words = words_of(arguments.language);
    const lesson::Grader grader(lesson);
    Json json = {{"lesson", lesson.name}, {"answers", Json::array()}};
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
        Json one = {{"file", file}, {"right", grade.is_right}};
        if (!is_read) one["right"] = nullptr;
        one["check"] = grade.check.empty() ? Json(nullptr) : Json(grade.check);
        one["reason"] = grade.reason;
        json["answers"].push_back(one);
    }
    json["right"] = right;
    if (arguments.answers.size() > 1) text += fmt::format(fmt::runtime(words.summary), right, arguments.answers.size());
    // A file's name may hold any bytes; JSON is UTF-8.
    write_result(arguments.json ? dumped_lines(json) : text);
    return !all_read ? kBadInput : right == arguments.answers.size() ? kFine : kDifferent;
}

// "red(x, y, width, height)"
std::string usage_of(const lesson::MeasureRow& row) {
    std::string parameters;
    for (const lesson::ParameterKind kind : row.parameters) {
        if (!parameters.empty()) parameters += ", ";
        switch (kind) {
            case lesson::ParameterKind::kBox: parameters += "x, y, width, height"; break;
            case lesson::ParameterKind::kObject: parameters += "object"; break;
            case lesson::ParameterKind::kObjects: parameters += "object, ..."; break;
            case lesson::ParameterKind::kVector:
                parameters += row.name == "color_error" ? "red, green, blue" : "x, y, z";
                break;
            case lesson::ParameterKind::kNumber: parameters += "number"; break;
            case lesson::ParameterKind::kText: parameters += "name"; break;
            case lesson::ParameterKind::kMaybeText: parameters += "[name]"; break;
        }
    }
    return fmt::format("{}({})", row.name, parameters);
}

// The table of docs/lessons/own.md.
int list_measures() {
    std::string text = "| measure | what it is |\n|---|---|\n";
    for (const lesson::MeasureRow& row : lesson::measures())
        text += fmt::format("| `{}` | {} |\n", usage_of(row), row.what);
    write_result(text);
    return kFine;
}

// --check FOLDER
int check_class(LessonArguments& arguments) {
    ClassArguments given{.folder = arguments.answers.front(),
                         .language = arguments.language,
                         .csv = arguments.csv,
                         .page = arguments.output,
                         .json = arguments.json,
                         .runs_programs = arguments.runs_programs};
    if (arguments.answers.size() > 1) throw UsageError("--check takes files, or one folder");
    if (arguments.json && arguments.csv == "-") throw UsageError("choose --json or --csv -");
    if (!arguments.name.empty()) given.lessons.push_back(load(arguments));
    return grade_class(given);
}

int run_lesson(LessonArguments& arguments) {
    if (arguments.measures) return list_measures();
    if (!arguments.answers.empty() && is_folder(arguments.answers.front()) && arguments.prediction.empty())
        return check_class(arguments);
    if (!arguments.csv.empty()) throw UsageError("--csv needs --check FOLDER");
    if (arguments.runs_programs) throw UsageError("--run needs --check FOLDER");
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
    lesson->add_option("NAME", arguments->name, "print this lesson: a built-in one, or a file, LESSON.md")
        ->type_name("");
    lesson
        ->add_option(
            "--check", arguments->answers,
            "check answers: scenes in C or whole GLUT programs; prints right or wrong with the reason. Or check "
            "a class: FOLDER/STUDENT/LESSON.gl or .c; prints a row for each student and lesson, with points")
        ->type_name("FILE...|FOLDER")
        ->check(not_empty());
    lesson->add_option("--predict", arguments->prediction, "check a prediction: a letter, such as A")
        ->type_name("LETTER")
        ->check(not_empty());
    lesson
        ->add_option("--csv", arguments->csv,
                     "with a folder: write the rows as a table for spreadsheets; - for standard output")
        ->type_name("FILE")
        ->check(not_empty());
    lesson->add_flag("--run", arguments->runs_programs,
                     "with a folder: compile, run and record answers that are programs, also in C++ and Python. They "
                     "run with all your rights");
    lesson
        ->add_option(
            "-o", arguments->output,
            "write the starting scene to this file, or the whole lesson to a file "
            "LESSON.md, to write your own; - for standard output. With a folder: write a page with all pictures there")
        ->type_name("FILE")
        ->check(not_empty());
    lesson->add_flag("--changed", arguments->changed, "with -o: write the scene with the change that was predicted");
    add_language_option(*lesson, arguments->language, "English or Chinese (default: the environment's language)");
    lesson->add_flag("--measures", arguments->measures, "list what the checks of your own lessons can measure");
    lesson->add_flag("--json", arguments->json, "print one JSON object instead of text");
    lesson->footer(
        "'twinlight-demo --lesson NAME' opens a lesson in the window.\n"
        "  twinlight lesson --check answers --csv marks.csv -o marks     a class: answers/STUDENT/LESSON.gl\n"
        "  twinlight lesson shininess -o glass.md                        a lesson to change into your own\n"
        "Exit status: 0 success; with --check: 0 all answers are right, 1 some are wrong; 2 bad usage, or a "
        "file that\ncannot be read.");
    return {lesson, [arguments] { return run_lesson(*arguments); }};
}

}  // namespace twinlight::cli
