// The lessons: their pages in both languages, and three right and three wrong answers to each (tests/lessons/NAME).
//
// The first line of an answer is "// Right: why" or "// Wrong (KEY): why"; KEY is the check that must fail, or "unreadable".
#include "judge/lesson/lesson.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"
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
    for (const Check& check : lesson.checks) keys.push_back(check.key);
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
    for (std::size_t i = 0; i < english.checks.size(); ++i)
        EXPECT_EQ(english.checks[i].reason.find("{value}") == std::string::npos,
                  chinese.checks[i].reason.find("{value}") == std::string::npos)
            << english.checks[i].key;
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
        // Marks agree with the grade.
        if (check != "unreadable") {
            const Marks marks = grader.marks(Work(load_commands(file), &grader.start()));
            EXPECT_EQ(marks.points == marks.most, grade.is_right);
            EXPECT_EQ(marks.most, grader.most_points());
            EXPECT_EQ(marks.results.size(), page().checks.size());
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

constexpr const char* kPage =
    "# T\nabout\n## Q\nq\n```c\nglEnable(GL_LIGHT0);\n```\n## P\np\n- A. a\n- B. b\n## S\n**A.** s\n```diff\n"
    "-glEnable(GL_LIGHT0);\n+glEnable(GL_LIGHT1);\n```\n## T\nt\n## C\n- `key` (`calls(glEnable) is 1`): reason "
    "{value}\n";

std::string error_of_page(const std::string& old_text, const std::string& new_text) {
    std::string broken = kPage;
    broken.replace(broken.find(old_text), old_text.size(), new_text);
    try {
        read_lesson(broken, "page");
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(LessonPages, AreRefusedWithTheLine) {
    const Lesson lesson = read_lesson(kPage, "page");
    EXPECT_EQ(lesson.changed, "glEnable(GL_LIGHT1);\n");
    EXPECT_EQ(lesson.seen, "s");
    ASSERT_EQ(lesson.checks.size(), 1U);
    EXPECT_EQ(lesson.checks[0].key, "key");
    EXPECT_EQ(lesson.checks[0].reason, "reason {value}");
    EXPECT_EQ(error_of_page("- B. b", "- C. b"), "page.md:11: the next choice must start with '- B. '");
    EXPECT_EQ(error_of_page("**A.**", "**C.**"), "page.md:21: the right choice is not in the list");
    EXPECT_EQ(error_of_page("-glEnable", "-glDisable"), "page.md:21: the scene has no line 'glDisable(GL_LIGHT0);'");
    EXPECT_EQ(error_of_page("## C\n", ""), "page.md:20: a lesson has five headings");
}

TEST(LessonPages, AreRefusedWhereACheckIsWrong) {
    const std::string good = "(`calls(glEnable) is 1`): reason {value}";
    const auto error_of = [&](const std::string& check) { return error_of_page(good, "(`" + check + "`): no"); };
    EXPECT_EQ(error_of("calls(glEnable) is 1"), "");
    EXPECT_EQ(error_of_page(good, ": reason"), "page.md:21: a check must be '- `key` (`condition`): reason'");
    EXPECT_EQ(error_of_page(good, "(`lit(1) is 1`):"), "page.md:21: the check has no reason after ':'");
    EXPECT_EQ(error_of_page("- `key` " + good, "-"),
              "page.md:21: a lesson needs a check: '- `key` (`condition`): reason'");
    EXPECT_EQ(error_of("blu(1, 2, 3, 4) is 1"), "page.md:21: there is no measure 'blu'; did you mean 'blue'?");
    EXPECT_EQ(error_of("zebra() is 1"),
              "page.md:21: there is no measure 'zebra'; 'twinlight lesson --measures' lists them");
    EXPECT_EQ(error_of("lit(1)"),
              "page.md:21: a check must end with 'at least N', 'at most N', 'from N to N' or 'is N'");
    EXPECT_EQ(error_of("lit(0) is 1"), "page.md:21: an object's number must be a whole number from 1 to 1000");
    EXPECT_EQ(error_of("red(1, 2, 3) is 1"), "page.md:21: ',' is missing in red(...)");
    EXPECT_EQ(error_of("red(1, 2, 3, 4 is 1"), "page.md:21: ')' is missing at the end of red");
    EXPECT_EQ(error_of("lit(1) from 2 to 1"), "page.md:21: the numbers after 'from' and 'to' are the wrong way round");
    EXPECT_EQ(error_of("lit(1) is 1 2"), "page.md:21: '2' is left over at the end");
    EXPECT_EQ(error_of("lit(1) is inf"), "page.md:21: 'inf' must start with a number");
    EXPECT_EQ(error_of("lit(1) at least"), "page.md:21: a number is missing at the end");
    EXPECT_EQ(error_of("calls(glLihgt) is 1"), "page.md:21: there is no command 'glLihgt'");
    EXPECT_EQ(error_of("calls(glEnable, GL_ZEBRA) is 1"), "page.md:21: OpenGL has no name 'GL_ZEBRA'");
    EXPECT_EQ(error_of("warnings(\"zebra\") is 0"), "page.md:21: the linter has no rule 'zebra'");
    EXPECT_EQ(error_of("unlike(\"../goal.png\", 2) at most 0"),
              "page.md:21: '../goal.png': the picture must be beside the lesson, in the same folder");
    EXPECT_EQ(error_of(std::string(60, '(') + "1" + std::string(60, ')') + " is 1"),
              "page.md:21: the check has too many parentheses");
}

// What a condition measures in this scene: a red square from 160, 120 to 480, 360 of 640 x 480.
double measured(const std::string& value, const std::string& folder = "") {
    static const auto commands = std::make_shared<const CommandList>(
        read_scene("glClear(GL_COLOR_BUFFER_BIT);\nglDisable(GL_LIGHTING);\nglColor3f(0.8, 0.2, 0);\n"
                   "glRectf(-0.5, -0.5, 0.5, 0.5);\n",
                   "square.gl", "square"));
    static const Work work(commands);
    return read_condition(value + " is 0", folder).measure(work);
}

TEST(LessonConditions, CalculateAndMeasure) {
    EXPECT_EQ(measured("1 + 2 * 3 - 4 / 2"), 5);
    EXPECT_EQ(measured("(1 + 2) * -3"), -9);
    EXPECT_EQ(measured("abs(2 - 5) + min(3, 1, 2) + max(1, 7)"), 11);
    EXPECT_TRUE(std::isnan(measured("max(1, 0 / 0)")));
    EXPECT_NEAR(measured("red(200, 150, 100, 100)"), 0.8, 0.5 / 255);
    EXPECT_NEAR(measured("red()"), 0.8 / 4, 0.5 / 255);
    EXPECT_EQ(measured("green(0, 0, 100, 100)"), 0);
    EXPECT_NEAR(measured("color_error(200, 150, 100, 100, 0.8, 0.2, 0.5)"), 0.5, 0.5 / 255);
    EXPECT_NEAR(measured("colors_apart(200, 150, 100, 100, 0, 0, 100, 100)"), 0.8, 0.5 / 255);
    EXPECT_EQ(measured("objects_moved() + change() + lit(1)"), 0);
    EXPECT_EQ(measured("calls(glRectf) + 10 * calls(glEnable)"), 1);
    EXPECT_EQ(measured("calls(glDisable, GL_LIGHTING) + 10 * calls(glDisable, GL_FOG)"), 1);
    EXPECT_EQ(measured("warnings(\"light-before-camera\")"), 0);
    EXPECT_TRUE(std::isnan(measured("highlight_x()")));  // it has none
}

TEST(LessonConditions, HoldBetweenTheirBounds) {
    const auto holds = [](const std::string& bound, double value) {
        return read_condition("1 " + bound, "").holds(value);
    };
    EXPECT_TRUE(holds("at least 2", 2) && holds("at most 2", 2) && holds("from 1 to 3", 1) && holds("is 2", 2));
    EXPECT_FALSE(holds("at least 2", 1.9) || holds("at most 2", 2.1) || holds("from 1 to 3", 3.1) ||
                 holds("is 2", 2.1));
    for (const char* bound : {"at least 2", "at most 2", "from 1 to 3", "is 2"})
        EXPECT_FALSE(holds(bound, std::nan(""))) << bound;
}

// Where the highlight is: a ball in the middle, lit from the right, has it right of the middle.
TEST(LessonConditions, FindTheHighlightAndComparePictures) {
    const auto ball = [](double x) {
        return std::make_shared<const CommandList>(read_scene(
            fmt::format(
                "glClear(GL_COLOR_BUFFER_BIT);\nglMatrixMode(GL_PROJECTION);\nglOrtho(-1, 1, -1, 1, -1, 1);\n"
                "glMatrixMode(GL_MODELVIEW);\nglEnable(GL_CULL_FACE);\nglEnable(GL_LIGHTING);\nglEnable(GL_LIGHT0);\n"
                "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){{{}, 0, 1, 0}});\n"
                "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){{1, 1, 1, 1}});\n"
                "glMaterialf(GL_FRONT, GL_SHININESS, 40);\nglScalef(0.75, 1, 1);\nglEnable(GL_NORMALIZE);\n"
                "glutSolidSphere(0.8, 64, 32);\n",
                x),
            "ball.gl", "ball"));
    };
    const Work middle(ball(0)), right(ball(1), &middle);
    const auto value_in = [](const Work& work, const std::string& value, const std::string& folder = "") {
        return read_condition(value + " is 0", folder).measure(work);
    };
    EXPECT_NEAR(value_in(middle, "highlight_x()"), 320, 2);
    EXPECT_NEAR(value_in(middle, "highlight_y()"), 240, 2);
    EXPECT_GT(value_in(right, "highlight_x()"), 350);
    EXPECT_NEAR(value_in(right, "at_start(highlight_x())"), 320, 2);
    const TemporaryFolder folder;
    write_png(folder / "goal.png", right.picture_of_size(200, 150));
    EXPECT_EQ(value_in(right, "unlike(\"goal.png\", 1)", folder.str()), 0);
    EXPECT_GT(value_in(middle, "unlike(\"goal.png\", 8)", folder.str()), 0.05);
}

}  // namespace
}  // namespace twinlight::lesson::lesson_test
