#include "app/cli/lesson_class.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "app/cli/csv.h"
#include "app/cli/interrupt.h"
#include "app/cli/lint_files.h"
#include "app/cli/progress.h"
#include "app/cli/run_program.h"
#include "base/image/difference.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"
#include "judge/report/html.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"

namespace twinlight::cli {

namespace {

namespace fs = std::filesystem;

// The forms of an answer, the first that is there counts.
constexpr std::array<std::string_view, 7> kExtensions = {".gl", ".c", ".cpp", ".cc", ".cxx", ".py", ".trace"};

constexpr int kDifferenceFactor = 4;  // of the page's pictures

enum class Verdict : std::uint8_t { kRight, kWrong, kNotRead, kMissing };
struct VerdictWords {
    const char *english, *chinese;
};
constexpr std::array<VerdictWords, 4> kVerdicts = {
    {{"right", "正确"}, {"wrong", "错误"}, {"not read", "无法读取"}, {"missing", "未交"}}};

struct Row {
    std::string student, lesson, file{};  // the file is empty if it is missing
    Verdict verdict = Verdict::kMissing;
    int points = 0, most = 0;
    std::vector<std::string> reasons{};
    std::string picture{}, difference{};  // PNGs; empty without an answer that can be drawn

    bool is(Verdict one) const { return verdict == one; }
};

const char* word_of(Verdict verdict, lesson::Language language) {
    const VerdictWords& words = kVerdicts[static_cast<std::size_t>(verdict)];
    return language == lesson::Language::kChinese ? words.chinese : words.english;
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

std::vector<fs::path> entries_in(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (!is_hidden(at->path())) entries.push_back(at->path());
    if (error) throw FileError(fmt::format("{}: {}", folder.string(), error.message()));
    std::ranges::sort(entries);
    return entries;
}

bool is_answer(const fs::path& path) {
    return std::ranges::find(kExtensions, extension_of(path.string())) != kExtensions.end();
}

// A student's answers by the lessons' names. Of two answers to one lesson, the form that comes first in kExtensions.
std::map<std::string, fs::path> answers_of(const fs::path& folder) {
    std::map<std::string, fs::path> answers;
    const std::vector<fs::path> entries = entries_in(folder);
    for (const std::string_view extension : kExtensions)
        for (const fs::path& path : entries)
            if (extension_of(path.string()) == extension) answers.emplace(path.stem().string(), path);
    return answers;
}

struct Student {
    std::string name;
    fs::path folder;
    std::map<std::string, fs::path> answers;
};

std::vector<Student> students_of(const std::string& folder) {
    std::vector<Student> students;
    for (const fs::path& path : entries_in(folder))
        if (fs::is_directory(path)) students.push_back({path.filename().string(), path, answers_of(path)});
    if (students.empty())
        throw UsageError(fmt::format("{}: this folder has no student folders; answers must be FOLDER/STUDENT/LESSON.gl",
                                     one_line(folder)));
    return students;
}

// The folder's own lessons, then ours that a student answered, in the order of teaching.
std::vector<lesson::Lesson> lessons_of(const ClassArguments& arguments, const std::vector<Student>& students) {
    if (!arguments.lessons.empty()) return arguments.lessons;
    std::vector<lesson::Lesson> lessons;
    for (const fs::path& path : entries_in(arguments.folder))
        if (extension_of(path.string()) == ".md" && path.stem() != "README")
            lessons.push_back(load_lesson(path.string(), arguments.language));
    for (const std::string_view name : lesson::names()) {
        const auto has_answer = [&](const Student& student) { return student.answers.contains(std::string(name)); };
        if (std::ranges::find(lessons, name, &lesson::Lesson::name) == lessons.end() &&
            std::ranges::any_of(students, has_answer))
            lessons.push_back(lesson::load_lesson(name, arguments.language));
    }
    if (lessons.empty())
        throw UsageError(fmt::format("{}: no file in it is named after a lesson; 'twinlight lesson' lists the lessons",
                                     one_line(arguments.folder)));
    return lessons;
}

// Files that are answers to no lesson here, so that none is overlooked.
void name_others(const std::vector<Student>& students, const std::vector<lesson::Lesson>& lessons) {
    for (const Student& student : students)
        for (const fs::path& path : entries_in(student.folder)) {
            const std::string name = path.stem().string();
            if (!is_answer(path)) continue;
            if (std::ranges::find(lessons, name, &lesson::Lesson::name) == lessons.end())
                print_message("twinlight: note: {}: not graded; no lesson here is named '{}'\n",
                              one_line(path.string()), one_line(name));
            else if (student.answers.at(name) != path)
                print_message("twinlight: note: {}: not graded; {} is\n", one_line(path.string()),
                              one_line(student.answers.at(name).filename().string()));
        }
}

std::shared_ptr<const CommandList> commands_of_answer(const ClassArguments& arguments, const std::string& file) {
    if (!arguments.runs_programs && extension_of(file) != ".trace") return load_commands(file);
    if (extension_of(file) == ".gl") return load_commands(file);
    RunInstead run{.is_on = arguments.runs_programs && extension_of(file) != ".trace", .name_of_command = "lesson"};
    RecordedPart part;
    const std::string recorded = recorded_first(run, file, part);
    return std::make_shared<CommandList>(commands_to_print(load_scene(recorded, std::nullopt, part)));
}

struct LessonToGrade {
    explicit LessonToGrade(const lesson::Lesson& to_grade) : lesson(to_grade) {}

    const lesson::Lesson& lesson;
    lesson::Grader grader{lesson};
};

void grade_answer(const ClassArguments& arguments, const LessonToGrade& lesson, Row& row) {
    const char* const how = arguments.runs_programs ? "" : "twinlight lesson --check FOLDER --run";
    const auto fail = [&](Verdict verdict, const std::exception& error) {
        row.verdict = verdict;
        row.reasons = {why_not_read(error, row.file, how)};
    };
    std::shared_ptr<const CommandList> answer;
    try {
        answer = commands_of_answer(arguments, row.file);
    } catch (const std::exception& error) {
        fail(Verdict::kNotRead, error);
        return;
    }
    try {
        const lesson::Work work(answer, &lesson.grader.start());
        const lesson::Marks marks = lesson.grader.marks(work);
        row.points = marks.points;
        row.verdict = Verdict::kRight;
        for (const lesson::Marks::Result& result : marks.results) {
            if (result.is_passed) continue;
            row.verdict = Verdict::kWrong;
            row.reasons.push_back(fmt::format("{}: {}", result.key, result.reason));
        }
        if (arguments.page.empty()) return;
        row.picture = encode_png(work.picture());
        row.difference = encode_png(difference_picture(work.picture(), work.start().picture(), kDifferenceFactor));
    } catch (const SceneError& error) {  // OpenGL refuses it
        fail(Verdict::kWrong, error);
    } catch (const std::exception& error) {
        fail(Verdict::kNotRead, error);
    }
}

std::string marks_text(const std::vector<Row>& rows, lesson::Language language) {
    std::size_t students = 0, lessons = 0;
    for (const Row& row : rows) {
        students = std::max(students, one_line(row.student).size());
        lessons = std::max(lessons, row.lesson.size());
    }
    std::string text;
    for (const Row& row : rows)
        text += fmt::format("{:<{}}  {:<{}}  {}/{}  {}{}{}\n", one_line(row.student), students, row.lesson, lessons,
                            row.points, row.most, word_of(row.verdict, language), row.reasons.empty() ? "" : "  ",
                            one_line(fmt::format("{}", fmt::join(row.reasons, " "))));
    const auto count = [&](Verdict verdict) {
        return std::ranges::count_if(rows, [&](const Row& row) { return row.is(verdict); });
    };
    text += "\n";
    for (const Verdict verdict : {Verdict::kRight, Verdict::kWrong, Verdict::kNotRead, Verdict::kMissing})
        text +=
            fmt::format("{}{} {}", verdict == Verdict::kRight ? "" : ", ", count(verdict), word_of(verdict, language));
    return text + "\n";
}

std::string marks_csv(const std::vector<Row>& rows) {
    std::string text = "student,lesson,points,of,result,reasons\n";
    for (const Row& row : rows)
        text += fmt::format("{},{},{},{},{},{}\n", csv_field(row.student), csv_field(row.lesson), row.points, row.most,
                            word_of(row.verdict, lesson::Language::kEnglish),
                            csv_field(one_line(fmt::format("{}", fmt::join(row.reasons, " ")))));
    return text;
}

std::string marks_json(const std::vector<Row>& rows) {
    Json json = {{"answers", Json::array()}};
    for (const Row& row : rows)
        json["answers"].push_back({{"student", row.student},
                                   {"lesson", row.lesson},
                                   {"file", row.file.empty() ? Json(nullptr) : Json(row.file)},
                                   {"result", word_of(row.verdict, lesson::Language::kEnglish)},
                                   {"points", row.points},
                                   {"of", row.most},
                                   {"reasons", row.reasons}});
    return dumped_lines(json);
}

// ---- The page ----

std::string without_code_marks(std::string markdown) {
    std::erase(markdown, '`');
    return markdown;
}

std::string marks_figure(const std::string& png, const std::string& about) {
    return png.empty() ? "<td></td>"
                       : fmt::format("<td><img src=\"{}\" alt=\"{}\" width=\"160\" height=\"120\"></td>",
                                     report::data_uri(png), report::escaped(about));
}

std::string marks_page(const std::vector<Row>& rows, const std::deque<LessonToGrade>& lessons,
                       lesson::Language language) {
    const bool chinese = language == lesson::Language::kChinese;
    std::string html = report::page_head(chinese ? "成绩" : "Marks", std::string(report::page_file("page.css")) +
                                                                         std::string(report::page_file("marks.css")));
    html += fmt::format("<body>\n<h1>{}</h1>\n", chinese ? "成绩" : "Marks");
    for (const LessonToGrade& one : lessons) {
        html += fmt::format("<h2>{}</h2>\n", report::escaped(one.lesson.title));
        html += fmt::format("<p>{}</p>\n", report::escaped(without_code_marks(one.lesson.task)));
        html += fmt::format(
            "<table class=\"marks\"><thead><tr><th scope=\"col\">{}</th><th scope=\"col\">{}</th><th "
            "scope=\"col\">{}</th><th scope=\"col\">{}</th><th scope=\"col\">{}</th></tr></thead>\n<tbody>\n",
            chinese ? "学生" : "Student", chinese ? "得分" : "Points", chinese ? "图像" : "Picture",
            chinese ? fmt::format("与起始场景之差（{} 倍）", kDifferenceFactor)
                    : fmt::format("Difference from the start ({} times)", kDifferenceFactor),
            chinese ? "理由" : "Why");
        html += fmt::format(
            "<tr><th scope=\"row\">{}</th><td></td>{}<td></td><td></td></tr>\n",
            chinese ? "起始场景" : "The starting scene",
            marks_figure(encode_png(one.grader.start().picture()), chinese ? "起始场景" : "the starting scene"));
        for (const Row& row : rows) {
            if (row.lesson != one.lesson.name) continue;
            std::string why;
            for (const std::string& reason : row.reasons) why += fmt::format("<p>{}</p>", report::escaped(reason));
            html += fmt::format(
                "<tr class=\"{}\"><th scope=\"row\">{}</th><td>{}/{}<br>{}</td>{}{}<td class=\"why\">{}</td></tr>\n",
                row.is(Verdict::kRight) ? "within" : "beyond", report::escaped(row.student), row.points, row.most,
                word_of(row.verdict, language), marks_figure(row.picture, row.student),
                marks_figure(row.difference, row.student), why);
        }
        html += "</tbody></table>\n";
    }
    return html + "</body>\n</html>\n";
}

}  // namespace

int grade_class(const ClassArguments& arguments) {
    const std::vector<Student> students = students_of(arguments.folder);
    const std::vector<lesson::Lesson> lessons = lessons_of(arguments, students);
    if (!arguments.page.empty()) {
        try_folder(arguments.page);
        const fs::path inside =
            fs::weakly_canonical(arguments.page).lexically_relative(fs::weakly_canonical(arguments.folder));
        if (!inside.empty() && *inside.begin() != "..")
            throw UsageError(
                fmt::format("-o {}: this is among the answers; choose a folder beside them", one_line(arguments.page)));
    }
    name_others(students, lessons);
    if (arguments.runs_programs)
        print_message("twinlight: note: compiles and runs the programs of {}, with your rights and without a sandbox\n",
                      one_line(arguments.folder));
    std::deque<LessonToGrade> graders;
    for (const lesson::Lesson& lesson : lessons) graders.emplace_back(lesson);

    std::vector<Row> rows;
    const std::size_t all = students.size() * lessons.size();
    ProgressBar bar;
    const Interrupt interrupt;
    for (const Student& student : students) {
        for (const LessonToGrade& one : graders) {
            if (Interrupt::came()) break;
            bar.show(static_cast<int>(rows.size()), static_cast<int>(all), student.name);
            Row row{.student = student.name, .lesson = one.lesson.name, .most = one.grader.most_points()};
            if (const auto answer = student.answers.find(row.lesson); answer != student.answers.end()) {
                row.file = answer->second.string();
                grade_answer(arguments, one, row);
            }
            rows.push_back(std::move(row));
        }
    }
    bar.wipe();
    std::vector<std::pair<std::string, std::string>> contents;
    if (!arguments.page.empty())
        contents.emplace_back((fs::path(arguments.page) / "index.html").string(),
                              marks_page(rows, graders, arguments.language));
    const std::string csv = marks_csv(rows);
    if (!arguments.csv.empty() && arguments.csv != "-") contents.emplace_back(arguments.csv, csv);
    std::vector<FileToWrite> files;
    for (const auto& [path, bytes] : contents) files.push_back({path, bytes});
    if (!files.empty()) write_files_atomically(files, {}, MissingFolders::kMade);
    write_result(arguments.csv == "-" ? csv : arguments.json ? marks_json(rows) : marks_text(rows, arguments.language));
    if (rows.size() < all) print_message("twinlight: note: stopped after {} of {} answers\n", rows.size(), all);
    if (rows.size() < all || std::ranges::any_of(rows, [](const Row& row) { return row.is(Verdict::kNotRead); }))
        return kBadInput;
    return std::ranges::all_of(rows, [](const Row& row) { return row.is(Verdict::kRight); }) ? kFine : kDifferent;
}

}  // namespace twinlight::cli
