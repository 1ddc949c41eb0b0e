// The answers of a class: FOLDER/STUDENT/LESSON.gl, or .c and other programs.
#pragma once

#include <string>
#include <vector>

#include "judge/lesson/lesson.h"

namespace twinlight::cli {

struct ClassArguments {
    std::string folder;
    // To grade. Empty: those that students answered, and the folder's own, FOLDER/LESSON.md.
    std::vector<lesson::Lesson> lessons{};
    lesson::Language language = lesson::Language::kEnglish;
    std::string csv{}, page{};  // a file or - for the table, and a folder for the page; empty: none
    bool json = false, runs_programs = false;
};

// Grades each answer. One that is missing or cannot be read has a row with no points, and the others follow. Returns the exit
// status. Throws UsageError where the folder has no answers.
int grade_class(const ClassArguments& arguments);

}  // namespace twinlight::cli
