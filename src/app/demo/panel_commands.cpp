#include "app/demo/panel_commands.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string_view>
#include <utility>

#include "app/demo/command_text.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/edits.h"
#include "scene/command/memory.h"
#include "scene/command/print_parts.h"
#include "scene/command/text.h"

namespace twinlight::demo {
namespace {

using session::Editing;
using session::Session;

constexpr std::size_t kMostMeasured = 20'000;  // rows; longer lists have one line for each call
constexpr float kGutter = 16;                  // at scale 1: where a call is grabbed and folded
constexpr float kHelpLines = 3.2f;
constexpr float kDragThreshold = 3;  // pixels; less is a click

constexpr ImU32 kFunctionColor = IM_COL32(206, 211, 220, 255);
constexpr ImU32 kSignColor = IM_COL32(126, 132, 145, 255);
constexpr ImU32 kNameColor = IM_COL32(140, 184, 222, 255);
constexpr ImU32 kNumberColor = IM_COL32(231, 214, 180, 255);
constexpr ImU32 kRowHovered = IM_COL32(255, 255, 255, 9);
constexpr ImU32 kRowSelected = IM_COL32(240, 178, 72, 34);
constexpr ImU32 kArgumentHovered = IM_COL32(255, 255, 255, 28);
constexpr ImU32 kErrorLine = IM_COL32(240, 110, 96, 200);

// The width of a letter; CalcTextSize rounds up to whole pixels.
float width_of_column() {
    constexpr std::string_view kLetters = "MMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMMM";
    return ImGui::CalcTextSize(kLetters.data(), kLetters.data() + kLetters.size()).x /
           static_cast<float>(kLetters.size());
}

void draw_code(ImVec2 at, ImU32 color, const std::string& text, bool is_bold) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* const font = is_bold ? fonts().code_bold : fonts().code;
    list.AddText(font, ImGui::GetFontSize(), at, color, text.c_str());
}

// How far a pixel moves a number: more for large numbers, a tenth with Shift.
double step_of(const session::ArgumentInfo& info, double value) {
    double step = info.drag_speed;
    if (is_real(info.kind) && !info.is_color)
        for (double magnitude = 50; std::abs(value) >= magnitude; magnitude *= 10) step *= 10;
    return ImGui::GetIO().KeyShift ? step / 10 : step;
}

// The number that the text means: any constant expression of C. Throws SceneError.
double number_of(const std::string& text) {
    const CommandList read = read_scene("glTranslated(" + text + ", 0, 0);", "the number", "the number");
    if (read.commands.size() != 1) throw std::invalid_argument("type one number");
    return read.commands.front().number(0);
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
        opened_.clear();
        if (list.size() <= kMostCompared) opened_ = session::opened_commands(*session.opened, *now);
    }
    shown_ = now;
    shown_columns_ = columns;
    shown_unfolded_ = unfolded_.size();
}

void CommandsPanel::show_argument(Session& session, ArgumentAt at, const std::string& text) {
    const Command& command = commands(session).commands[at.command];
    const session::ArgumentInfo info = session::argument_info(command, at.argument);
    const Command* const before = opened_command(session, at.command);
    const bool is_new = !opened_.empty() && session::is_changed(before, command, at.argument);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::CalcTextSize(text.c_str()).x, ImGui::GetTextLineHeight()};

    if (typed_ == at) {  // shown after the row, over its text
        typed_x_ = from.x;
        typed_y_ = from.y;
        return;
    }
    ImGui::PushID(static_cast<int>(at.argument));
    const bool clicked = ImGui::InvisibleButton("argument", {std::max(size.x, 1.0f), size.y});
    const bool is_hovered = ImGui::IsItemHovered(), is_active = ImGui::IsItemActive();
    const bool is_editable = info.editing != Editing::kFixed;
    if (is_hovered) {
        is_over_part_ = true;
        help_ = fmt::format("{}: {}", info.name, session::argument_help(command, at.argument));
        if (info.editing == Editing::kNumber) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        if (info.editing == Editing::kName || info.editing == Editing::kBits || info.editing == Editing::kFlag)
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    if (is_editable && (is_hovered || dragged_ == at))
        ImGui::GetWindowDrawList()->AddRectFilled({from.x - 2, from.y}, {from.x + size.x + 2, from.y + size.y},
                                                  kArgumentHovered, 3);
    const ImU32 color = is_new ? kAccent : info.editing == Editing::kNumber ? kNumberColor : kNameColor;
    draw_code(from, color, text, is_new);

    if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) session.selected_command = last_selected_ = at.command;
    if (is_active && info.editing == Editing::kNumber) {
        const float dx = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, kDragThreshold).x;
        if (!dragged_ && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kDragThreshold)) {
            dragged_ = at;
            dragged_from_ = command.number(at.argument);
        }
        if (dragged_ == at) {
            const double step = step_of(info, dragged_from_);
            const double value = rounded_to_step(dragged_from_ + step * static_cast<double>(dx), step);
            const double legal = session::nearest_legal(command, at.argument, value);
            set_argument(session, at.command, at.argument, legal,
                         fmt::format("argument {} of {}", at.argument, at.command));
        }
    } else if (clicked) {
        if (info.editing == Editing::kNumber && !dragged_) {
            typed_ = at;
            typed_needs_focus_ = true;
            std::snprintf(typed_text_, sizeof typed_text_, "%s", text.c_str());
        } else if (info.editing == Editing::kFlag) {
            set_argument(session, at.command, at.argument, command.number(at.argument) == 0 ? 1 : 0);
        } else if (is_editable) {
            asked_ = at;
            choices_ = session::legal_choices(command, at.argument);
        }
    }
    if (!is_active && dragged_ == at) {
        dragged_.reset();
        session.history.end_group();
    }
    ImGui::PopID();
    if (clicked && asked_ == at && !choices_.empty()) to_open_ = "choices";
    if (is_hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
        asked_ = at;
        to_open_ = "argument menu";
    }
}

void CommandsPanel::show_input(Session& session) {
    const ArgumentAt at = *typed_;
    const float width = std::max(ImGui::CalcTextSize(typed_text_).x, at_scale(48)) + at_scale(12);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {3, 0});
    ImGui::SetNextItemWidth(width);
    const bool focus = std::exchange(typed_needs_focus_, false);
    if (focus) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText("##number", typed_text_, sizeof typed_text_,
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    const bool is_left = !focus && ImGui::IsItemDeactivated();
    ImGui::PopStyleVar();
    if (!entered && !is_left) return;
    typed_.reset();
    if (!entered && !ImGui::IsItemDeactivatedAfterEdit()) return;
    try {
        set_argument(session, at.command, at.argument, number_of(typed_text_));
    } catch (const std::exception& error) {
        say(session, error.what());
    }
}

void CommandsPanel::show_swatch(Session& session, ArgumentAt at) {
    const Command& command = commands(session).commands[at.command];
    const Kind kind = session::argument_info(command, at.argument).kind;
    const double full = is_real(kind) ? 1 : whole_range(kind).largest;
    float color[4] = {0, 0, 0, 1};
    std::size_t count = 0;
    while (count < 4 && at.argument + count < command.arguments.size()) {
        color[count] = static_cast<float>(command.number(at.argument + count) / full);
        ++count;
    }
    const float side = std::floor(ImGui::GetTextLineHeight() * 0.72f);
    const ImVec2 from = plus(ImGui::GetCursorScreenPos(), {1, std::floor((ImGui::GetTextLineHeight() - side) / 2)});
    ImGui::PushID(static_cast<int>(at.argument));
    const bool clicked = ImGui::InvisibleButton("swatch", {side + 2, ImGui::GetTextLineHeight()});
    const bool is_hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to = plus(from, {side, side});
    list.AddRectFilled(from, to, color_of({color[0], color[1], color[2]}), 2);
    list.AddRect(from, to, is_hovered ? kAccent : kSignColor, 2);
    if (is_hovered) {
        is_over_part_ = true;
        help_ = "click to choose the colour";
    }
    if (clicked) {
        asked_ = at;
        ImGui::OpenPopup("colour");
    }
    if (asked_ != at || !ImGui::BeginPopup("colour")) return;
    const ImGuiColorEditFlags flags = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoSidePreview;
    const bool changed =
        count == 4 ? ImGui::ColorPicker4("##picker", color, flags) : ImGui::ColorPicker3("##picker", color, flags);
    if (changed) {
        CommandList edited = commands(session);
        for (std::size_t i = 0; i < count; ++i) {
            const double value = rounded_to_step(static_cast<double>(color[i]), 0.001) * full;
            edited = session::with_argument(edited, at.command, at.argument + i, value);
        }
        edit(session, std::move(edited), std::string(command.name()) + ", colour",
             fmt::format("colour of {}", at.command));
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) session.history.end_group();
    ImGui::EndPopup();
}

// The gutter: folds glBegin, and moves calls by a drag.
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

void CommandsPanel::show_row(Session& session, const Row& row, int columns) {
    const std::shared_ptr<const CommandList> list = session.history.now();  // edits below must not free it
    const Command& command = list->commands[row.command];
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line_height = ImGui::GetTextLineHeightWithSpacing();
    const float width = ImGui::GetContentRegionAvail().x, height = line_height * static_cast<float>(row.lines);
    const float gutter = at_scale(kGutter), column_width = width_of_column();
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

    const bool clicked = ImGui::InvisibleButton("gutter", {gutter, line_height});
    const bool gutter_hovered = ImGui::IsItemHovered();
    drag_row(session, row, static_cast<double>(start.y) - row.top);
    is_over_part_ = gutter_hovered;
    if (gutter_hovered) {
        help_ = row.is_fold ? "click to fold or unfold; drag to move all up to glEnd" : "drag to move this call";
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

    constexpr int kInsideColumns = 4;
    if (row.is_inside) columns -= kInsideColumns;
    const float indent = row.is_inside ? kInsideColumns * column_width : 0;
    const Command* const before = opened_command(session, row.command);
    const bool is_other = !opened_.empty() && (!before || before->id != command.id);
    const ImVec2 text_start = plus(start, {gutter + indent, 0});
    for (const PlacedPiece& placed : placed_pieces(command, row.is_folded ? 1000 : columns)) {
        const ImVec2 at = plus(text_start, {static_cast<float>(placed.column) * column_width,
                                            static_cast<float>(placed.line) * line_height});
        ImGui::SetCursorScreenPos(at);
        const Piece& piece = placed.piece;
        if (piece.is_swatch)
            show_swatch(session, {row.command, *piece.argument});
        else if (piece.argument)
            show_argument(session, {row.command, *piece.argument}, piece.text);
        else if (placed.line == 0 && placed.column == 0)
            draw_code(at, is_other ? kAccent : kFunctionColor, piece.text, is_other);
        else
            draw_code(at, kSignColor, piece.text, false);
    }
    if (row.is_folded) {
        const std::string rest = fmt::format("  ... {} calls, glEnd();", row.count - 2);
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
        const std::string line = command.place.line > 0 ? fmt::format("line {}: ", command.place.line) : "";
        if (!is_wrong) help_ = line + command.sig().usage() + "  double click: edit as text; right click: menu";
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
    const int columns = std::max(20, static_cast<int>(room / column_width));
    refresh_rows(session, columns, static_cast<double>(line_height));
    if (session.selected_command != last_selected_) {
        last_selected_ = session.selected_command;
        scroll_to_selected_ = last_selected_.has_value();
    }
    if (std::exchange(scroll_to_selected_, false) && last_selected_)
        scroll_to(*last_selected_, static_cast<double>(ImGui::GetWindowHeight()));

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
        const std::string what = fmt::format("move {}", commands(session).commands[from].name());
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
        ImGui::BeginDisabled(!is_enabled);
        const bool pressed = ImGui::Button(label);
        ImGui::EndDisabled();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
        ImGui::SameLine();
        return pressed;
    };
    if (button("Undo", session.history.can_undo(), "undo the last edit (z)"))
        say(session, "undone: " + session.history.undo());
    if (button("Redo", session.history.can_redo(), "do it again (y)"))
        say(session, "done again: " + session.history.redo());
    const std::size_t count = has_selected ? session::end_of_group(*list, index) - index + 1 : 0;
    const std::string name = has_selected ? std::string(list->commands[index].name()) : "";
    if (button("Up", has_selected && index > 0, "move the selected call up")) move_call(session, index, false);
    if (button("Down", has_selected && index + count < list->commands.size(), "move the selected call down"))
        move_call(session, index, true);
    if (button("Delete", has_selected, "delete the selected call"))
        edit(session, session::without_command(*list, index, count), "delete " + name);
    if (button("Insert...", true, "insert a call after the selected one")) {
        replaced_.reset();
        inserted_text_[0] = '\0';
        insert_error_.clear();
        ImGui::OpenPopup("type a call");
    }
    show_insert(session);
    ImGui::NewLine();
}

void CommandsPanel::show_help(const Session& session) {
    ImGui::Separator();
    if (!session.error.empty() && help_.empty()) {
        colored_text(kBad, session.error);
    } else {
        dim_text(help_.empty() ? "Drag a number, or click it to type. Click a name to choose. Changed values are bold."
                               : help_);
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
    show_help(session);
}

}  // namespace twinlight::demo
