#include "app/web/page_lessons.h"

#include <memory>

#include "app/session/lesson_state.h"
#include "app/web/page_scene.h"
#include "base/text/json.h"
#include "scene/command/text.h"

namespace twinlight::web {

std::string page_lessons(lesson::Language language) {
    const session::LessonWords& words = session::words_of(language);
    Json list = Json::array();
    for (const std::string_view name : lesson::names()) {
        const lesson::Lesson lesson = lesson::load_lesson(name, language);
        Json verdicts = Json::array();
        for (std::size_t i = 0; i < lesson.choices.size(); ++i)
            verdicts.push_back(lesson::verdict_on_prediction(lesson, i));
        list.push_back({{"name", lesson.name},
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
                        {"because", session::because_of(lesson)}});
    }
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

std::string checked_answer(const std::string& name, lesson::Language language, std::string_view answer) {
    const lesson::Lesson lesson = lesson::load_lesson(name, language);
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
