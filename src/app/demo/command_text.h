// The text of a call as the panel shows it: pieces with places in lines and columns. And the edits that the panel's parts
// share.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "scene/command/command.h"

namespace twinlight::demo {

// A piece of a printed call that is not broken: text, or an argument, or the swatch before a colour.
struct Piece {
    std::string text;
    std::optional<std::size_t> argument{};
    bool may_break = false;  // a line may begin with it
    bool is_swatch = false;
    int columns() const;
};
struct PlacedPiece {
    Piece piece;
    int line = 0, column = 0;
};

// Breaks a call that is longer than `columns` after commas, or before its first argument; an array stays on one line if it can. Numbers with many
// digits are shortened.
std::vector<PlacedPiece> placed_pieces(const Command& command, int columns);

// Sets an argument as one edit, "glLightfv, red". Edits of one non-empty group are one step of undo.
void set_argument(session::Session& session, std::size_t command, std::size_t argument, double value,
                  std::string group = {});
// Moves a call past the one above or below it, and selects it; glBegin with all up to glEnd is one.
void move_call(session::Session& session, std::size_t index, bool down);

// The multiple of `step` nearest to `value`: what a drag gives as a readable number.
double rounded_to_step(double value, double step);

}  // namespace twinlight::demo
