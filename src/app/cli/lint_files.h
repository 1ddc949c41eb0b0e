// lint of many files: a line for each, or a table, or JSON.
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "judge/lint/lint.h"

namespace twinlight::cli {

bool is_folder(const std::string& input);

enum class Programs { kAreRead, kAreRun };

// The inputs, with each folder replaced by the files in it and in its folders, sorted: scenes, programs and recordings; or with
// kAreRun, the programs. Hidden files do not count, nor sources that are only a part of a program. Throws UsageError if a folder has
// no such file.
std::vector<std::string> files_to_lint(const std::vector<std::string>& inputs, Programs programs);

// Why a file could not be read, in one line that does not begin with its name. `how_to_run`: the command that runs a program which
// only the compiler can read; empty if it was run.
std::string why_not_read(const std::exception& error, const std::string& file, std::string_view how_to_run);

struct LintedFile {
    std::string file;     // as on the command line
    std::string scene{};  // its name
    std::vector<lint::Warning> warnings{};
    std::string failure{};  // why it could not be read, in one line; "" if it could
};

enum class LintForm { kText, kCsv, kJson };

// Lints one file after the other. A file for which `lint_one` throws counts as not read, and the others follow. Prints the text as it
// comes, the other forms at the end. Ctrl-C ends it after a file. Returns the exit status.
int lint_files(const std::vector<std::string>& files, LintForm form, Programs programs,
               const std::function<LintedFile(const std::string&)>& lint_one);

// A row for each warning, and one for each file without warnings or that could not be read.
std::string csv_of(const std::vector<LintedFile>& files);

}  // namespace twinlight::cli
