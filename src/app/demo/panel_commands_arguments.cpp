// The panel of calls: the arguments in a row. Numbers are dragged or typed, names and colours are chosen.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/demo/command_text.h"
#include "app/demo/panel_commands.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/edits.h"
#include "base/text/reason.h"
#include "base/text/translation.h"
#include "scene/command/memory.h"
#include "scene/command/text.h"

namespace twinlight::demo {
namespace {

using session::Editing;
using session::Session;

constexpr ImU32 kArgumentHovered = IM_COL32(255, 255, 255, 28);

// How far a pixel moves a number: more for large numbers, a tenth with Shift.
double step_of(const session::ArgumentInfo& info, double value) {
    double step = info.drag_speed;
    if (is_real(info.kind) && !info.is_color)
        for (double magnitude = 50; std::abs(value) >= magnitude; magnitude *= 10) step *= 10;
    return ImGui::GetIO().KeyShift ? step / 10 : step;
}

// The number that the text means: any constant expression of C. Throws SceneError.
double number_of(const std::string& text) {
    const CommandList read = read_scene("glTranslated(" + text + ", 0, 0);", tr("the number"), tr("the number"));
    if (read.commands.size() != 1) throw std::invalid_argument(tr("type one number"));
    return read.commands.front().number(0);
}

}  // namespace

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
    const bool is_left = !focus && ImGui::IsItemDeactivated(), is_changed = ImGui::IsItemDeactivatedAfterEdit();
    ImGui::PopStyleVar();
    if (!entered && !is_left) return;
    if (!entered && !is_changed) {
        typed_.reset();
        return;
    }
    try {
        const double number = number_of(typed_text_);
        typed_.reset();
        set_argument(session, at.command, at.argument, number);
    } catch (const std::exception& error) {
        say(session, reason_of(error));
        // After Enter, the next letters correct the number. After a click elsewhere, they are shortcuts.
        if (entered)
            typed_needs_focus_ = true;
        else
            typed_.reset();
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
        help_ = tr("click to choose the colour");
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
        edit(session, std::move(edited), tr("{}, colour", command.name()), fmt::format("colour of {}", at.command));
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) session.history.end_group();
    ImGui::EndPopup();
}

}  // namespace twinlight::demo
