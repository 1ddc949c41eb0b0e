#include "app/demo/panel_commands.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

#include "app/demo/command_text.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/edits.h"
#include "app/session/keys.h"
#include "base/text/translation.h"
#include "scene/command/text.h"

namespace twinlight::demo {
namespace {

using session::Session;

constexpr std::size_t kMostMeasured = 20'000;  // rows; longer lists have one line for each call
constexpr float kGutter = 16;                  // at scale 1: where a call is grabbed and folded
constexpr float kHelpLines = 3.2f;

constexpr ImU32 kRowHovered = IM_COL32(255, 255, 255, 9);
constexpr ImU32 kRowSelected = IM_COL32(240, 178, 72, 34);
constexpr ImU32 kErrorLine = IM_COL32(240, 110, 96, 200);

// The width of a letter; CalcTextSize rounds up to whole pixels.
float width_of_column() {
    constexpr std::string_view kLetters = "MMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMM";
    return ImGui::CalcTextSize(kLetters.data(), kLetters.data() + kLetters.size()).x /
           static_cast<float>(kLetters.size());
}

}  // namespace

const Command* CommandsPanel::opened_command(const Session& session, std::size_t command) const {
    if (command >= opened_.size()) return nullptr;
    return opened_[command] ? &session.opened->commands[*opened_[command]] : nullptr;
}

std::size_t CommandsPanel::row_of(std::size_t command) const {
    const auto after = std::ranges::upper_bound(rows_, command, {}, &Row::command);
    return after == rows_.begin() ? 0 : static_cast<std::size_t>(after - rows_.begin()) - 1;
}

// Measures only the calls that changed: while a number is dragged, that is one.
void CommandsPanel::refresh_rows(const Session& session, int columns, double line_height) {
    const std::shared_ptr<const CommandList> now = session.history.now();
    const bool is_same = now == shown_ && columns == shown_columns_ && unfolded_.size() == shown_unfolded_;
    if (is_same) return;
    const std::vector<Command>& list = now->commands;
    std::vector<int> known(list.size(), 0);  // lines; 0: to be measured
    if (shown_ && shown_columns_ == columns && shown_->commands.size() == list.size())
        for (const Row& row : rows_)
            if (!row.is_folded && list[row.command] == shown_->commands[row.command]) known[row.command] = row.lines;

    rows_.clear();
    std::size_t folds = 0, end_of_fold = 0;
    double top = 0;
    for (std::size_t i = 0; i < list.size();) {
        Row row{.command = i, .top = top, .is_inside = i < end_of_fold};
        const std::size_t last = session::end_of_group(*now, i);
        if (last > i) {
            row.is_fold = true;
            row.fold = folds++;
            row.is_folded = !unfolded_.contains(row.fold);
            if (row.is_folded)
                row.count = last - i + 1;
            else
                end_of_fold = last;
        }
        if (!row.is_folded && list.size() <= kMostMeasured)
            row.lines = known[i] > 0 ? known[i] : placed_pieces(list[i], columns).back().line + 1;
        top += row.lines * line_height;
        i += row.count;
        rows_.push_back(row);
    }
    height_ = top;
    constexpr std::size_t kMostCompared = 100'000;
    if (now != shown_) {
        // The first call that an edit changed. The camera changes all the time.
        changed_.reset();
        if (shown_ && shown_->name == now->name) {
            const auto [before, after] = std::ranges::mismatch(shown_->commands, list);
            if (after != list.end() && after->id != CommandId::gluLookAt)
                changed_ = static_cast<std::size_t>(after - list.begin());
        }
        opened_.clear();
        if (list.size() <= kMostCompared) opened_ = session::opened_commands(*session.opened, *now);
    }
    shown_ = now;
    shown_columns_ = columns;
    shown_unfolded_ = unfolded_.size();
}

// Moves a call by a drag of its gutter.
void CommandsPanel::drag_row(const Session& session, const Row& row, double list_top) {
    const std::size_t number = row_of(row.command);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kDragThreshold)) moved_row_ = number;
    if (moved_row_ != number) return;
    // The border between two rows that is nearest to the mouse.
    const double y = static_cast<double>(ImGui::GetIO().MousePos.y) - list_top;
    const auto bottom = [this](std::size_t i) { return i + 1 < rows_.size() ? rows_[i + 1].top : height_; };
    std::size_t border = 0;
    while (border < rows_.size() && (rows_[border].top + bottom(border)) / 2 < y) ++border;
    const double line = border < rows_.size() ? rows_[border].top : height_;
    const ImVec2 left{ImGui::GetWindowPos().x, static_cast<float>(list_top + line)};
    ImGui::GetWindowDrawList()->AddLine(left, plus(left, {ImGui::GetWindowWidth(), 0}), kAccent, 2);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    moved_row_.reset();
    const std::size_t count = session::end_of_group(commands(session), row.command) - row.command + 1;
    const std::size_t before = border < rows_.size() ? rows_[border].command : commands(session).commands.size();
    if (before >= row.command && before <= row.command + count) return;
    to_move_ = Move{row.command, before > row.command ? before - count : before, count};
}

// Folds glBegin, and moves calls by a drag.
void CommandsPanel::show_gutter(const Session& session, const Row& row, const ImVec2& start) {
    const float line_height = ImGui::GetTextLineHeightWithSpacing(), gutter = at_scale(kGutter);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const bool clicked = ImGui::InvisibleButton("gutter", {gutter, line_height});
    const bool gutter_hovered = ImGui::IsItemHovered();
    drag_row(session, row, static_cast<double>(start.y) - row.top);
    is_over_part_ = gutter_hovered;
    if (gutter_hovered) {
        help_ = tr(row.is_fold ? "click to fold or unfold; drag to move all up to glEnd" : "drag to move this call");
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    }
    const ImVec2 middle = plus(start, {gutter / 2, line_height / 2});
    const float r = at_scale(4);
    if (row.is_fold && row.is_folded)
        draw.AddTriangleFilled({middle.x - r / 2, middle.y - r}, {middle.x - r / 2, middle.y + r},
                               {middle.x + r, middle.y}, kSignColor);
    else if (row.is_fold)
        draw.AddTriangleFilled({middle.x - r, middle.y - r / 2}, {middle.x + r, middle.y - r / 2},
                               {middle.x, middle.y + r}, kSignColor);
    else if (gutter_hovered)
        for (const float dy : {-r, 0.0f, r}) draw.AddCircleFilled({middle.x, middle.y + dy}, 1.5f, kSignColor);
    if (clicked && row.is_fold && !moved_row_) {
        if (row.is_folded)
            unfolded_.insert(row.fold);
        else
            unfolded_.erase(row.fold);
        shown_columns_ = 0;
    }
}

void CommandsPanel::show_row(Session& session, const Row& row, int columns) {
    const std::shared_ptr<const CommandList> list = session.history.now();  // edits below must not free it
    const Command& command = list->commands[row.command];
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line_height = ImGui::GetTextLineHeightWithSpacing();
    const float width = ImGui::GetContentRegionAvail().x, height = line_height * static_cast<float>(row.lines);
    const float gutter = has_gutter_ ? at_scale(kGutter) : 0, column_width = width_of_column();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImGui::PushID(static_cast<int>(row.command));

    const bool is_selected = session.selected_command && *session.selected_command >= row.command &&
                             *session.selected_command < row.command + row.count;
    const ImVec2 end = plus(start, {width, height});
    const bool is_under_mouse = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(start, end);
    if (is_selected) draw.AddRectFilled(start, end, kRowSelected, 3);
    if (is_under_mouse) draw.AddRectFilled(start, end, kRowHovered, 3);
    const bool is_wrong = !session.error.empty() && !session::error_of(command).empty();
    if (is_wrong) draw.AddRectFilled(start, {start.x + 3, end.y}, kErrorLine);
    if (is_wrong && is_under_mouse) help_ = session::error_of(command);

    is_over_part_ = false;
    if (has_gutter_) show_gutter(session, row, start);

    constexpr int kInsideColumns = 4;
    if (row.is_inside) columns -= kInsideColumns;
    const float indent = row.is_inside ? kInsideColumns * column_width : 0;
    const Command* const before = opened_command(session, row.command);
    const bool is_other = !opened_.empty() && (!before || before->id != command.id);
    const ImVec2 text_start = plus(start, {gutter + indent, 0});
    int pieces = 0;
    for (const PlacedPiece& placed : placed_pieces(command, row.is_folded ? 1000 : columns)) {
        const ImVec2 at = plus(text_start, {static_cast<float>(placed.column) * column_width,
                                            static_cast<float>(placed.line) * line_height});
        ImGui::SetCursorScreenPos(at);
        const Piece& piece = placed.piece;
        if (piece.is_swatch) {
            show_swatch(session, {row.command, *piece.argument});
        } else if (piece.argument) {
            ImGui::PushID(++pieces);  // bits have several
            show_argument(session, {row.command, *piece.argument}, piece.text);
            ImGui::PopID();
        } else if (placed.line == 0 && placed.column == 0)
            draw_code(at, is_other ? kAccent : kFunctionColor, piece.text, is_other);
        else
            draw_code(at, kSignColor, piece.text, false);
    }
    if (row.is_folded) {
        const std::string rest = tr("  ... {} calls, glEnd();", row.count - 2);
        const float used = static_cast<float>(print_command(command).size()) * column_width;
        draw_code(plus(text_start, {used, 0}), kSignColor, rest, false);
    }

    if (typed_ && typed_->command == row.command) {
        ImGui::SetCursorScreenPos({typed_x_, typed_y_});
        show_input(session);
    }

    // What is left of the row: selects it. A double click edits the whole call as text.
    ImGui::SetCursorScreenPos(start);
    ImGui::InvisibleButton("row", {std::max(width, 1.0f), height});
    if (ImGui::IsItemHovered() && !is_over_part_) {
        const std::string line = command.place.line > 0 ? tr("line {}: ", command.place.line) : "";
        if (!is_wrong) help_ = line + command.sig().usage() + tr("  double click: edit as text; right click: menu");
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            replaced_ = row.command;
            std::snprintf(inserted_text_, sizeof inserted_text_, "%s", print_command(command).c_str());
            insert_error_.clear();
            to_open_ = "type a call";
        }
        if (ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
            asked_ = ArgumentAt{row.command, command.arguments.size()};
            session.selected_command = last_selected_ = row.command;
            to_open_ = "argument menu";
        }
    }
    if (ImGui::IsItemClicked() && !is_over_part_) session.selected_command = last_selected_ = row.command;
    ImGui::PopID();
}

void CommandsPanel::show_list(Session& session) {
    const float column_width = width_of_column(), line_height = ImGui::GetTextLineHeightWithSpacing();
    const float room = ImGui::GetContentRegionAvail().x - at_scale(kGutter);
    const int columns = std::max(20, static_cast<int>(room / column_width) - 1);  // one stays free before the scrollbar
    refresh_rows(session, columns, static_cast<double>(line_height));
    if (session.selected_command != last_selected_) {
        last_selected_ = session.selected_command;
        scroll_to_selected_ = last_selected_.has_value();
    }
    const auto visible_height = static_cast<double>(ImGui::GetWindowHeight());
    if (std::exchange(scroll_to_selected_, false) && last_selected_) scroll_to(*last_selected_, visible_height);
    if (const auto changed = std::exchange(changed_, std::nullopt)) scroll_to(*changed, visible_height);

    const ImVec2 start = ImGui::GetCursorPos();
    const double top = static_cast<double>(ImGui::GetScrollY()),
                 bottom = top + static_cast<double>(ImGui::GetWindowHeight());
    const std::vector<Row> rows = rows_;  // edits below make new ones
    auto row = std::ranges::upper_bound(rows, top, {}, &Row::top);
    if (row != rows.begin()) --row;
    for (; row != rows.end() && row->top < bottom; ++row) {
        if (row->command + row->count > commands(session).commands.size()) break;
        ImGui::SetCursorPos({start.x, start.y + static_cast<float>(row->top)});
        show_row(session, *row, columns);
    }
    if (to_move_) {
        const auto [from, to, count] = *std::exchange(to_move_, std::nullopt);
        const std::string what = tr("move {}", commands(session).commands[from].name());
        edit(session, session::with_moved(commands(session), from, to, count), what);
        session.selected_command = last_selected_ = to;
    }
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) moved_row_.reset();  // of a row that is no longer seen
    ImGui::SetCursorPos({start.x, start.y + static_cast<float>(height_)});
    ImGui::Dummy({1, 1});
}

void CommandsPanel::scroll_to(std::size_t command, double visible_height) {
    if (rows_.empty()) return;
    const Row& row = rows_[row_of(command)];
    if (row.is_folded && command > row.command) unfolded_.insert(row.fold);
    const double top = static_cast<double>(ImGui::GetScrollY());
    if (row.top >= top && row.top + 40 < top + visible_height) return;
    ImGui::SetScrollY(static_cast<float>(std::max(0.0, row.top - visible_height / 3)));
}

void CommandsPanel::show_tools(Session& session) {
    const std::shared_ptr<const CommandList> list = session.history.now();
    const std::size_t index = session.selected_command.value_or(list->commands.size());
    const bool has_selected = index < list->commands.size();
    const auto button = [](const char* label, bool is_enabled, const char* tip) {
        const float width = ImGui::CalcTextSize(tr(label)).x + 2 * ImGui::GetStyle().FramePadding.x;
        if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
        ImGui::BeginDisabled(!is_enabled);
        const bool pressed = ImGui::Button(tr(label));
        ImGui::EndDisabled();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr(tip));
        ImGui::SameLine();
        return pressed;
    };
    if (button("Undo", session.history.can_undo(), "undo the last edit (z)")) session::press(session, 'z');
    if (button("Redo", session.history.can_redo(), "redo the undone edit (y)")) session::press(session, 'y');
    const std::size_t count = has_selected ? session::end_of_group(*list, index) - index + 1 : 0;
    const std::string name = has_selected ? std::string(list->commands[index].name()) : "";
    if (button("Up", has_selected && index > 0, "move the selected call up")) move_call(session, index, false);
    if (button("Down", has_selected && index + count < list->commands.size(), "move the selected call down"))
        move_call(session, index, true);
    if (button("Delete", has_selected, "delete the selected call"))
        edit(session, session::without_command(*list, index, count), tr("delete {}", name));
    if (button("Insert...", true, "insert a call after the selected one")) {
        replaced_.reset();
        inserted_text_[0] = '\0';
        insert_error_.clear();
        ImGui::OpenPopup("type a call");
    }
    show_insert(session);
    ImGui::NewLine();
}

// `otherwise`: what to say if nothing is under the mouse.
void CommandsPanel::show_help(const Session& session, const char* otherwise) {
    ImGui::Separator();
    if (!session.error.empty() && help_.empty()) {
        colored_text(kBad, session.error);
    } else {
        dim_text(help_.empty() ? otherwise : help_);
    }
}

void CommandsPanel::show(Session& session) {
    help_.clear();
    show_tools(session);
    const float help_height = ImGui::GetTextLineHeightWithSpacing() * kHelpLines;
    ImGui::PushFont(fonts().code);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, at_scale(4)});
    ImGui::BeginChild("calls", {0, -help_height}, false);
    show_list(session);
    if (to_open_) ImGui::OpenPopup(std::exchange(to_open_, nullptr));
    show_choices(session);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    show_argument_menu(session);
    if (replaced_) show_insert(session);
    ImGui::EndChild();
    show_help(session, tr("Drag a number, or click it to type. Click a name to choose. Changed values are bold."));
}

void CommandsPanel::show_calls(Session& session, const std::vector<std::size_t>& calls) {
    help_.clear();
    ImGui::PushFont(fonts().code_large);
    const std::shared_ptr<const CommandList> list = session.history.now();
    std::size_t longest = 1;
    for (const std::size_t call : calls) longest = std::max(longest, print_command(list->commands[call]).size() + 4);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float needed_x = static_cast<float>(longest) * width_of_column(), gap = at_scale(7);
    const float lines = static_cast<float>(calls.size()), help = 2.5F * height_of(*fonts().text);
    const float needed_y = lines * (ImGui::GetFontSize() + gap);
    const float fit = std::min({1.0F, room.x / needed_x, (room.y - help) / needed_y});
    ImGui::SetWindowFontScale(std::max(fit, 0.5F));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, fit * gap});
    constexpr int kOneLine = 1000;  // columns
    refresh_rows(session, kOneLine, static_cast<double>(ImGui::GetTextLineHeightWithSpacing()));
    has_gutter_ = false;
    for (const std::size_t call : calls) show_row(session, {.command = call}, kOneLine);
    has_gutter_ = true;
    if (to_open_) ImGui::OpenPopup(std::exchange(to_open_, nullptr));
    ImGui::SetWindowFontScale(1);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::PushFont(fonts().code);
    show_choices(session);
    ImGui::PopFont();
    show_argument_menu(session);
    if (replaced_) show_insert(session);
    show_help(
        session,
        tr("Drag a number, or click it to type. Drag the light on the left. Point at the picture to see why a pixel "
           "has its colour."));
}

}  // namespace twinlight::demo
