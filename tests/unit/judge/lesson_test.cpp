// The lessons: their pages in both languages, and three right and three wrong answers to each (tests/lessons/NAME).
//
// The first line of an answer is "// Right: why" or "// Wrong (KEY): why"; KEY is the check that must fail, or "unreadable".
#include "judge/lesson/lesson.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"

namespace twinlight::lesson::lesson_test {
namespace {

namespace fs = std::filesystem;

class Lessons : public testing::TestWithParam<std::string_view> {
  protected:
    Lesson page(Language language = Language::kEnglish) const { return load_lesson(GetParam(), language); }
};

std::vector<std::string> keys_of(const Lesson& lesson) {
    std::vector<std::string> keys;
    for (const auto& [key, reason] : lesson.reasons) keys.push_back(key);
    return keys;
}

// Each language has the same scene and change (but for comments), choices, and checks in the same order.
TEST_P(Lessons, AreTheSameInBothLanguages) {
    const Lesson english = page(), chinese = page(Language::kChinese);
    EXPECT_EQ(english.choices.size(), chinese.choices.size());
    EXPECT_EQ(english.right_choice, chinese.right_choice);
    EXPECT_EQ(keys_of(english), keys_of(chinese));
    EXPECT_EQ(commands_of(english, english.scene)->commands, commands_of(chinese, chinese.scene)->commands);
    EXPECT_EQ(commands_of(english, english.changed)->commands, commands_of(chinese, chinese.changed)->commands);
    for (const Lesson& lesson : {english, chinese}) {
        for (const std::string& text :
             {lesson.title, lesson.about, lesson.question, lesson.prediction, lesson.seen, lesson.task})
            EXPECT_NE(text, "") << lesson.title;
        EXPECT_GE(lesson.choices.size(), 3U);
    }
    EXPECT_EQ(std::ranges::count_if(english.task, [](unsigned char c) { return c > 127; }), 0);
    EXPECT_GT(std::ranges::count_if(chinese.task, [](unsigned char c) { return c > 127; }), 30);
    // A reason has its number in both languages or in none.
    for (std::size_t i = 0; i < english.reasons.size(); ++i)
        EXPECT_EQ(english.reasons[i].second.find("{value}") == std::string::npos,
                  chinese.reasons[i].second.find("{value}") == std::string::npos)
            << english.reasons[i].first;
}

TEST_P(Lessons, HaveAReasonForEachCheckAndNoOther) {
    std::vector<std::string> keys;
    for (const Check& check : checks_of(GetParam())) keys.emplace_back(check.key);
    EXPECT_EQ(keys_of(page()), keys);
}

// The scene to start from is a wrong answer that can be drawn, and the change of the prediction is no solution either.
TEST_P(Lessons, StartWithAWrongAnswer) {
    const Lesson lesson = page();
    const Grader grader(lesson);
    for (const std::string& text : {lesson.scene, lesson.changed}) {
        const Grade grade = grader.grade(commands_of(lesson, text));
        EXPECT_FALSE(grade.is_right);
        EXPECT_NE(grade.check, "") << grade.reason;
    }
}

TEST_P(Lessons, GradeThreeRightAndThreeWrongAnswers) {
    const Grader grader(page());
    const std::regex right("// Right: .*"), wrong("// Wrong \\(([a-z-]+)\\): .*");
    int right_answers = 0, wrong_answers = 0;
    for (const auto& entry : fs::directory_iterator("tests/lessons/" + std::string(GetParam()))) {
        const std::string file = entry.path().string(), text = read_file(file);
        SCOPED_TRACE(file);
        Grade grade;
        std::string check;
        try {
            grade = grader.grade(load_commands(file));
            check = grade.check.empty() ? "unreadable" : grade.check;
        } catch (const SceneError& error) {
            grade.reason = error.what();
            check = "unreadable";
        }
        const std::string head = text.substr(0, text.find('\n'));
        std::smatch key;
        if (std::regex_match(head, key, wrong)) {
            ++wrong_answers;
            EXPECT_FALSE(grade.is_right);
            EXPECT_EQ(check, key.str(1)) << grade.reason;
            EXPECT_EQ(grade.reason.find_first_of("{}\n"), std::string::npos) << grade.reason;
            EXPECT_EQ(grade.reason.find("nan"), std::string::npos) << grade.reason;
        } else {
            ++right_answers;
            EXPECT_TRUE(std::regex_match(head, right)) << head;
            EXPECT_TRUE(grade.is_right) << grade.check << ": " << grade.reason;
        }
    }
    EXPECT_GE(right_answers, 3);
    EXPECT_GE(wrong_answers, 3);
}

INSTANTIATE_TEST_SUITE_P(All, Lessons, testing::ValuesIn(names().begin(), names().end()), [](const auto& parameter) {
    std::string name(parameter.param);
    std::ranges::replace(name, '-', '_');
    return name;
});

// Every page is in the table, in both languages.
TEST(LessonPages, AreAllLessons) {
    const std::set<std::string> table(names().begin(), names().end());
    EXPECT_GE(table.size(), 12U);
    for (const std::vector<EmbeddedFile>& files : {kLessonFiles, kChineseLessonFiles}) {
        std::set<std::string> pages;
        for (const EmbeddedFile& file : files) pages.emplace(file.name.substr(0, file.name.rfind(".md")));
        EXPECT_EQ(pages, table);
    }
}

// The rows "| [name](name.md) | title |" of both indices, in the order of teaching.
TEST(LessonPages, AreInTheIndex) {
    for (const Language language : {Language::kEnglish, Language::kChinese}) {
        const std::string index =
            read_file(language == Language::kChinese ? "docs/zh-CN/lessons/README.md" : "docs/lessons/README.md");
        std::string rows;
        for (const std::string_view name : names())
            rows += fmt::format("| [{0}]({0}.md) | {1} |\n", name, load_lesson(name, language).title);
        EXPECT_NE(index.find("\n|---|---|\n" + rows), std::string::npos) << rows;
    }
}

// Each page shows its two pictures (tests/lessons/pictures.sh).
TEST(LessonPages, HaveTheirPictures) {
    for (const std::string_view name : names()) {
        for (const char* folder : {"docs/lessons/", "docs/zh-CN/lessons/"}) {
            const std::string page = read_file(fmt::format("{}{}.md", folder, name));
            for (const char* which : {"", "-changed"})
                EXPECT_NE(page.find(fmt::format("pictures/{}{}.png)", name, which)), std::string::npos) << name;
        }
        for (const char* which : {"", "-changed"})
            EXPECT_TRUE(fs::exists(fmt::format("docs/lessons/pictures/{}{}.png", name, which))) << name;
    }
}

TEST(LessonPages, AreRefusedWithTheLine) {
    const std::string page =
        "# T\nabout\n## Q\nq\n```c\nglEnable(GL_LIGHT0);\n```\n## P\np\n- A. a\n- B. b\n## S\n**A.** s\n```diff\n"
        "-glEnable(GL_LIGHT0);\n+glEnable(GL_LIGHT1);\n```\n## T\nt\n## C\n- `key`: reason\n";
    const Lesson lesson = read_lesson(page, "page");
    EXPECT_EQ(lesson.changed, "glEnable(GL_LIGHT1);\n");
    EXPECT_EQ(lesson.seen, "s");
    EXPECT_EQ(lesson.reasons, (std::vector<std::pair<std::string, std::string>>{{"key", "reason"}}));
    const auto error_of = [&](const std::string& old_text, const std::string& new_text) -> std::string {
        std::string broken = page;
        broken.replace(broken.find(old_text), old_text.size(), new_text);
        try {
            read_lesson(broken, "page");
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(error_of("- B. b", "- C. b"), "page.md:11: the next choice must start with '- B. '");
    EXPECT_EQ(error_of("**A.**", "**C.**"), "page.md:21: the right choice is not in the list");
    EXPECT_EQ(error_of("-glEnable", "-glDisable"), "page.md:21: the scene has no line 'glDisable(GL_LIGHT0);'");
    EXPECT_EQ(error_of("## C\n", ""), "page.md:20: a lesson has five headings");
}

}  // namespace
}  // namespace twinlight::lesson::lesson_test
