// The lessons in the page: what `twinlight lesson` prints.
#pragma once

#include <string>
#include <string_view>

#include "judge/lesson/lesson.h"

namespace twinlight::web {

// JSON: {"words": {...}, "lessons": [{"name", "title", "about", "question", "scene", "changed", "prediction", "choices": [...], "verdicts": [...],
// "seen", "task", "because"}]}, in the order of teaching. words: app/session's for the panel of lessons; verdicts: a sentence for each choice.
std::string page_lessons(lesson::Language language);

// JSON: one of these, of a lesson that somebody wrote: the text of a file NAME.md. Throws std::runtime_error with the line that breaks
// the format.
std::string own_lesson(const std::string& name, lesson::Language language, std::string_view text);

// JSON: {"right", "check", "reason"}, as `twinlight lesson NAME --check FILE --json` prints them. `own_text`: of own_lesson(); empty for
// one of ours.
std::string checked_answer(const std::string& name, lesson::Language language, std::string_view answer,
                           std::string_view own_text = {});

}  // namespace twinlight::web
