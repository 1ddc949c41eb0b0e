// twinlight lesson, as built: what it prints and writes, its exit status.
#include <gtest/gtest.h>

#include <algorithm>

#include "../run_program.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "judge/lesson/lesson.h"

namespace twinlight::lesson_cli_test {
namespace {

using nlohmann::json;

ProgramResult run_lesson(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "lesson");
    arguments.insert(arguments.end(), {"--language", "en"});
    return run_program("twinlight", arguments);
}

TEST(LessonCommand, ListsTheLessonsAndPrintsOne) {
    const ProgramResult list = run_lesson({});
    EXPECT_EQ(list.status, 0);
    EXPECT_EQ(std::ranges::count(list.out, '\n'), static_cast<long>(lesson::names().size()));
    const json listed = json::parse(run_lesson({"--json"}).out);
    const ProgramResult text = run_lesson({"shininess"});
    EXPECT_EQ(text.status, 0);
    const lesson::Lesson page = lesson::load_lesson("shininess", lesson::Language::kEnglish);
    for (const std::string& part : {page.title, page.about, page.question, page.scene, page.prediction, page.task})
        EXPECT_NE(text.out.find(part), std::string::npos) << part;
    EXPECT_EQ(text.out.find(page.seen), std::string::npos);  // it would give the prediction away
    for (std::size_t i = 0; i < lesson::names().size(); ++i) {
        const std::string name(lesson::names()[i]);
        EXPECT_EQ(listed["lessons"][i]["name"], name);
        EXPECT_EQ(json::parse(run_lesson({name, "--json"}).out)["title"], listed["lessons"][i]["title"]);
    }
}

TEST(LessonCommand, SpeaksTheLanguageOfTheEnvironment) {
    const std::string chinese = lesson::load_lesson("shininess", lesson::Language::kChinese).title;
    const auto first_line = [](const std::string& line) {
        const std::string out = run_shell("twinlight", line).out;
        return out.substr(0, out.find('\n'));
    };
    EXPECT_EQ(first_line("LC_ALL=zh_CN.UTF-8 \"$PROGRAM\" lesson shininess"), chinese);
    EXPECT_EQ(first_line("LC_ALL= LC_MESSAGES= LANG=zh_CN.UTF-8 \"$PROGRAM\" lesson shininess"), chinese);
    EXPECT_EQ(first_line("LC_ALL=C LANG=zh_CN.UTF-8 \"$PROGRAM\" lesson shininess"),
              lesson::load_lesson("shininess", lesson::Language::kEnglish).title);
    EXPECT_EQ(first_line("LC_ALL=C \"$PROGRAM\" lesson shininess --language zh"), chinese);
}

TEST(LessonCommand, SaysWhetherAPredictionIsRight) {
    const lesson::Lesson page = lesson::load_lesson("shininess", lesson::Language::kEnglish);
    EXPECT_EQ(run_lesson({"shininess", "--predict", "B"}).out, "B is right. " + page.seen + "\n");
    const ProgramResult wrong = run_lesson({"shininess", "--predict", "A"});
    EXPECT_EQ(wrong.status, 0);
    EXPECT_EQ(wrong.out, "A is wrong; B is right. " + page.seen + "\n");
}

TEST(LessonCommand, WritesTheSceneAndGradesIt) {
    const TemporaryFolder folder;
    const std::string start = folder / "start.gl", changed = folder / "changed.gl", missing = folder / "missing.gl";
    EXPECT_EQ(run_lesson({"shininess", "-o", start}).status, 0);
    EXPECT_EQ(run_lesson({"shininess", "--changed", "-o", changed}).status, 0);
    const lesson::Lesson page = lesson::load_lesson("shininess", lesson::Language::kEnglish);
    EXPECT_EQ(read_file(start), page.scene);
    EXPECT_EQ(read_file(changed), page.changed);
    EXPECT_EQ(run_lesson({"shininess", "-o", "-"}).out, page.scene);

    const std::string right = "tests/lessons/shininess/right-1.gl", wrong = "tests/lessons/shininess/wrong-3.gl";
    const ProgramResult one = run_lesson({"shininess", "--check", right});
    EXPECT_EQ(one.status, 0);
    EXPECT_EQ(one.out, right + "  right\n");
    const ProgramResult table = run_lesson({"shininess", "--check", right, start, wrong});
    EXPECT_EQ(table.status, 1);
    EXPECT_NE(table.out.find("right-1.gl  right\n"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("  wrong  size: The highlight covers 1 times"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("  wrong  tests/lessons/shininess/wrong-3.gl:16:1: GL_SHININESS is 500"),
              std::string::npos)
        << table.out;
    EXPECT_TRUE(table.out.ends_with("\n1 of 3 right.\n")) << table.out;

    // A file that is not there does not stop the others.
    const ProgramResult some = run_lesson({"shininess", "--json", "--check", missing, right, start});
    EXPECT_EQ(some.status, 2);
    const json graded = json::parse(some.out);
    EXPECT_EQ(graded["lesson"], "shininess");
    EXPECT_EQ(graded["right"], 1);
    EXPECT_TRUE(graded["answers"][0]["right"].is_null());
    EXPECT_EQ(graded["answers"][1], json({{"file", right}, {"right", true}, {"check", nullptr}, {"reason", ""}}));
    EXPECT_EQ(graded["answers"][2]["check"], "size");
}

TEST(LessonCommand, RefusesBadUse) {
    const auto error_of = [](const std::vector<std::string>& arguments) {
        const ProgramResult result = run_lesson(arguments);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        return result.err;
    };
    EXPECT_EQ(error_of({"shinines"}), "twinlight: there is no lesson 'shinines'; did you mean 'shininess'?\n");
    EXPECT_EQ(error_of({"zebra"}), "twinlight: there is no lesson 'zebra'; 'twinlight lesson' lists the lessons\n");
    EXPECT_EQ(error_of({"--check", "a.gl"}), "twinlight: NAME is required; 'twinlight lesson' lists the lessons\n");
    EXPECT_EQ(error_of({"shininess", "--predict", "Q"}), "twinlight: --predict: 'Q' is not a letter from A to C\n");
    EXPECT_EQ(error_of({"shininess", "--changed"}), "twinlight: --changed needs -o FILE\n");
    EXPECT_EQ(error_of({"shininess", "--predict", "A", "-o", "a.gl"}),
              "twinlight: use only one of --check, --predict and -o\n");
    EXPECT_NE(run_program("twinlight", {"lesson", "--language", "fr"}).err.find("'fr' is not one of en, zh"),
              std::string::npos);
}

}  // namespace
}  // namespace twinlight::lesson_cli_test
