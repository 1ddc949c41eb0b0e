#include "app/session/lesson_state.h"

#include <algorithm>
#include <utility>

#include "app/session/session.h"
#include "base/text/input_text.h"
#include "base/text/translation.h"

namespace twinlight::session {
namespace {

constexpr LessonWords kEnglishWords = {
    "Each lesson takes about ten minutes: a question, a prediction, and a task that the program checks.",
    "Prediction",
    "Task",
    "Change the scene in the tabs Commands and Lights, or by keys.",
    "Check my answer",
    "Right, because:",
    "Not yet.",
    "The scene has changed since this check.",
    "Show the change",
    "Back to my scene",
    "Start again",
    "Next lesson",
    "All lessons",
    "Checking ...",
    " About ten minutes.",
};
constexpr LessonWords kChineseWords = {
    "每个练习大约十分钟：一个问题、一次预测，以及一个由程序检查的任务。",
    "预测",
    "任务",
    "在“命令”和“光源”标签里改场景，或者用按键。",
    "检查答案",
    "正确，因为：",
    "还不对。",
    "检查之后场景又改过了。",
    "显示这个改动",
    "回到我的场景",
    "重新开始",
    "下一个练习",
    "所有练习",
    "正在检查……",
    "大约十分钟。",
};

// Chinese has no blanks between words.
bool needs_blank(const std::string& before, const std::string& after) {
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 128; };
    return !before.empty() && (is_ascii(before.back()) || is_ascii(after.front()));
}

}  // namespace

void start_lesson(Session& session, const lesson::Lesson& page) {
    LessonState state{page, lesson::commands_of(page, page.scene), lesson::commands_of(page, page.changed)};
    open(session, state.start, std::nullopt);
    session.lesson = std::make_shared<LessonState>(std::move(state));
    session.panel = Panel::kLesson;
    // GL's own picture: shaders that light every pixel do not show some of the mistakes.
    session.view = View::kSingle;
    session.panes[0] = Pane{Path::kFixed};
    session.active = 0;
}

void leave_lesson(Session& session) { session.lesson.reset(); }

void predict(Session& session, std::size_t choice) {
    LessonState& state = *session.lesson;
    if (!state.predicted && choice < state.page.choices.size()) state.predicted = choice;
}

bool shows_change(const Session& session) { return commands(session).commands == session.lesson->changed->commands; }

void show_change(Session& session, bool is_shown) {
    LessonState& state = *session.lesson;
    if (is_shown) state.own = session.history.now();
    edit(session, is_shown ? *state.changed : *(state.own ? state.own : state.start),
         tr(is_shown ? "the lesson's change" : "your own scene"));
    say(session, tr(is_shown ? "this is the change that you predicted" : "this is your own scene again"));
}

std::shared_ptr<const CommandList> answer_of(Session& session) {
    if (session.lesson->own && shows_change(session)) show_change(session, false);
    return session.history.now();
}

void take_grade(Session& session, lesson::Grade grade, int revision) {
    LessonState& state = *session.lesson;
    if (grade.is_right && !is_solved(session, state.page.name)) session.solved_lessons.push_back(state.page.name);
    state.grade = std::move(grade);
    state.graded = revision;
}

bool is_solved(const Session& session, std::string_view lesson) {
    return std::ranges::find(session.solved_lessons, lesson) != session.solved_lessons.end();
}

std::string because_of(const lesson::Lesson& page) {
    std::string text = plain_text(page.about);
    const std::string_view minutes = words_of(page.language).minutes;
    if (text.ends_with(minutes)) text.resize(text.size() - minutes.size());
    return text;
}

bool is_outdated(const Session& session) { return session.lesson->graded != session.history.revision(); }

std::string next_lesson(const LessonState& state) {
    const auto names = lesson::names();
    const auto now = std::ranges::find(names, state.page.name);
    return now == names.end() || now + 1 == names.end() ? "" : std::string(*(now + 1));
}

const LessonWords& words_of(lesson::Language language) {
    return language == lesson::Language::kChinese ? kChineseWords : kEnglishWords;
}

std::vector<const char*> all_words(lesson::Language language) {
    const LessonWords& w = words_of(language);
    const lesson::PredictionWords& verdicts = lesson::prediction_words(language);
    return {w.lessons, w.prediction, w.task,        w.how,          w.check,       w.right,
            w.not_yet, w.outdated,   w.show_change, w.show_start,   w.again,       w.next,
            w.all,     w.checking,   w.minutes,     verdicts.right, verdicts.wrong};
}

std::string verdict_on_prediction(const LessonState& state) {
    return state.predicted ? lesson::verdict_on_prediction(state.page, *state.predicted) : "";
}

std::string plain_text(const std::string& markdown) {
    std::string text, paragraph;
    InputText lines(markdown + "\n\n");
    for (std::string line; std::getline(lines, line);) {
        std::erase(line, '`');
        if (line.empty()) {
            if (!paragraph.empty()) text += (text.empty() ? "" : "\n\n") + paragraph;
            paragraph.clear();
        } else {
            paragraph += (needs_blank(paragraph, line) ? " " : "") + line;
        }
    }
    return text;
}

}  // namespace twinlight::session
