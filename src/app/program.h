// What both programs share of a command line: version, exit status, how bad use is told, sizes.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace twinlight {

inline constexpr const char* kVersion = "0.1";

// Exit status.
inline constexpr int kFine = 0;
inline constexpr int kDifferent = 1;  // beyond the tolerance
inline constexpr int kBadInput = 2;   // or bad use: one line on standard error

// Bad use. what() is one line: what is wrong; how to mend it.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Size {
    int width = 640;
    int height = 480;
};
inline constexpr int kMinSide = 1;
inline constexpr int kMaxSide = 8192;  // what every driver's viewport can hold

// Throws CLI::ValidationError for anything but WxH within the limits.
Size parse_size(const std::string& text);
void add_size_option(CLI::App& app, Size& size);
// Nothing unless it is given: then a scene is drawn at 640x480, a recorded program at the size of its window.
void add_size_option(CLI::App& app, std::optional<Size>& size);

// For names of files and scenes.
CLI::Validator not_empty();

// Whether the program is to go on; false once --help or --version has answered. Throws UsageError.
bool parse_command_line(CLI::App& app, int argc, char** argv);

// Standard output, whole; throws FileError when it cannot be written.
void write_result(std::string_view bytes);

// Names from outside may hold anything; a line of ours stays one line.
std::string one_line(std::string_view text);

// Runs a program: its exit status; for what it throws, a line on standard error and kBadInput.
int run_telling_failures(std::string_view program, const std::function<int()>& run);

}  // namespace twinlight
