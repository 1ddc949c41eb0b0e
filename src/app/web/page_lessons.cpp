#include "app/web/page_lessons.h"

#include <memory>

#include "app/session/lesson_state.h"
#include "app/web/page_scene.h"
#include "base/text/json.h"
#include "scene/command/text.h"

namespace twinlight::web {

namespace {

Json json_of(const lesson::Lesson& lesson) {
    Json verdicts = Json::array();
    for (std::size_t i = 0; i < lesson.choices.size(); ++i)
        verdicts.push_back(lesson::verdict_on_prediction(lesson, i));
    return {{"name", lesson.name},
            {"title", lesson.title},
            {"about", lesson.about},
            {"question", lesson.question},
            {"scene", lesson.scene},
            {"changed", lesson.changed},
            {"prediction", lesson.prediction},
            {"choices", lesson.choices},
            {"verdicts", verdicts},
            {"seen", lesson.seen},
            {"task", lesson.task},
            {"because", session::because_of(lesson)}};
}

lesson::Lesson lesson_of_text(const std::string& name, lesson::Language language, std::string_view text) {
    lesson::Lesson lesson = lesson::read_lesson(text, name);
    lesson.language = language;
    return lesson;
}

}  // namespace

std::string page_lessons(lesson::Language language) {
    const session::LessonWords& words = session::words_of(language);
    Json list = Json::array();
    for (const std::string_view name : lesson::names()) list.push_back(json_of(lesson::load_lesson(name, language)));
    return dumped({{"words",
                    {{"prediction", words.prediction},
                     {"task", words.task},
                     {"check", words.check},
                     {"right", words.right},
                     {"notYet", words.not_yet},
                     {"outdated", words.outdated},
                     {"showChange", words.show_change},
                     {"showStart", words.show_start},
                     {"next", words.next},
                     {"checking", words.checking}}},
                   {"lessons", list}});
}

std::string own_lesson(const std::string& name, lesson::Language language, std::string_view text) {
    return dumped(json_of(lesson_of_text(name, language, text)));
}

std::string checked_answer(const std::string& name, lesson::Language language, std::string_view answer,
                           std::string_view own_text) {
    const lesson::Lesson lesson =
        own_text.empty() ? lesson::load_lesson(name, language) : lesson_of_text(name, language, own_text);
    lesson::Grade grade;
    try {
        grade = lesson::Grader(lesson).grade(std::make_shared<const CommandList>(read_for_page(answer, name, "")));
    } catch (const SceneError& error) {
        grade.reason = error.what();
    }
    return dumped({{"right", grade.is_right},
                   {"check", grade.check.empty() ? Json(nullptr) : Json(grade.check)},
                   {"reason", grade.reason}});
}

}  // namespace twinlight::web
