// The panel of calls: its menu of a right click, the list of legal names, and the line that takes a typed call.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string_view>

#include "app/demo/command_text.h"
#include "app/demo/panel_commands.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/edits.h"
#include "app/session/typed_calls.h"
#include "base/text/reason.h"
#include "base/text/translation.h"

namespace twinlight::demo {
namespace {

using session::Editing;
using session::Session;

// The calls that the insert menu offers.
constexpr const char* kTemplates[] = {
    "glEnable(GL_LIGHTING);",
    "glEnable(GL_LIGHT0);",
    "glEnable(GL_NORMALIZE);",
    "glEnable(GL_COLOR_MATERIAL);",
    "glDisable(GL_LIGHTING);",
    "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 2, 2, 1});",
    "glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){0, 0, 0, 1});",
    "glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});",
    "glLightfv(GL_LIGHT0, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});",
    "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, 0, -1});",
    "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);",
    "glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 10);",
    "glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1);",
    "glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1);",
    "glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.05);",
    "glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0.8, 0.8, 0.8, 1});",
    "glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, (GLfloat[]){0.2, 0.2, 0.2, 1});",
    "glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (GLfloat[]){0.8, 0.8, 0.8, 1});",
    "glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1});",
    "glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, (GLfloat[]){0, 0, 0, 1});",
    "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32);",
    "glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);",
    "glColor3f(1, 1, 1);",
    "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){0.2, 0.2, 0.2, 1});",
    "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);",
    "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);",
    "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);",
    "glShadeModel(GL_FLAT);",
    "glPushMatrix();",
    "glPopMatrix();",
    "glTranslatef(0, 0, 0);",
    "glRotatef(30, 0, 1, 0);",
    "glScalef(1, 1, 1);",
    "glLoadIdentity();",
    "gluLookAt(0, 2, 8, 0, 0, 0, 0, 1, 0);",
    "glutSolidSphere(1, 48, 24);",
    "glutSolidCube(1);",
    "glutSolidTorus(0.3, 0.8, 24, 48);",
    "glutSolidTeapot(1);",
    "glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);",
    "glFrontFace(GL_CW);",
};

}  // namespace

void CommandsPanel::show_argument_menu(Session& session) {
    if (!ImGui::BeginPopup("argument menu")) return;
    if (!asked_ || asked_->command >= commands(session).commands.size()) {
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
        return;
    }
    const std::shared_ptr<const CommandList> list = session.history.now();
    const std::size_t index = asked_->command, argument = asked_->argument;
    const Command& command = list->commands[index];
    const Command* const opened = opened_command(session, index);
    const auto printed = [&](double value) { return session::printed_argument(command, argument, value); };
    if (argument < command.arguments.size()) {
        const session::ArgumentInfo info = session::argument_info(command, argument);
        if (info.initial) {
            const std::string label = tr("Reset to GL's default: {}", printed(*info.initial));
            if (ImGui::MenuItem(label.c_str())) set_argument(session, index, argument, *info.initial);
        }
        if (opened && opened->id == command.id && argument < opened->arguments.size()) {
            const std::string label = tr("Reset to the file's value: {}", printed(opened->number(argument)));
            const bool differs = opened->number(argument) != command.number(argument);
            if (ImGui::MenuItem(label.c_str(), nullptr, false, differs))
                set_argument(session, index, argument, opened->number(argument));
        }
    }
    const Command defaults = session::with_initial_values(command);
    if (defaults != command && ImGui::MenuItem(tr("Reset the call to GL's defaults")))
        edit(session, session::with_command(*list, index, defaults), tr("reset {}", command.name()));
    if (opened && *opened != command && ImGui::MenuItem(tr("Reset the call to the file's")))
        edit(session, session::with_command(*list, index, *opened), tr("reset {}", command.name()));
    ImGui::Separator();
    const std::size_t count = session::end_of_group(*list, index) - index + 1;
    if (ImGui::MenuItem(tr("Move up"), nullptr, false, index > 0)) move_call(session, index, false);
    if (ImGui::MenuItem(tr("Move down"), nullptr, false, index + count < list->commands.size()))
        move_call(session, index, true);
    if (ImGui::MenuItem(tr(count > 1 ? "Duplicate all up to glEnd" : "Duplicate")))
        edit(session, session::with_duplicate(*list, index), tr("duplicate {}", command.name()));
    if (ImGui::MenuItem(tr(count > 1 ? "Delete all up to glEnd" : "Delete")))
        edit(session, session::without_command(*list, index, count), tr("delete {}", command.name()));
    ImGui::EndPopup();
}

void CommandsPanel::show_choices(Session& session) {
    if (!ImGui::BeginPopup("choices")) return;
    if (!asked_ || asked_->command >= commands(session).commands.size()) {
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
        return;
    }
    const Command command = commands(session).commands[asked_->command];
    const bool is_bits = session::argument_info(command, asked_->argument).editing == Editing::kBits;
    const double value = command.number(asked_->argument);
    const float line = is_bits ? ImGui::GetFrameHeightWithSpacing() : ImGui::GetTextLineHeightWithSpacing();
    const float height = std::min(static_cast<float>(choices_.size()), 16.0f) * line;
    float width = 0;
    for (const session::Choice& choice : choices_) width = std::max(width, ImGui::CalcTextSize(choice.name.c_str()).x);
    ImGui::BeginChild("names", {width + at_scale(is_bits ? 60 : 30), height}, false);
    for (const session::Choice& choice : choices_) {
        const auto bit = static_cast<std::uint32_t>(choice.value);
        if (is_bits) {
            bool on = (static_cast<std::uint32_t>(value) & bit) != 0;
            if (ImGui::Checkbox(choice.name.c_str(), &on))
                set_argument(session, asked_->command, asked_->argument,
                             static_cast<double>(static_cast<std::uint32_t>(value) ^ bit));
            continue;
        }
        const bool is_current = choice.value == value;
        if (ImGui::Selectable(choice.name.c_str(), is_current)) {
            set_argument(session, asked_->command, asked_->argument, choice.value);
            ImGui::CloseCurrentPopup();
        }
        // The help shows what a name means before it is clicked.
        if (ImGui::IsItemHovered())
            help_ = session::argument_help(session::changed_argument(command, asked_->argument, choice.value),
                                           asked_->argument);
        if (is_current && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
    ImGui::EndPopup();
}

// A call typed as C, or picked from common ones. It takes the place of `replaced_`, or goes after the selected call.
void CommandsPanel::show_insert(Session& session) {
    ImGui::SetNextWindowSize({at_scale(560), 0});
    if (!ImGui::BeginPopup("type a call")) return;
    if (ImGui::IsWindowAppearing()) insert_takes_focus_ = true;
    ImGui::PushFont(fonts().code);
    ImGui::SetNextItemWidth(-1);
    bool done = text_field("##call", tr("type a call, such as glEnable(GL_FOG);"), inserted_text_, insert_takes_focus_);
    if (!insert_error_.empty()) colored_text(kBad, insert_error_);
    if (!replaced_) {
        ImGui::BeginChild("templates", {0, at_scale(260)}, false);
        for (const char* text : kTemplates) {
            if (!session::has_text(text, inserted_text_)) continue;
            if (ImGui::Selectable(text)) {
                std::snprintf(inserted_text_, sizeof inserted_text_, "%s", text);
                done = true;
            }
        }
        ImGui::EndChild();
    }
    ImGui::PopFont();
    if (done) {
        try {
            session::insert_calls(session, inserted_text_, replaced_);
            insert_error_.clear();
            ImGui::CloseCurrentPopup();
        } catch (const std::exception& error) {
            insert_error_ = reason_of(error);
            insert_takes_focus_ = true;
        }
    }
    ImGui::EndPopup();
}

}  // namespace twinlight::demo
