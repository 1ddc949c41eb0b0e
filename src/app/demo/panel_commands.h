// The panel of the scene's calls, as C text: numbers are dragged or typed in place, names are picked from what is legal,
// calls are moved, deleted and inserted.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/session/arguments.h"
#include "app/session/session.h"

namespace twinlight::demo {

class CommandsPanel {
  public:
    void show(session::Session& session);
    // These calls only, one line each, as large as the width allows; and what is under the mouse.
    void show_calls(session::Session& session, const std::vector<std::size_t>& calls);
    // Whether a number is being typed.
    bool is_typing() const { return typed_.has_value(); }

  private:
    // One call in the list, or a folded glBegin with all up to its glEnd.
    struct Row {
        std::size_t command = 0, count = 1;
        int lines = 1;   // long calls are broken
        double top = 0;  // in pixels from the start of the list
        bool is_fold = false, is_folded = false;
        bool is_inside = false;  // of a glBegin that is not folded
        std::size_t fold = 0;    // the number of the glBegin
    };
    static constexpr float kDragThreshold = 3;  // pixels; less is a click

    struct ArgumentAt {
        std::size_t command = 0, argument = 0;
        friend bool operator==(const ArgumentAt&, const ArgumentAt&) = default;
    };

    void refresh_rows(const session::Session& session, int columns, double line_height);
    void show_tools(session::Session& session);
    void show_list(session::Session& session);
    void show_gutter(const session::Session& session, const Row& row, const ImVec2& start);
    void show_row(session::Session& session, const Row& row, int columns);
    void show_argument(session::Session& session, ArgumentAt at, const std::string& text);
    void show_swatch(session::Session& session, ArgumentAt at);
    void show_input(session::Session& session);
    void drag_row(const session::Session& session, const Row& row, double list_top);
    void show_help(const session::Session& session, const char* otherwise);
    void show_argument_menu(session::Session& session);
    void show_choices(session::Session& session);
    void show_insert(session::Session& session);
    void scroll_to(std::size_t command, double visible_height);
    std::size_t row_of(std::size_t command) const;
    const Command* opened_command(const session::Session& session, std::size_t command) const;

    std::vector<Row> rows_;
    std::vector<std::optional<std::size_t>> opened_;  // for each command, that of the file
    std::set<std::size_t> unfolded_;                  // numbers of glBegins
    std::shared_ptr<const CommandList> shown_;
    int shown_columns_ = 0;
    std::size_t shown_unfolded_ = 0;
    double height_ = 0;
    bool has_gutter_ = true;

    bool is_over_part_ = false;          // the mouse is over an argument, a swatch or the gutter of the row
    std::string help_;                   // of what is under the mouse
    std::optional<ArgumentAt> dragged_;  // the number that is being dragged
    double dragged_from_ = 0;
    std::optional<ArgumentAt> typed_;  // the number that is being typed
    bool typed_needs_focus_ = false;
    float typed_x_ = 0, typed_y_ = 0;  // where the number is, on the screen
    char typed_text_[128] = "";
    std::optional<ArgumentAt> asked_;  // whose menu, choices or colours are open
    std::vector<session::Choice> choices_;
    const char* to_open_ = nullptr;         // the popup to open after the list
    std::optional<std::size_t> moved_row_;  // the row that is being moved
    struct Move {
        std::size_t from, to, count;
    };
    std::optional<Move> to_move_;  // after the list is shown
    std::optional<std::size_t> last_selected_;
    bool scroll_to_selected_ = false;
    std::optional<std::size_t> changed_;  // the first call that the last edit changed: to be scrolled to
    char inserted_text_[512] = "";
    bool insert_takes_focus_ = false;
    std::string insert_error_;
    std::optional<std::size_t> replaced_;  // the call that the typed one replaces
};

}  // namespace twinlight::demo
