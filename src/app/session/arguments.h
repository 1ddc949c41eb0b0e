// Arguments: what the window needs to show and edit one argument of a command: its name, its legal values, GL's initial
// value and a line of help. State says which values are legal.
//
// An argument is an element of Command::arguments; an array is several.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/command/command.h"

namespace twinlight::session {

struct Choice {
    std::string name;  // "GL_SPOT_CUTOFF"
    double value = 0;
};

// How the window edits an argument: as 0 or 1, by choosing a name or bits, as a number, or not at all (pointers,
// quadrics, numbers of objects).
enum class Editing : std::uint8_t { kNumber, kFlag, kName, kBits, kFixed };

struct ArgumentInfo {
    // "pname"; "red" and "x" for the elements of colours and vectors; "GL_SHININESS" for the only value of a parameter
    std::string name;
    std::size_t parameter = 0;  // index into Signature::parameters
    Kind kind = Kind::kInt;
    Editing editing = Editing::kNumber;
    bool is_color = false;  // a number that is a component of a colour
    // Where a number is legal; infinite without a limit. If `is_clamped`, GL clamps to this range and raises no error.
    double smallest = 0, largest = 0;
    bool is_clamped = false;
    double drag_speed = 0;            // a sensible change for one pixel of a drag
    std::optional<double> initial{};  // GL's initial value
};
ArgumentInfo argument_info(const Command& command, std::size_t argument);
// The argument as print_command() writes it, if it had this value.
std::string printed_argument(const Command& command, std::size_t argument, double value);
// One line: what it is, its initial value, and the section of GL 2.1.
std::string argument_help(const Command& command, std::size_t argument);

// The legal values of a name, a flag or bits. State tries each name of GL, so this takes milliseconds. Empty for
// numbers, and for names that State does not check because only the driver supports them.
std::vector<Choice> legal_choices(const Command& command, std::size_t argument);

// The same command with another value, rounded to the argument's type. A pname with another number of values, or of
// another meaning, gets GL's initial values.
Command changed_argument(const Command& command, std::size_t argument, double value);
// The legal value nearest to `value`, for dragging: GL_SPOT_CUTOFF jumps from 90 to 180.
double nearest_legal(const Command& command, std::size_t argument, double value);
// GL's initial values of all arguments that have one; the others stay.
Command with_initial_values(const Command& command);

// The GL error that the command's own values raise, "GL_SPOT_CUTOFF is 120; it must be in [0, 90] or 180
// (GL_INVALID_VALUE)"; empty if they raise none.
std::string error_of(const Command& command);

// ---- What was changed since the scene was opened ----

// For each command of `now`, the index of the command of `opened` that it was, or nullopt if it was inserted. The n-th
// command with a place belongs to the n-th command that had this place.
std::vector<std::optional<std::size_t>> opened_commands(const CommandList& opened, const CommandList& now);
// Whether an argument differs from that of the opened command, which is null for an inserted one.
bool is_changed(const Command* opened, const Command& now, std::size_t argument);

}  // namespace twinlight::session
