// twinlight lesson, as built: what it prints and writes, its exit status.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

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

// A teacher starts from a copy of a built-in lesson.
TEST(LessonCommand, TakesATeachersLesson) {
    const TemporaryFolder folder;
    const std::string own = folder / "glass.md", start = folder / "start.gl";
    EXPECT_EQ(run_lesson({"shininess", "-o", own}).status, 0);
    std::string text = read_file(own);
    EXPECT_EQ(text, lesson::text_of_lesson("shininess", lesson::Language::kEnglish));
    const std::string title = text.substr(0, text.find('\n'));
    text.replace(0, title.size(), "# Glass");
    text += "- `own` (`calls(glMaterialf) at most 1`): glMaterialf is called {value} times.\n";
    write_file_atomically(own, text);
    EXPECT_TRUE(run_lesson({own}).out.starts_with("Glass\n"));
    EXPECT_EQ(run_lesson({own, "-o", start}).status, 0);
    const std::string right = "tests/lessons/shininess/right-1.gl", twice = folder / "twice.gl";
    EXPECT_EQ(run_lesson({own, "--check", right}).out, right + "  right\n");
    write_file_atomically(twice, read_file(right) + "glMaterialf(GL_FRONT, GL_SHININESS, 1);\n");
    EXPECT_EQ(run_lesson({own, "--check", twice}).out, twice + "  wrong  own: glMaterialf is called 2 times.\n");
    write_file_atomically(own, text + "- `bad` (`blu() is 1`): no\n");
    const ProgramResult bad = run_lesson({own});
    EXPECT_EQ(bad.status, 2);
    EXPECT_NE(bad.err.find("glass.md:"), std::string::npos) << bad.err;
    EXPECT_NE(bad.err.find("there is no measure 'blu'; did you mean 'blue'?"), std::string::npos) << bad.err;
    EXPECT_EQ(run_lesson({folder / "none.md"}).status, 2);
}

// Thirty answers, two of them unreadable, and one missing.
class LessonClass : public testing::Test {
  protected:
    LessonClass() {
        for (int student = 0; student < 10; ++student) {
            const std::string name = folder / ("student-" + std::to_string(student));
            std::filesystem::create_directory(name);
            for (const std::string lesson : {"shininess", "overlay", "two-sides"}) {
                const std::string answer =
                    (student % 2 == 0 ? "right-" : "wrong-") + std::to_string(student % 3 + 1) + ".gl";
                std::filesystem::copy_file("tests/lessons/" + lesson + "/" + answer, name + "/" + lesson + ".gl");
            }
        }
        write_file_atomically(folder / "student-0/shininess.gl", "this is no scene\n");
        std::filesystem::remove(folder / "student-2/overlay.gl");
        std::filesystem::create_directory(folder / "student-2/overlay.gl");  // cannot be read
        std::filesystem::remove(folder / "student-4/overlay.gl");
        write_file_atomically(folder / "student-4/notes.gl", "");
    }
    const TemporaryFolder folder;
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

TEST_F(LessonClass, HasARowForEachAnswer) {
    const TemporaryFolder results;
    const std::string csv = results / "marks.csv", page = results / "marks";
    const ProgramResult result = run_lesson({"--check", folder.str(), "--csv", csv, "-o", page});
    EXPECT_EQ(result.status, 2);  // two cannot be read
    EXPECT_EQ(result.err, "twinlight: note: " + folder.str() +
                              "/student-4/notes.gl: not graded; no lesson here is named 'notes'\n");
    const std::vector<std::string> rows = lines_of(read_file(csv));
    ASSERT_EQ(rows.size(), 31U);
    EXPECT_EQ(rows[0], "student,lesson,points,of,result,reasons");
    EXPECT_EQ(rows[1],
              "student-0,shininess,0,1,not read,line 1: unknown command 'this'; docs/scene-language.md lists the known "
              "commands");
    EXPECT_EQ(rows[2], "student-0,two-sides,3,3,right,");
    EXPECT_EQ(rows[3], "student-0,overlay,1,1,right,");
    EXPECT_EQ(rows[15], "student-4,overlay,0,1,missing,");
    const auto count = [&](const std::string& result_of_row) {
        return std::ranges::count_if(
            rows, [&](const std::string& row) { return row.find("," + result_of_row + ",") != std::string::npos; });
    };
    EXPECT_EQ(count("not read"), 2);
    EXPECT_EQ(count("missing"), 1);
    EXPECT_EQ(count("right"), 12);
    EXPECT_EQ(count("wrong"), 15);
    EXPECT_TRUE(result.out.ends_with("\n12 right, 15 wrong, 2 not read, 1 missing\n")) << result.out;
    EXPECT_EQ(run_lesson({"--check", folder.str(), "--csv", "-"}).out, read_file(csv));
    // The page has a picture of each answer that could be read, its difference, and the start of each lesson.
    const std::string html = read_file(page + "/index.html");
    std::size_t pictures = 0;
    for (std::size_t at = 0; (at = html.find("<img ", at)) != std::string::npos; ++at) ++pictures;
    EXPECT_GE(pictures, 2U * 22 + 3);
    EXPECT_LE(pictures, 2U * 27 + 3);
}

TEST_F(LessonClass, IsGradedInOneLessonOrInOnesOwn) {
    const json shininess = json::parse(run_lesson({"shininess", "--json", "--check", folder.str()}).out);
    ASSERT_EQ(shininess["answers"].size(), 10U);
    EXPECT_EQ(shininess["answers"][2]["result"], "right");
    EXPECT_EQ(shininess["answers"][2]["points"], 1);
    EXPECT_EQ(shininess["answers"][1]["result"], "wrong");
    // The folder's own lesson.
    std::string text(lesson::text_of_lesson("shininess", lesson::Language::kEnglish));
    write_file_atomically(folder / "notes.md", text);
    std::filesystem::copy_file("tests/lessons/shininess/right-1.gl", folder / "student-4/notes.gl",
                               std::filesystem::copy_options::overwrite_existing);
    const json all = json::parse(run_lesson({"--json", "--check", folder.str()}).out);
    ASSERT_EQ(all["answers"].size(), 40U);
    EXPECT_EQ(all["answers"][0]["lesson"], "notes");
    EXPECT_EQ(all["answers"][0]["result"], "missing");
    EXPECT_EQ(all["answers"][16]["lesson"], "notes");
    EXPECT_EQ(all["answers"][16]["result"], "right");
}

// A right answer in C++, which no reader of ours takes.
TEST(LessonClassCommand, RunsProgramsInCpp) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "ann");
    write_file_atomically(folder / "ann/shininess.cpp", R"(
#include <GL/glut.h>
#include <vector>
static void display() {
    glClearColor(0.35, 0.42, 0.5, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION); glLoadIdentity();
    gluPerspective(40, 4.0 / 3.0, 1, 50);
    glMatrixMode(GL_MODELVIEW); glLoadIdentity();
    gluLookAt(0, 0, 6,  0, 0, 0,  0, 1, 0);
    
    { const GLfloat v[] = {1, 1, 2, 0}; glLightfv(GL_LIGHT0, GL_POSITION, v); };
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    
    { const GLfloat v[] = {0.6, 0.1, 0.1, 1}; glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, v); };
    { const GLfloat v[] = {0.7, 0.7, 0.7, 1}; glMaterialfv(GL_FRONT, GL_SPECULAR, v); };
    glMaterialf(GL_FRONT, GL_SHININESS, 64);
    glutSolidSphere(1.8, 160, 80);
    
    glutSwapBuffers();
}
int main(int argc, char** argv) {
    std::vector<int> nothing;
    glutInit(&argc, argv); glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH); glutInitWindowSize(640, 480);
    glutCreateWindow("a"); glutDisplayFunc(display); glutMainLoop();
}
)");
    const ProgramResult read = run_lesson({"--check", folder.str()});
    EXPECT_EQ(read.status, 2);
    EXPECT_TRUE(read.out.starts_with(
        "ann  shininess  0/1  not read  it is C++; run it: twinlight lesson --check FOLDER --run\n"))
        << read.out;
    const ProgramResult run = run_lesson({"--check", folder.str(), "--run"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(run.out.starts_with("ann  shininess  1/1  right\n")) << run.out;
    EXPECT_NE(run.err.find("compiles and runs the programs of"), std::string::npos) << run.err;
}

TEST(LessonClassCommand, RefusesAFolderWithoutAnswers) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_lesson({"--check", folder.str()}).err,
              "twinlight: " + folder.str() +
                  ": this folder has no student folders; answers must be FOLDER/STUDENT/LESSON.gl\n");
    std::filesystem::create_directory(folder / "ann");
    EXPECT_EQ(run_lesson({"--check", folder.str()}).err,
              "twinlight: " + folder.str() +
                  ": no file in it is named after a lesson; 'twinlight lesson' lists the lessons\n");
    EXPECT_EQ(run_lesson({"shininess", "--check", folder.str(), "-o", folder / "page"}).err,
              "twinlight: -o " + folder.str() + "/page: this is among the answers; choose a folder beside them\n");
    EXPECT_EQ(run_lesson({"shininess", "--csv", "a.csv"}).err, "twinlight: --csv needs --check FOLDER\n");
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
