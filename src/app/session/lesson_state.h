// The lesson that the window shows: what the student has predicted, and the last check of the answer. The answer is the
// session's commands.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "judge/lesson/lesson.h"

namespace twinlight::session {

struct Session;

struct LessonState {
    lesson::Lesson page;
    std::shared_ptr<const CommandList> start, changed;  // Lesson::scene and Lesson::changed
    std::shared_ptr<const CommandList> own{};           // the student's scene, while the change is shown
    std::optional<std::size_t> predicted{};             // the first choice; later ones do not count
    std::optional<lesson::Grade> grade{};               // of the commands of the history's revision `graded`
    int graded = -1;
};

// Opens the lesson's scene, drawn by the fixed function, and the tab Lesson.
void start_lesson(Session& session, const lesson::Lesson& page);
// Leaves the lesson. The scene stays.
void leave_lesson(Session& session);
// Remembers the first prediction.
void predict(Session& session, std::size_t choice);
// Whether the commands are those of the change that the prediction is about; and an edit that shows them, or the student's own scene
// again.
bool shows_change(const Session& session);
void show_change(Session& session, bool is_shown);
// The student's own scene, which a check grades: the change is hidden first if it is shown.
std::shared_ptr<const CommandList> answer_of(Session& session);
// Remembers the grade of these commands' revision. Right: the lesson has its tick.
void take_grade(Session& session, lesson::Grade grade, int revision);
bool is_solved(const Session& session, std::string_view lesson);
// Why a right answer is right: the lesson's explanation.
std::string because_of(const lesson::Lesson& page);
// Whether the commands have changed since they were checked.
bool is_outdated(const Session& session);
// The lesson after this one; empty after the last.
std::string next_lesson(const LessonState& state);

// What the panel says, in the lesson's language.
struct LessonWords {
    const char *lessons, *prediction, *task, *how, *check, *right, *not_yet, *outdated, *show_change, *show_start,
        *again, *next, *all, *checking, *minutes;
};
const LessonWords& words_of(lesson::Language language);
// All of them, for loading their letters.
std::vector<const char*> all_words(lesson::Language language);
// Whether the prediction was right: a sentence. Empty before there is one.
std::string verdict_on_prediction(const LessonState& state);
// Markdown as plain paragraphs: one line each, without backquotes.
std::string plain_text(const std::string& markdown);

}  // namespace twinlight::session
