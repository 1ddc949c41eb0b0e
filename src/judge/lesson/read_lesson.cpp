// Reads a lesson's page. Its headings may be in any language; their order counts:
//
//     # Title
//     About it.
//     ## Question       text, and the scene to start from in ```c
//     ## Prediction     text, and the choices: "- A. ..."
//     ## What you see   "**B.**", the letter of the right choice, and text; the change in ```diff
//     ## Task           text
//     ## Checks         "- `key` (`condition`): reason", a line each; see condition.h
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/text/input_text.h"
#include "judge/lesson/lesson.h"

namespace twinlight::lesson {

namespace {

enum Section : std::size_t { kAbout, kQuestion, kPrediction, kSeen, kTask, kChecks, kSections };

struct Reader {
    std::string_view name;
    int line = 0;
    std::array<std::string, kSections> texts{};
    std::string diff{};

    [[noreturn]] void refuse(const std::string& why) const {
        throw std::runtime_error(fmt::format("{}.md:{}: {}", name, line, why));
    }
};

// The scene with the lines of a diff: each "-" line is replaced by the "+" lines after it. A "+" line without one follows the
// last line that was named, with "-" or with a space.
std::string changed(const Reader& reader, const std::string& scene, const std::string& diff) {
    std::string text = scene;
    std::size_t at = 0;
    InputText lines(diff);
    for (std::string line; std::getline(lines, line);) {
        const std::string rest = line.substr(1) + "\n";
        if (line[0] == '+') {
            text.insert(at, rest);
            at += rest.size();
            continue;
        }
        std::size_t found = text.find(rest, at);
        while (found != std::string::npos && found > 0 && text[found - 1] != '\n') found = text.find(rest, found + 1);
        if (found == std::string::npos) reader.refuse("the scene has no line '" + line.substr(1) + "'");
        if (line[0] == '-') text.erase(found, rest.size());
        at = line[0] == '-' ? found : found + rest.size();
    }
    return text;
}

// "- `key` (`condition`): reason", or of a translation "- `key`: reason".
Check check_of(const std::string& line, const Reader& reader, const std::string& folder, const Lesson* original) {
    Check check;
    const std::size_t end = line.find('`', 3);
    if (end == std::string::npos) reader.refuse("the check's key must end with '`'");
    check.key = line.substr(3, end - 3);
    std::size_t rest = end + 1;
    if (original) {
        const auto same = std::ranges::find(original->checks, check.key, &Check::key);
        if (same == original->checks.end()) reader.refuse(fmt::format("the original has no check '{}'", check.key));
        check.condition = same->condition;
    } else {
        const std::size_t start = line.find(" (`", end), last = line.find("`)", end);
        if (start != end + 1 || last == std::string::npos || last < start + 3)
            reader.refuse("a check must be '- `key` (`condition`): reason'");
        try {
            check.condition = read_condition(std::string_view(line).substr(start + 3, last - start - 3), folder);
        } catch (const std::runtime_error& error) {  // FileError, too
            reader.refuse(error.what());
        }
        rest = last + 2;
    }
    const std::size_t blank = line.find(' ', rest);
    if (blank == std::string::npos) reader.refuse("the check has no reason after ':'");
    check.reason = line.substr(blank + 1);
    return check;
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of('\n'), last = text.find_last_not_of('\n');
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

}  // namespace

Lesson read_lesson(std::string_view text, std::string_view name, const std::string& folder, const Lesson* original) {
    Lesson lesson;
    lesson.name = name;
    lesson.folder = folder;
    Reader reader{.name = name};
    std::size_t section = kAbout;
    std::string* block = nullptr;
    InputText lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        ++reader.line;
        if (block) {
            if (line == "```")
                block = nullptr;
            else
                *block += line + "\n";
        } else if (line == "```c" || line == "```diff") {
            block = line == "```c" ? &lesson.scene : &reader.diff;
            if (!block->empty()) reader.refuse("a lesson has one scene and one change");
        } else if (line.starts_with("# ")) {
            lesson.title = line.substr(2);
        } else if (line.starts_with("## ")) {
            if (++section == kSections) reader.refuse("a lesson has five headings");
        } else if (line.starts_with("- ") && section == kPrediction) {
            const char letter = static_cast<char>('A' + lesson.choices.size());
            if (line.size() < 6 || line[2] != letter || line[3] != '.')
                reader.refuse(fmt::format("the next choice must start with '- {}. '", letter));
            lesson.choices.push_back(line.substr(5));
        } else if (line.starts_with("- `") && section == kChecks) {
            lesson.checks.push_back(check_of(line, reader, folder, original));
        } else if (!line.starts_with("![")) {
            reader.texts.at(section) += line + "\n";
        }
    }
    for (std::string& part : reader.texts) part = trimmed(part);
    lesson.about = reader.texts[kAbout];
    lesson.question = reader.texts[kQuestion];
    lesson.prediction = reader.texts[kPrediction];
    lesson.task = reader.texts[kTask];
    std::string& seen = reader.texts[kSeen];
    if (section != kChecks) reader.refuse("a lesson has five headings");
    if (lesson.scene.empty() || reader.diff.empty()) reader.refuse("a lesson needs a scene and a change");
    if (lesson.checks.empty()) reader.refuse("a lesson needs a check: '- `key` (`condition`): reason'");
    if (original && lesson.checks.size() != original->checks.size()) reader.refuse("the original has other checks");
    if (seen.size() < 7 || !seen.starts_with("**") || seen.compare(3, 4, ".** ") != 0)
        reader.refuse("what is seen must start with the right choice, such as '**B.** '");
    lesson.right_choice = static_cast<std::size_t>(seen[2] - 'A');
    if (lesson.right_choice >= lesson.choices.size()) reader.refuse("the right choice is not in the list");
    lesson.seen = seen.substr(7);
    lesson.changed = changed(reader, lesson.scene, reader.diff);
    return lesson;
}

}  // namespace twinlight::lesson
