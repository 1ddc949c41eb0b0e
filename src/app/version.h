// What --version prints, for reports of bugs.
#pragma once

#include <CLI/CLI.hpp>

namespace twinlight {

inline constexpr const char* kVersion = "0.1";
// Made by the Makefile.
extern const char* const kCommit;     // "627ae9cd", "627ae9cd+" with other changes; empty if it is unknown
extern const char* const kLibraries;  // "glm 0.9.9, fmt 9.1.0": those that the program was built with

// Adds --version, which opens the driver to print its name.
void add_version_flag(CLI::App& app, const char* program);

}  // namespace twinlight
