// Edits: changes of a scene's commands, as pure functions from commands to commands. Keys and panels make them.
//
// Changed commands keep their place in the text. Inserted commands have the place "the window".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/command/command.h"
#include "scene/frame/frame.h"

namespace twinlight::session {

// A command that the window inserts. The values are rounded to the types of the parameters.
Command new_command(CommandId id, std::vector<double> arguments);
// The value as the C type `kind` would hold it: rounded to float, to a whole number, or to the nearest value in range.
double as_kind(double value, Kind kind);

// ---- What the keys do ----

// glEnable becomes glDisable and the reverse, wherever the scene switches the light. If it never does, glEnable is
// inserted at the start. Twice gives the first picture again.
CommandList toggle_light(const CommandList& commands, int light);
// The same for any capability. One that is initially on, such as GL_DITHER, gets glDisable at the start.
CommandList toggle_capability(const CommandList& commands, Enum cap);
// Flips GL_LIGHT_MODEL_LOCAL_VIEWER or GL_LIGHT_MODEL_TWO_SIDE wherever the scene sets it. If it never does, it is
// set to 1 at the start.
CommandList toggle_light_model(const CommandList& commands, Enum pname);
// The whole scene becomes GL_FLAT if its first Draw is smooth, and GL_SMOOTH if it is flat.
CommandList toggle_shade_model(const CommandList& commands);

// ---- Tessellation ----

// The slices and stacks (or sides and rings, or slices and loops) of every round shape times 2^(steps/2), at least 3.
// A shape without them stays as it is, and so does one that would have more than kMostShapeFacets facets or
// 10,000 slices.
CommandList change_tessellation(const CommandList& commands, int steps);
inline constexpr double kMostShapeFacets = 500'000;
// The slices and stacks of the shapes, "48 x 24"; "32 x 16 to 96 x 48" if they differ. Empty if no shape has them.
std::string tessellation(const CommandList& commands);

// ---- Edits of single commands. An index beyond the end changes nothing. ----

// Sets one of Command::arguments. If it is a pname that has another number of values, the values are replaced by GL's
// initial ones.
CommandList with_argument(const CommandList& commands, std::size_t command, std::size_t argument, double value);
CommandList with_command(const CommandList& commands, std::size_t index, Command command);
CommandList with_inserted(const CommandList& commands, std::size_t index, Command command);
// Without `count` commands from `index` on.
CommandList without_command(const CommandList& commands, std::size_t index, std::size_t count = 1);
// Moves `count` commands from `from` on, so that the first of them is at `to` afterwards.
CommandList with_moved(const CommandList& commands, std::size_t from, std::size_t to, std::size_t count = 1);

// The last of the commands that belong together with this one when it is moved or deleted: glEnd for glBegin, otherwise
// the command itself.
std::size_t end_of_group(const CommandList& commands, std::size_t index);

// With a copy of the command and its group after it.
CommandList with_duplicate(const CommandList& commands, std::size_t index);

// Where with_moved() takes a command past the one above or below it; past a whole group, never into one.
std::size_t index_above(const CommandList& commands, std::size_t index);
std::size_t index_below(const CommandList& commands, std::size_t index);

// Which command begins each Draw of the frame: glBegin, a shape, glDrawArrays or glCallList.
std::vector<std::size_t> commands_of_draws(const CommandList& commands);

// ---- What the user sees of it ----

// Whether the light adds nothing: its three colours are 0.
bool is_black(const LightSource& light);
// "GL_LIGHT1 is on, but its colours are black". A sentence for the status line after a light was switched.
std::string what_light_shows(const Frame& frame, int light);
// The same for GL_LIGHTING, GL_NORMALIZE and other capabilities; `commands` made the frame.
std::string what_capability_shows(const CommandList& commands, const Frame& frame, Enum cap);
// The same for GL_LIGHT_MODEL_LOCAL_VIEWER and GL_LIGHT_MODEL_TWO_SIDE.
std::string what_light_model_shows(const Frame& frame, Enum pname);

}  // namespace twinlight::session
