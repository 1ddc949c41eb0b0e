#include "app/demo/command_text.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "app/session/arguments.h"
#include "app/session/edits.h"
#include "base/text/translation.h"
#include "scene/command/print_parts.h"

namespace twinlight::demo {
namespace {

using session::Session;

constexpr int kIndent = 4;  // columns, of the second line of a long call
constexpr int kSwatchColumns = 2;

bool starts_color(const Command& command, std::size_t argument) {
    const session::ArgumentInfo info = session::argument_info(command, argument);
    return info.is_color && info.name == "red";
}

// A number with many digits, such as 4.0 / 3, with six; its help has all of them.
std::string shortened(const std::string& text) {
    constexpr std::size_t kMostDigits = 9;
    const bool is_number = text.find_first_not_of("-+.0123456789e") == std::string::npos;
    return is_number && text.size() > kMostDigits ? fmt::format("{:.6g}", std::stod(text)) : text;
}

std::vector<Piece> pieces_of(const Command& command) {
    std::vector<Piece> pieces;
    bool after_comma = false;
    for (const PrintedPart& part : print_parts(command)) {
        if (part.argument) {
            after_comma |= !pieces.empty() && pieces.back().text.ends_with('(');
            if (starts_color(command, *part.argument)) {
                pieces.push_back({"", part.argument, after_comma, true});
                after_comma = false;
            }
            // Bits may be on several lines.
            std::string text = shortened(part.text);
            for (std::size_t bar = 0; (bar = text.find(" | ")) != std::string::npos; text.erase(0, bar + 3)) {
                pieces.push_back({text.substr(0, bar + 2), part.argument, after_comma});
                after_comma = true;
            }
            pieces.push_back({text, part.argument, after_comma});
            after_comma = false;
            continue;
        }
        std::string_view text = part.text;
        constexpr std::string_view kPragma = "#pragma twinlight ";
        if (text.starts_with(kPragma)) {
            pieces.push_back({std::string(kPragma.substr(0, kPragma.size() - 1)), std::nullopt, false});
            text.remove_prefix(kPragma.size());
            after_comma = true;
        }
        while (!text.empty()) {
            const std::size_t comma = text.find(", ");
            const std::string_view piece = text.substr(0, comma == std::string_view::npos ? comma : comma + 1);
            pieces.push_back({std::string(piece), std::nullopt, after_comma && piece != ","});
            after_comma = comma != std::string_view::npos;
            text.remove_prefix(after_comma ? comma + 2 : text.size());
        }
    }
    return pieces;
}

// How many columns the pieces from `first` on need until a line may break again, or until the array that begins there ends.
int columns_until_break(const std::vector<Piece>& pieces, std::size_t first, bool is_array) {
    int columns = 0;
    for (std::size_t i = first; i < pieces.size(); ++i) {
        if (i > first && !is_array && pieces[i].may_break) break;
        columns += pieces[i].columns() + (i > first && pieces[i].may_break ? 1 : 0);
        if (is_array && pieces[i].text.starts_with('}')) break;
    }
    return columns;
}

// "glLightfv, red"
std::string edit_name(const Command& command, std::size_t argument) {
    return fmt::format("{}, {}", command.name(), session::argument_info(command, argument).name);
}

}  // namespace

int Piece::columns() const { return is_swatch ? kSwatchColumns : static_cast<int>(text.size()); }

std::vector<PlacedPiece> placed_pieces(const Command& command, int columns) {
    std::vector<Piece> pieces = pieces_of(command);
    std::vector<PlacedPiece> placed;
    int line = 0, column = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].may_break) {
            const bool is_array = pieces[i].text.ends_with('{');
            const int needed = columns_until_break(pieces, i, is_array);
            const auto fits = [&](int at, int count) { return at + count <= columns; };
            // An array that is too long for a line begins where its first value has room.
            const bool helps = column > kIndent && (!is_array || fits(kIndent, needed) ||
                                                    !fits(column + 1, columns_until_break(pieces, i, false)));
            if (!fits(column + 1, needed) && helps) {
                ++line;
                column = kIndent;
            } else if (column > 0 && !placed.back().piece.text.ends_with('(')) {
                ++column;  // the space after the comma
            }
        }
        const int width = pieces[i].columns();
        placed.push_back({std::move(pieces[i]), line, column});
        column += width;
    }
    return placed;
}

void set_argument(Session& session, std::size_t command, std::size_t argument, double value, std::string group) {
    const std::string name = edit_name(commands(session).commands[command], argument);
    edit(session, session::with_argument(commands(session), command, argument, value), name, std::move(group));
}

void move_call(Session& session, std::size_t index, bool down) {
    const CommandList& list = commands(session);
    const std::size_t count = session::end_of_group(list, index) - index + 1;
    const std::size_t to = down ? session::index_below(list, index) : session::index_above(list, index);
    edit(session, session::with_moved(list, index, to, count), tr("move {}", list.commands[index].name()));
    session.selected_command = to;
}

double rounded_to_step(double value, double step) { return std::round(value / step) * step; }

}  // namespace twinlight::demo
