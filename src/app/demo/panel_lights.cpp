#include "app/demo/panel_lights.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/demo/theme.h"
#include "app/demo/value_rows.h"
#include "app/session/edits.h"
#include "base/text/translation.h"
#include "scene/command/text.h"

namespace twinlight::demo {
namespace {

using session::SetBy;
using session::Source;

std::string text_of(const glm::dvec4& v) { return fmt::format("{:.4g}, {:.4g}, {:.4g}, {:.4g}", v.x, v.y, v.z, v.w); }
std::string text_of(const glm::dvec3& v) { return fmt::format("{:.4g}, {:.4g}, {:.4g}", v.x, v.y, v.z); }

// "point light, cone of 14 degrees"
std::string kind_of(const LightSource& light) {
    std::string kind = tr(light.is_directional() ? "directional" : "point");
    if (light.has_cutoff()) kind += tr(", cone of {:.4g} degrees", light.spot_cutoff_deg);
    if (light.is_attenuated()) kind += tr(", attenuated");
    return kind;
}

ImVec4 brightest(const LightSource& light) {
    const glm::dvec4& color = glm::dvec3(light.diffuse) == glm::dvec3(0) ? light.specular : light.diffuse;
    return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b), 1};
}

bool header(const char* title, bool is_open = true) {
    ImGui::PushFont(fonts().bold);
    const bool open =
        ImGui::CollapsingHeader(tr(title), is_open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    ImGui::PopFont();
    return open;
}

}  // namespace

void LightsPanel::refresh(const session::Session& session) {
    const std::shared_ptr<const CommandList> now = session.history.now();
    const bool is_new = now != shown_;
    if (is_new) drawing_ = session::drawing_commands(*now);
    const bool selects = session.selected_command && session.selected_command != selected_command_;
    if (drawing_.empty()) {
        values_.reset();
    } else if (is_new || selects || !values_) {
        if (selects) chosen_ = session::drawing_command_of(drawing_, *session.selected_command);
        // At first the first one that is lit.
        if (!shown_ && !selects)
            for (std::size_t i = drawing_.size(); i-- > 0;)
                if (drawing_[i].is_lit) chosen_ = i;
        chosen_ = std::min(chosen_, drawing_.size() - 1);
        values_ = session::lighting_values(*now, drawing_[chosen_].command);
        mesh_revision_ = -1;
    }
    selected_command_ = session.selected_command;
    shown_ = now;
    if (mesh_revision_ != session.revision && !drawing_.empty()) {
        mesh_error_ =
            session::mesh_error(session.scene.frame, drawing_[chosen_].first_draw, drawing_[chosen_].draw_count);
        mesh_revision_ = session.revision;
    }
}

void LightsPanel::label(session::Session& session, const char* text, const SetBy& by) const {
    ImGui::AlignTextToFramePadding();
    colored_text_line(kDim, tr(text));
    if (!ImGui::IsItemHovered()) return;
    const std::vector<Command>& list = commands(session).commands;
    if (!by.command || *by.command >= list.size()) {
        ImGui::SetTooltip("%s", tr("GL's initial value; a change inserts a call"));
        return;
    }
    const Command& command = list[*by.command];
    const std::string line = command.place.line > 0 ? tr("line {}: ", command.place.line) : "";
    ImGui::SetTooltip("%s%s\n%s", line.c_str(), print_command(command).c_str(), tr("click to show this call"));
    if (ImGui::IsItemClicked()) session.selected_command = by.command;
}

const SetBy& LightsPanel::set_by(int light, Enum pname) const {
    return values_->lights[static_cast<std::size_t>(light)].set_by_of(pname);
}

void LightsPanel::edit_light(session::Session& session, int light, Enum pname, const std::vector<double>& numbers) {
    edit(session, session::with_light_parameter(commands(session), *values_, light, pname, numbers),
         fmt::format("{}, {}", light_name(light), enum_name(pname)), fmt::format("light {} {}", light, pname));
}

void LightsPanel::edit_material(session::Session& session, Enum face, Enum pname, const std::vector<double>& numbers) {
    edit(session, session::with_material_parameter(commands(session), *values_, face, pname, numbers),
         "glMaterial, " + enum_name(pname), fmt::format("material {} {}", face, pname));
}

void LightsPanel::show_drawing(session::Session& session) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("Object"));
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##drawing", fitting_in_combo(drawing_[chosen_].name).c_str(), ImGuiComboFlags_HeightLarge))
        return;
    for (std::size_t i = 0; i < drawing_.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string name = drawing_[i].name + (drawing_[i].is_lit ? "" : tr("  (not lit)"));
        if (ImGui::Selectable(name.c_str(), i == chosen_)) session.selected_command = drawing_[i].command;
        if (i == chosen_ && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

// ---- Lights ----

void LightsPanel::show_light(session::Session& session, int light) {
    const LightSource& source = values_->lights[static_cast<std::size_t>(light)].stored;
    ImGui::PushID(light);
    bool on = source.enabled;
    if (ImGui::Checkbox("##on", &on)) {
        edit(session, session::toggle_light(commands(session), light), tr("switch {}", light_name(light)));
        session.selected_light = light;
    }
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", tr("glEnable({}); key {}", light_name(light), light + 1).c_str());
    ImGui::SameLine();
    const float side = ImGui::GetFrameHeight() * 0.7f;
    const float y = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(y + (ImGui::GetFrameHeight() - side) / 2);
    ImGui::ColorButton("colour", brightest(source), ImGuiColorEditFlags_NoTooltip, {side, side});
    ImGui::SameLine();
    ImGui::SetCursorPosY(y);

    if (session.selected_light == light && opened_light_ != light) {
        opened_light_ = light;
        ImGui::SetNextItemOpen(true);
        ImGui::SetScrollHereY(0.2f);
    }
    const std::string kind = !source.enabled             ? tr("off")
                             : session::is_black(source) ? tr("on, but black")
                                                         : kind_of(source);
    const ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_FramePadding |
                                     ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                     (session.selected_light == light ? ImGuiTreeNodeFlags_Selected : 0);
    ImGui::PushStyleColor(ImGuiCol_Text, source.enabled ? kText : kDim);
    const std::string name = light_name(light) + "  ";
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing();
    const std::string title = fitting({name + kind, name + kind.substr(0, kind.find(tr(", ")))}, room);
    const bool open = ImGui::TreeNodeEx("light", flags, "%s", title.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemClicked()) {
        session.selected_light = light;
        opened_light_ = light;
    }
    if (open) show_light_details(session, light);
    ImGui::PopID();
}

void LightsPanel::show_light_details(session::Session& session, int light) {
    const session::LightValues& values = values_->lights[static_cast<std::size_t>(light)];
    const LightSource& source = values.stored;
    std::vector<double> edited;

    const struct {
        const char* text;
        Enum pname;
        glm::dvec4 color;
    } colors[] = {{"ambient", kGL_AMBIENT, source.ambient},
                  {"diffuse", kGL_DIFFUSE, source.diffuse},
                  {"specular", kGL_SPECULAR, source.specular}};
    for (const auto& row : colors) {
        label(session, row.text, set_by(light, row.pname));
        begin_value();
        ImGui::PushID(row.text);
        if (color_edit("##colour", row.color, edited)) edit_light(session, light, row.pname, edited);
        ImGui::PopID();
        end_group_after_drag(session);
    }

    label(session, "position", set_by(light, kGL_POSITION));
    begin_value();
    if (vector_edit("##position", values.typed.position.value, edited, 0.02f))
        edit_light(session, light, kGL_POSITION, edited);
    end_group_after_drag(session);
    ImGui::SetCursorPosX(at_scale(kLabelWidth));
    dim_text(tr("in eye space: {}", text_of(source.position_eye)));
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s",
                          tr("the modelview matrix at the call, times what was typed (2.14.1); w = 0: a direction"));

    if (!source.is_directional()) {
        const struct {
            const char* text;
            Enum pname;
            double factor;
        } factors[] = {{"##k0", kGL_CONSTANT_ATTENUATION, source.constant_attenuation},
                       {"##k1", kGL_LINEAR_ATTENUATION, source.linear_attenuation},
                       {"##k2", kGL_QUADRATIC_ATTENUATION, source.quadratic_attenuation}};
        label(session, "attenuation", set_by(light, kGL_LINEAR_ATTENUATION));
        ImGui::SameLine(at_scale(kLabelWidth));
        const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
        const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
        for (const auto& row : factors) {
            if (row.pname != kGL_CONSTANT_ATTENUATION) ImGui::SameLine(0, gap);
            ImGui::SetNextItemWidth(width);
            auto factor = static_cast<float>(row.factor);
            if (ImGui::DragFloat(row.text, &factor, 0.002f, 0, 1000, kNumberFormat))
                edit_light(session, light, row.pname, {readable(std::max(factor, 0.0f))});
            end_group_after_drag(session);
            if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
                ImGui::SetTooltip("%s", tr("{} in 1 / (k0 + k1 d + k2 d d)", enum_name(row.pname)).c_str());
        }
    }
    show_spot(session, light);
    ImGui::Spacing();
}

void LightsPanel::show_spot(session::Session& session, int light) {
    const session::LightValues& values = values_->lights[static_cast<std::size_t>(light)];
    const LightSource& source = values.stored;
    std::vector<double> edited;
    double number = 0;
    constexpr double kNoCone = 180, kNewCone = 30;

    label(session, "cone", set_by(light, kGL_SPOT_CUTOFF));
    ImGui::SameLine(at_scale(kLabelWidth));
    bool is_spot = source.has_cutoff();
    if (ImGui::Checkbox("##cone", &is_spot))
        edit_light(session, light, kGL_SPOT_CUTOFF, {is_spot ? kNewCone : kNoCone});
    if (!is_spot || !source.has_cutoff()) return;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (number_edit("##cutoff", source.spot_cutoff_deg, 0, 90, tr("cutoff %.3g degrees"), number))
        edit_light(session, light, kGL_SPOT_CUTOFF, {number});
    end_group_after_drag(session);
    label(session, "exponent", set_by(light, kGL_SPOT_EXPONENT));
    begin_value();
    if (number_edit("##exponent", source.spot_exponent, 0, 128, kNumberFormat, number))
        edit_light(session, light, kGL_SPOT_EXPONENT, {number});
    end_group_after_drag(session);
    label(session, "direction", set_by(light, kGL_SPOT_DIRECTION));
    begin_value();
    if (vector_edit("##direction", values.typed.spot_direction.value, edited, 0.01f))
        edit_light(session, light, kGL_SPOT_DIRECTION, edited);
    end_group_after_drag(session);
    ImGui::SetCursorPosX(at_scale(kLabelWidth));
    dim_text(tr("in eye space: {}", text_of(source.spot_direction_eye)));
}

void LightsPanel::show(session::Session& session) {
    refresh(session);
    if (!values_) {
        dim_text(tr("Nothing is drawn, so nothing is lit."));
        return;
    }
    show_drawing(session);
    ImGui::PushID(static_cast<int>(chosen_));
    if (header("Lights"))
        for (int light = 0; light < kMaxLights; ++light) show_light(session, light);
    if (header("Material")) show_material(session);
    if (header("Light model and normals")) show_model(session);
    if (header("Colour material")) show_color_material(session);
    if (header("Mesh")) show_mesh(session);
    ImGui::PopID();
}

}  // namespace twinlight::demo
