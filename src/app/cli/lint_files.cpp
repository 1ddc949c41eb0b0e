#include "app/cli/lint_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "app/cli/csv.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/run_program.h"
#include "app/program.h"
#include "app/streams.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "base/text/reason.h"
#include "scene/command/cpp_words.h"
#include "scene/command/text.h"
#include "scene/record/compile.h"

namespace twinlight::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostText = 4u << 20;  // of a source that is looked at

// Of a file in a folder. A source without main() is a part of another program, unless it is a scene.
bool counts(const std::string& file, Programs programs) {
    const bool is_run = programs == Programs::kAreRun;
    if (!is_run && (extension_of(file) == ".gl" || extension_of(file) == ".trace")) return true;
    if (trace::is_python(file)) return read_file(file, kMostText).find("OpenGL") != std::string::npos;
    if (!trace::is_source(file)) return false;
    const std::string text = read_file(file, kMostText);
    const bool may_be_scene = !is_run && !has_cpp_name(file) && text.find("#include") == std::string::npos;
    return may_be_scene || trace::has_main(text);
}

std::vector<std::string> files_of_folder(const std::string& folder, Programs programs) {
    std::vector<std::string> files;
    std::error_code error;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
    if (error) throw FileError(fmt::format("{}: {}", folder, error.message()));
    for (; at != end; at.increment(error)) {
        if (error) throw FileError(fmt::format("{}: {}", folder, error.message()));
        if (at->path().filename().string().starts_with('.')) {
            at.disable_recursion_pending();
            continue;
        }
        if (!at->is_regular_file(error)) continue;
        const std::string file = at->path().string();
        try {
            if (counts(file, programs)) files.push_back(file);
        } catch (const FileError&) {
            files.push_back(file);  // its line says why it cannot be read
        }
    }
    std::ranges::sort(files);
    return files;
}

bool is_program(const std::string& file) { return trace::is_source(file) || trace::is_python(file); }

// ---- The reason why a file could not be read, without the file's name ----

std::string without_name(std::string_view text, const std::string& file) {
    const std::string start = one_line(file) + ": ";
    if (text.starts_with(start)) text.remove_prefix(start.size());
    return one_line(text);
}

std::string reason_of(const SceneError& error, const std::string& file) {
    if (error.errors.empty()) return without_name(error.what(), file);
    const TextError& first = error.errors.front();
    if (first.place.file && *first.place.file == one_line(file))
        return one_line(fmt::format("line {}: {}", first.place.line, first.message));
    return one_line(error.what());
}

LintedFile linted(const std::string& file, Programs programs,
                  const std::function<LintedFile(const std::string&)>& lint_one) {
    try {
        return lint_one(file);
    } catch (const std::exception& error) {
        const bool can_be_run = programs == Programs::kAreRead;
        const std::string how = can_be_run ? "twinlight lint --run " + one_line(shell_word(file)) : "";
        return {.file = file, .failure = why_not_read(error, file, how)};
    }
}

// ---- Text ----

std::string count_of(std::size_t number, std::string_view noun) {
    return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

// "3 warnings: light-black, unlit (2)"
std::string words_of(const LintedFile& file) {
    if (!file.failure.empty()) return "not read: " + file.failure;
    if (file.warnings.empty()) return "no warnings";
    std::vector<std::pair<std::string_view, int>> rules;
    for (const lint::Warning& warning : file.warnings) {
        const auto known = std::ranges::find(rules, warning.rule->name, &std::pair<std::string_view, int>::first);
        if (known == rules.end())
            rules.emplace_back(warning.rule->name, 1);
        else
            ++known->second;
    }
    std::vector<std::string> names;
    for (const auto& [name, times] : rules)
        names.push_back(times == 1 ? std::string(name) : fmt::format("{} ({})", name, times));
    return fmt::format("{}: {}", count_of(file.warnings.size(), "warning"), fmt::join(names, ", "));
}

std::string summary(const std::vector<LintedFile>& files, Programs programs) {
    const auto not_read = std::ranges::count_if(files, [](const LintedFile& file) { return !file.failure.empty(); });
    const auto warned = std::ranges::count_if(files, [](const LintedFile& file) { return !file.warnings.empty(); });
    const auto fine = static_cast<std::ptrdiff_t>(files.size()) - warned - not_read;
    std::string text = fmt::format("\n{}: {} without warnings, {} with warnings, {} not read\n",
                                   count_of(files.size(), "file"), fine, warned, not_read);
    if (warned > 0)
        text += fmt::format("The warnings of one file: twinlight lint {}FILE\n",
                            programs == Programs::kAreRun ? "--run " : "");
    const bool has_program = std::ranges::any_of(
        files, [](const LintedFile& file) { return !file.failure.empty() && is_program(file.file); });
    if (has_program && programs == Programs::kAreRead)
        text += "A program that cannot be read can be run: twinlight lint --run FILE\n";
    return text;
}

// ---- Tables ----

std::string json_of(const std::vector<LintedFile>& files) {
    Json json = {{"files", Json::array()}};
    for (const LintedFile& file : files) {
        Json one = {{"file", file.file}};
        if (file.failure.empty())
            one.update(parsed_json(lint::json_text(file.scene, file.warnings)));
        else
            one["error"] = file.failure;
        json["files"].push_back(one);
    }
    return dumped_lines(json);
}

}  // namespace

std::string why_not_read(const std::exception& error, const std::string& file, std::string_view how_to_run) {
    if (const auto* scene_error = dynamic_cast<const SceneError*>(&error)) {
        const bool can_be_read = !has_cpp_name(file) && !trace::is_python(file);
        if (can_be_read || how_to_run.empty()) return reason_of(*scene_error, file);
        return fmt::format("it is {}; run it: {}", trace::is_python(file) ? "Python" : "C++", how_to_run);
    }
    return without_name(twinlight::reason_of(error), file);
}

bool is_folder(const std::string& input) {
    std::error_code ignored;
    return fs::is_directory(input, ignored);
}

std::vector<std::string> files_to_lint(const std::vector<std::string>& inputs, Programs programs) {
    std::vector<std::string> files;
    std::set<std::string> known;
    const auto add = [&](const std::string& file) {
        if (known.insert(file).second) files.push_back(file);
    };
    for (const std::string& input : inputs) {
        if (!is_folder(input)) {
            add(input);
            continue;
        }
        const std::vector<std::string> found = files_of_folder(input, programs);
        if (found.empty())
            throw UsageError(fmt::format("{}: this folder has no {}", input,
                                         programs == Programs::kAreRun
                                             ? "program: a source in C, C++ or Python with main()"
                                             : "scene (.gl), program (.c) or recording (.trace)"));
        std::ranges::for_each(found, add);
    }
    return files;
}

int lint_files(const std::vector<std::string>& files, LintForm form, Programs programs,
               const std::function<LintedFile(const std::string&)>& lint_one) {
    constexpr std::size_t kWidest = 60;
    std::size_t width = 0;
    for (const std::string& file : files) width = std::max(width, std::min(one_line(file).size(), kWidest));
    std::vector<LintedFile> done;
    ProgressBar bar;
    const Interrupt interrupt;
    for (const std::string& file : files) {
        // A program that runs has a message itself.
        if (programs == Programs::kAreRead)
            bar.show(static_cast<int>(done.size()), static_cast<int>(files.size()), file);
        done.push_back(linted(file, programs, lint_one));
        if (form == LintForm::kText) {
            bar.wipe();
            write_result(fmt::format("{:<{}}  {}\n", one_line(file), width, words_of(done.back())));
        }
        if (Interrupt::came()) break;
    }
    bar.wipe();
    switch (form) {
        case LintForm::kText: write_result(summary(done, programs)); break;
        case LintForm::kCsv: write_result(csv_of(done)); break;
        case LintForm::kJson: write_result(json_of(done)); break;
    }
    if (done.size() < files.size())
        print_message("twinlight: note: stopped after {} of {} files\n", done.size(), files.size());
    const auto is_not_read = [](const LintedFile& file) { return !file.failure.empty(); };
    if (done.size() < files.size() || std::ranges::any_of(done, is_not_read)) return kBadInput;
    const auto is_warned = [](const LintedFile& file) { return !file.warnings.empty(); };
    return std::ranges::any_of(done, is_warned) ? kDifferent : kFine;
}

std::string csv_of(const std::vector<LintedFile>& files) {
    std::string text = "file,result,rule,source,line,count,message,fix\n";
    for (const LintedFile& file : files) {
        const std::string name = csv_field(file.file);
        if (!file.failure.empty()) text += fmt::format("{},not read,,,,,{},\n", name, csv_field(file.failure));
        if (file.failure.empty() && file.warnings.empty()) text += fmt::format("{},no warnings,,,,,,\n", name);
        for (const lint::Warning& warning : file.warnings)
            text += fmt::format("{},warning,{},{},{},{},{},{}\n", name, warning.rule->name,
                                csv_field(warning.place.file ? *warning.place.file : file.file), warning.place.line,
                                warning.count, csv_field(lint::message_of(warning)), csv_field(warning.fix));
    }
    return text;
}

}  // namespace twinlight::cli
