// A lesson in the window: its scene, the prediction, the change and the answer's check, without the window.
#include <gtest/gtest.h>

#include "app/session/keys.h"
#include "app/session/lesson_state.h"
#include "app/session/session.h"
#include "scene/command/text.h"

namespace twinlight::session::session_lesson_test {
namespace {

using lesson::Language;

Session session_with_lesson(const char* name, Language language = Language::kEnglish) {
    Session session(std::make_shared<const CommandList>(read_scene("glutSolidCube(1);", "s.gl", "s.gl")));
    start_lesson(session, lesson::load_lesson(name, language));
    return session;
}

TEST(SessionLesson, OpensItsSceneAndItsTab) {
    const Session session = session_with_lesson("shininess");
    EXPECT_EQ(commands(session).commands, session.lesson->start->commands);
    EXPECT_EQ(commands(session).name, "shininess");
    EXPECT_EQ(session.panel, Panel::kLesson);
    EXPECT_EQ(session.view, View::kSingle);
    EXPECT_EQ(active_pane(session).renderer, Path::kFixed);
    EXPECT_FALSE(session.history.can_undo());
    EXPECT_FALSE(session.file);
}

TEST(SessionLesson, CountsTheFirstPrediction) {
    Session session = session_with_lesson("shininess");
    EXPECT_EQ(verdict_on_prediction(*session.lesson), "");
    predict(session, 7);
    EXPECT_FALSE(session.lesson->predicted);
    predict(session, 0);
    predict(session, 1);
    EXPECT_EQ(session.lesson->predicted, 0U);
    EXPECT_EQ(verdict_on_prediction(*session.lesson), "A is wrong; B is right.");
    Session chinese = session_with_lesson("shininess", Language::kChinese);
    predict(chinese, 1);
    EXPECT_EQ(verdict_on_prediction(*chinese.lesson), "B 正确。");
}

TEST(SessionLesson, ShowsTheChangeAsAnEdit) {
    Session session = session_with_lesson("scaled-normals");
    press(session, 'x');
    const auto own = commands(session).commands;
    EXPECT_FALSE(shows_change(session));
    show_change(session, true);
    EXPECT_TRUE(shows_change(session));
    EXPECT_NE(commands(session).commands, own);
    show_change(session, false);
    EXPECT_EQ(commands(session).commands, own);
    session.history.undo();
    session.history.undo();
    EXPECT_EQ(commands(session).commands, own);
}

// The change of this lesson moves the camera, which is no answer to the task.
TEST(SessionLesson, AnAnswerIsNeverTheChangeThatIsShown) {
    Session session = session_with_lesson("light-and-camera");
    const lesson::Grader grader(session.lesson->page);
    const lesson::Grade own = grader.grade(answer_of(session));
    show_change(session, true);
    EXPECT_NE(grader.grade(session.history.now()).reason, own.reason);
    EXPECT_EQ(grader.grade(answer_of(session)).reason, own.reason);
    EXPECT_FALSE(shows_change(session));
}

TEST(SessionLesson, ARightAnswerGivesATickAndAReason) {
    Session session = session_with_lesson("scaled-normals");
    take_grade(session, {false, "normals", "no"}, 0);
    EXPECT_FALSE(is_solved(session, "scaled-normals"));
    take_grade(session, {true}, 0);
    take_grade(session, {true}, 0);
    EXPECT_TRUE(is_solved(session, "scaled-normals"));
    EXPECT_EQ(session.solved_lessons.size(), 1u);
    for (const Language language : {Language::kEnglish, Language::kChinese}) {
        for (const std::string_view name : lesson::names()) {
            const std::string because = because_of(lesson::load_lesson(name, language));
            EXPECT_GT(because.size(), 20u) << name;
            EXPECT_EQ(because.find(language == Language::kEnglish ? "minutes" : "分钟"), std::string::npos) << because;
        }
    }
}

// What the window checks is what `twinlight lesson --check` checks: the key x turns GL_NORMALIZE on.
TEST(SessionLesson, ChecksTheCommandsOfTheWindow) {
    Session session = session_with_lesson("scaled-normals");
    const lesson::Grader grader(session.lesson->page);
    EXPECT_FALSE(grader.grade(session.history.now()).is_right);
    press(session, 'x');
    session.lesson->grade = grader.grade(session.history.now());
    session.lesson->graded = session.history.revision();
    EXPECT_TRUE(session.lesson->grade->is_right) << session.lesson->grade->reason;
    EXPECT_FALSE(is_outdated(session));
    press(session, 'l');
    EXPECT_TRUE(is_outdated(session));
    EXPECT_FALSE(grader.grade(session.history.now()).is_right);
}

TEST(SessionLesson, GoesOnToTheNextUntilTheLast) {
    std::size_t count = 1;
    lesson::Lesson page = lesson::load_lesson(lesson::names().front(), Language::kEnglish);
    for (std::string next; !(next = next_lesson({page, nullptr, nullptr})).empty(); ++count) {
        ASSERT_EQ(next, lesson::names()[count]);
        page = lesson::load_lesson(next, Language::kEnglish);
    }
    EXPECT_EQ(count, lesson::names().size());
}

TEST(SessionLesson, JoinsTheLinesOfParagraphs) {
    EXPECT_EQ(plain_text("One `glEnable`\nline.\n\nTwo."), "One glEnable line.\n\nTwo.");
    EXPECT_EQ(plain_text("光源\n位置。"), "光源位置。");
    EXPECT_EQ(plain_text(""), "");
}

}  // namespace
}  // namespace twinlight::session::session_lesson_test
