// Lessons: a question, a prediction, a task, and checks that grade a student's scene.
//
// The text of a lesson is docs/lessons/NAME.md (docs/zh-CN/lessons/NAME.md in Chinese), embedded in the program. Its checks
// are rows in lessons.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/image/embedded.h"
#include "judge/lesson/work.h"

namespace twinlight {

// The files of docs/lessons and of docs/zh-CN/lessons.
extern const std::vector<EmbeddedFile> kLessonFiles, kChineseLessonFiles;

}  // namespace twinlight

namespace twinlight::lesson {

enum class Language : std::uint8_t { kEnglish, kChinese };
// "en" or "zh"; nullopt for other names.
std::optional<Language> find_language(std::string_view name);
// By the environment: LC_ALL, LC_MESSAGES or LANG.
Language users_language();

// The text of a lesson: Markdown, without pictures.
struct Lesson {
    Language language = Language::kEnglish;
    std::string name, title, about;
    std::string question;
    std::string scene;  // to start from
    std::string prediction;
    std::vector<std::string> choices;  // A, B, C, ...
    std::size_t right_choice = 0;
    std::string seen;     // what the change shows, and why
    std::string changed;  // the scene with the change that the prediction is about
    std::string task;
    std::vector<std::pair<std::string, std::string>> reasons;  // a check's key, and what is wrong where it fails
};

// The names, in the order of teaching.
std::span<const std::string_view> names();
// Throws std::runtime_error with the line where a page breaks the format, and std::out_of_range for an unknown name.
Lesson read_lesson(std::string_view text, std::string_view name);
Lesson load_lesson(std::string_view name, Language language);

// "A" for 0.
std::string letter_of(std::size_t choice);
// The sentences about a prediction that is right ({}: its letter) and one that is wrong ({}: its letter, and the right one).
struct PredictionWords {
    const char *right, *wrong;
};
const PredictionWords& prediction_words(Language language);
// One of them, in the lesson's language.
std::string verdict_on_prediction(const Lesson& lesson, std::size_t choice);

// One rule that a right answer keeps: the measure lies from `low` to `high`.
struct Check {
    std::string_view key;  // as in the page's list "Checks"
    Measure measure;
    double low, high;
};
std::span<const Check> checks_of(std::string_view name);

struct Grade {
    bool is_right = false;
    std::string check{};   // the key of the first check that fails; empty if the scene cannot be read
    std::string reason{};  // a sentence
};

// Grades answers to one lesson.
class Grader {
  public:
    explicit Grader(const Lesson& lesson);
    // A scene that GL refuses is a wrong answer, with GL's error as the reason.
    Grade grade(std::shared_ptr<const CommandList> answer) const;

  private:
    Lesson lesson_;
    Work start_;
};

// The commands of a lesson's scene. `text` is Lesson::scene or Lesson::changed.
std::shared_ptr<const CommandList> commands_of(const Lesson& lesson, const std::string& text);

}  // namespace twinlight::lesson
