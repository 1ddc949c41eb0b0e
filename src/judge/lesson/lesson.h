// Lessons: a question, a prediction, a task, and checks that grade a student's scene.
//
// A lesson is a Markdown file. Ours are docs/lessons/NAME.md (docs/zh-CN/lessons/NAME.md in Chinese), embedded in the program;
// a teacher may write others.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/embedded.h"
#include "judge/lesson/condition.h"
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

// One rule that a right answer keeps.
struct Check {
    std::string key;
    Condition condition;
    std::string reason;  // what is wrong where it fails; {value} is the measure's
};

// The text of a lesson: Markdown, without pictures.
struct Lesson {
    Language language = Language::kEnglish;
    std::string name, title, about;
    std::string folder;  // of its file; empty for ours
    std::string question;
    std::string scene;  // to start from
    std::string prediction;
    std::vector<std::string> choices;  // A, B, C, ...
    std::size_t right_choice = 0;
    std::string seen;     // what the change shows, and why
    std::string changed;  // the scene with the change that the prediction is about
    std::string task;
    std::vector<Check> checks;
};

// The names, in the order of teaching.
std::span<const std::string_view> names();
// Throws std::runtime_error with the line where a page breaks the format. `folder`: that of the page, for pictures that its
// checks name. Of a translation, `original` has the conditions: its checks have only keys and reasons.
Lesson read_lesson(std::string_view text, std::string_view name, const std::string& folder = {},
                   const Lesson* original = nullptr);
// Throw std::out_of_range for an unknown name.
Lesson load_lesson(std::string_view name, Language language);
std::string_view text_of_lesson(std::string_view name, Language language);

// "A" for 0.
std::string letter_of(std::size_t choice);
// The sentences about a prediction that is right ({}: its letter) and one that is wrong ({}: its letter, and the right one).
struct PredictionWords {
    const char *right, *wrong;
};
const PredictionWords& prediction_words(Language language);
// One of them, in the lesson's language.
std::string verdict_on_prediction(const Lesson& lesson, std::size_t choice);

struct Grade {
    bool is_right = false;
    std::string check{};   // the key of the first check that fails; empty if the scene cannot be read
    std::string reason{};  // a sentence
};

// What each check says of an answer, and its marks: a point for each check that the scene to start from fails and the answer
// passes. A check that the scene to start from passes is a condition; a point is lost where the answer fails it.
struct Marks {
    struct Result {
        std::string key{};
        bool is_passed = false;
        std::string reason{};  // empty where it is passed
    };
    int points = 0, most = 0;
    std::vector<Result> results{};
};

// Grades answers to one lesson.
class Grader {
  public:
    explicit Grader(const Lesson& lesson);
    // A scene that GL refuses is a wrong answer, with GL's error as the reason.
    Grade grade(std::shared_ptr<const CommandList> answer) const;
    // `answer` is one to start().
    Marks marks(const Work& answer) const;
    int most_points() const;
    const Work& start() const { return start_; }

  private:
    Marks::Result result(const Check& check, const Work& work) const;
    const std::vector<bool>& passed_at_start() const;  // of each check

    Lesson lesson_;
    Work start_;
    mutable std::vector<bool> passed_at_start_;  // empty until it is needed
};

// The commands of a lesson's scene. `text` is Lesson::scene or Lesson::changed.
std::shared_ptr<const CommandList> commands_of(const Lesson& lesson, const std::string& text);

}  // namespace twinlight::lesson
