// Shared by the command lines of both programs: exit status, error messages, sizes.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "app/streams.h"
#include "app/version.h"
#include "judge/lesson/lesson.h"

namespace twinlight {

// Exit status.
inline constexpr int kFine = 0;
inline constexpr int kDifferent = 1;  // a difference that is larger than allowed
inline constexpr int kBadInput = 2;   // or bad usage; standard error has one line, or a scene's errors

// Bad usage. what() is one line: what is wrong, and how to correct it.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Size {
    int width = 640;
    int height = 480;
};
inline constexpr int kMinSide = 1;
inline constexpr int kMaxSide = 8192;  // every driver's viewport allows this

// Throws CLI::ValidationError unless `text` is WxH within the limits.
Size parse_size(const std::string& text);
void add_size_option(CLI::App& app, Size& size);
// Empty if the option is not given; --help then shows `default_size`.
void add_size_option(CLI::App& app, std::optional<Size>& size,
                     const std::string& default_size = "that of the scene or program; 640x480 if it gives none");

// Accepts numbers from `low` to `high`. Unlike CLI::Range, adds nothing to --help, its message is plain, and it accepts
// neither nan nor a negative number for an unsigned one.
template <class Number>
CLI::Validator number_from(Number low, Number high) {
    const auto check = [low, high](const std::string& text) {
        Number number{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool is_number = error == std::errc() && end == text.data() + text.size();
        if (is_number && low <= number && number <= high) return std::string();
        return fmt::format("'{}' is not a {}number from {} to {}", text, std::is_integral_v<Number> ? "whole " : "",
                           low, high);
    };
    return CLI::Validator(check, "");
}

// --language en|zh. `what`: what is in this language.
void add_language_option(CLI::App& app, lesson::Language& language, const std::string& what);

// Rejects empty names of files and scenes.
CLI::Validator not_empty();

// False if --help or --version was given and has been printed. Throws UsageError.
bool parse_command_line(CLI::App& app, int argc, char** argv);

// Writes to a file, whole or not at all, or to standard output if its name is "-". Throws FileError.
void write_output(const std::string& file, std::string_view bytes);

// Our lesson of this name, or that of a file, NAME.md, whose own words are in this language. Throws UsageError if there is no such
// lesson, and FileError for a file that cannot be read or is no lesson, with the line.
lesson::Lesson load_lesson(const std::string& name, lesson::Language language);

// Runs a program and returns its exit status. If it throws, prints the error on standard error and returns kBadInput.
// Prepares the standard streams (streams.h). If it crashes, a line on standard error says so first. Freed memory is kept
// (render/context/context.h).
int run_reporting_errors(std::string_view program, const std::function<int()>& run);

}  // namespace twinlight
