// The language of the window. English texts are where they are used, in tr(...); chinese.def has their translations.
#pragma once

#include <span>
#include <string>

#include "base/text/translation.h"
#include "judge/lesson/lesson.h"
#include "scene/scenes/caption.h"

namespace twinlight::session {

// To be called once, before the window opens. Until then it is English.
void set_language(lesson::Language language);
lesson::Language language();
// The rows of chinese.def.
std::span<const Translation> chinese();

// A built-in scene's caption in the window's language. Other scenes keep theirs.
Caption translated(Caption caption);
// The beginning of a title or a notice, for a place that is too narrow for all of it; in either language.
std::string before_colon(const std::string& title);
std::string first_sentence(const std::string& text);

}  // namespace twinlight::session
