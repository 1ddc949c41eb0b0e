// The panel of lights: the material, the light model, colour material and the mesh.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "app/demo/panel_lights.h"
#include "app/demo/theme.h"
#include "app/demo/value_rows.h"
#include "app/session/edits.h"
#include "app/session/presets.h"
#include "base/text/translation.h"
#include "judge/study/scene_of_choice.h"

namespace twinlight::demo {
namespace {

using session::SetBy;
using session::Source;

// The badge of a value that no glMaterial rules.
const char* badge_of(Source source) {
    switch (source) {
        case Source::kColor: return tr("from glColor");
        case Source::kOldColor: return tr("from an earlier glColor");
        case Source::kOther: return tr("from a list or glPopAttrib");
        case Source::kInitial:
        case Source::kCommand: return nullptr;
    }
    return nullptr;
}

}  // namespace

void LightsPanel::show_face(session::Session& session, Enum face) {
    const session::FaceValues& values = face == kGL_BACK ? values_->back : values_->front;
    const Enum edited_face =
        face == kGL_FRONT && !values_->state.light_model.two_side ? static_cast<Enum>(kGL_FRONT_AND_BACK) : face;
    const SetBy &ambient = values.set_by_of(kGL_AMBIENT), &diffuse = values.set_by_of(kGL_DIFFUSE);
    const bool is_joint = ambient.source == Source::kCommand && ambient.command == diffuse.command;
    struct Row {
        const char* text;
        Enum pname;
        glm::dvec4 color;
        const SetBy& by;
    };
    const Material& material = values.material;
    std::vector<Row> rows;
    if (is_joint) {
        rows.push_back({"ambient, diffuse", kGL_AMBIENT_AND_DIFFUSE, material.diffuse, diffuse});
    } else {
        rows.push_back({"ambient", kGL_AMBIENT, material.ambient, ambient});
        rows.push_back({"diffuse", kGL_DIFFUSE, material.diffuse, diffuse});
    }
    rows.push_back({"specular", kGL_SPECULAR, material.specular, values.set_by_of(kGL_SPECULAR)});
    rows.push_back({"emission", kGL_EMISSION, material.emission, values.set_by_of(kGL_EMISSION)});
    std::vector<double> edited;
    for (const Row& row : rows) {
        label(session, row.text, row.by);
        begin_value();
        ImGui::PushID(row.text);
        const bool is_tracked = row.by.source == Source::kColor;
        ImGui::BeginDisabled(is_tracked);
        if (color_edit("##colour", row.color, edited)) edit_material(session, edited_face, row.pname, edited);
        end_group_after_drag(session);
        ImGui::EndDisabled();
        if (const char* badge = badge_of(row.by.source)) {
            ImGui::SetCursorPosX(at_scale(kLabelWidth));
            colored_text_line(kAccent, badge);
        }
        ImGui::PopID();
    }
    label(session, "shininess", values.set_by_of(kGL_SHININESS));
    begin_value();
    double number = 0;
    if (number_edit("##shininess", material.shininess, 0, 128, kNumberFormat, number))
        edit_material(session, edited_face, kGL_SHININESS, {number});
    end_group_after_drag(session);
}

void LightsPanel::show_presets(session::Session& session) {
    ImGui::AlignTextToFramePadding();
    colored_text_line(kDim, tr("preset"));
    begin_value();
    if (!ImGui::BeginCombo("##preset", tr("gold, jade, ruby ..."), ImGuiComboFlags_HeightLarge)) return;
    for (const session::MaterialPreset& preset : session::material_presets()) {
        const auto part = [&](std::size_t i) {
            return static_cast<float>(std::min(1.0, preset.ambient[i] + preset.diffuse[i]));
        };
        ImGui::PushID(preset.name.data());
        const float side = ImGui::GetTextLineHeight();
        ImGui::ColorButton("colour", {part(0), part(1), part(2), 1}, ImGuiColorEditFlags_NoTooltip, {side, side});
        ImGui::SameLine();
        if (ImGui::Selectable(tr(preset.name).c_str())) {
            edit(session, session::with_preset(commands(session), drawing_[chosen_].command, preset),
                 tr("material {}", tr(preset.name)));
            say(session, tr("{} is now {}", drawing_[chosen_].name, tr(preset.name)));
        }
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void LightsPanel::show_material(session::Session& session) {
    show_presets(session);
    const bool has_two = values_->state.light_model.two_side;
    if (!has_two) return show_face(session, kGL_FRONT);
    if (!ImGui::BeginTabBar("faces")) return;
    for (const auto& [name, face] : {std::pair("Front", kGL_FRONT), {"Back", kGL_BACK}}) {
        if (!ImGui::BeginTabItem(tr(name))) continue;
        show_face(session, face);
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

// ---- Light model, colour material, mesh ----

void LightsPanel::show_model(session::Session& session) {
    const LightingState& state = values_->state;
    const LightModel& model = state.light_model;
    const auto capability = [&](const char* text, Enum cap, bool on) {
        if (ImGui::Checkbox(tr(text), &on))
            edit(session, session::toggle_capability(commands(session), cap), tr("switch {}", enum_name(cap)));
    };
    const auto of_model = [&](const char* text, Enum pname, bool on, const char* tip) {
        if (ImGui::Checkbox(tr(text), &on))
            edit(session, session::toggle_light_model(commands(session), pname), tr("switch {}", enum_name(pname)));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr(tip));
    };
    label(session, "ambient", values_->light_model_set_by(kGL_LIGHT_MODEL_AMBIENT));
    begin_value();
    std::vector<double> edited;
    if (color_edit("##ambient", model.ambient, edited))
        edit(session, session::with_light_model(commands(session), *values_, kGL_LIGHT_MODEL_AMBIENT, edited),
             "GL_LIGHT_MODEL_AMBIENT", "light model ambient");
    end_group_after_drag(session);

    const float half = ImGui::GetContentRegionAvail().x / 2;
    capability("GL_LIGHTING (l)", kGL_LIGHTING, state.enabled);
    ImGui::SameLine(half);
    bool is_flat = state.shade_model == kGL_FLAT;
    if (ImGui::Checkbox("GL_FLAT (f)", &is_flat))
        edit(session, session::toggle_shade_model(commands(session)), tr("switch {}", "glShadeModel"));
    of_model("local viewer (v)", kGL_LIGHT_MODEL_LOCAL_VIEWER, model.local_viewer,
             "highlights use the direction to the eye at each vertex, not (0, 0, 1); 2.14.1");
    ImGui::SameLine(half);
    of_model("two-sided (t)", kGL_LIGHT_MODEL_TWO_SIDE, model.two_side,
             "back faces use the back material and the reversed normal; 2.14.1");
    capability("GL_NORMALIZE (x)", kGL_NORMALIZE, state.normalize);
    ImGui::SameLine(half);
    capability("GL_RESCALE_NORMAL", kGL_RESCALE_NORMAL, state.rescale_normal);
    bool separate = model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    if (ImGui::Checkbox(tr("highlights after the texture"), &separate))
        edit(
            session,
            session::with_light_model(commands(session), *values_, kGL_LIGHT_MODEL_COLOR_CONTROL,
                                      {static_cast<double>(separate ? kGL_SEPARATE_SPECULAR_COLOR : kGL_SINGLE_COLOR)}),
            "GL_LIGHT_MODEL_COLOR_CONTROL");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("GL_SEPARATE_SPECULAR_COLOR; 2.14.1, 3.9");
}

void LightsPanel::show_color_material(session::Session& session) {
    const ColorMaterial& tracking = values_->state.color_material;
    bool on = tracking.enabled;
    if (ImGui::Checkbox("GL_COLOR_MATERIAL", &on))
        edit(session, session::toggle_capability(commands(session), kGL_COLOR_MATERIAL),
             tr("switch {}", "GL_COLOR_MATERIAL"));
    const bool has_effect = tracking.enabled && values_->state.enabled;
    colored_text(has_effect ? kAccent : kDim, session::color_material_words(*values_));

    const auto pick = [&](const char* text, Enum current, std::initializer_list<Enum> names, const auto& set) {
        label(session, text, values_->color_material_mode);
        begin_value();
        if (!ImGui::BeginCombo(fmt::format("##{}", text).c_str(), enum_name(current).c_str())) return;
        for (const Enum name : names)
            if (ImGui::Selectable(enum_name(name).c_str(), name == current)) set(name);
        ImGui::EndCombo();
    };
    const auto set = [&](Enum face, Enum mode) {
        edit(session, session::with_color_material(commands(session), *values_, face, mode), "glColorMaterial");
    };
    pick("face", tracking.face, {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK}, [&](Enum f) { set(f, tracking.mode); });
    pick("property", tracking.mode, {kGL_AMBIENT, kGL_DIFFUSE, kGL_AMBIENT_AND_DIFFUSE, kGL_SPECULAR, kGL_EMISSION},
         [&](Enum m) { set(tracking.face, m); });
}

void LightsPanel::show_mesh(session::Session& session) {
    const std::size_t index = drawing_[chosen_].command;
    const std::shared_ptr<const CommandList> list = session.history.now();
    const Command& command = list->commands[index];
    const study::SliceArguments slices = study::slice_arguments(command);
    if (slices.around == 0) {
        dim_text(tr("This call has no slices and stacks."));
    } else {
        const struct {
            const char* text;
            std::size_t argument;
        } rows[] = {{"around the axis", slices.around}, {"along it", slices.across}};
        for (const auto& row : rows) {
            if (row.argument == 0) continue;
            label(session, row.text, {Source::kCommand, index});
            begin_value();
            int count = static_cast<int>(command.number(row.argument));
            ImGui::PushID(row.text);
            if (ImGui::DragInt("##count", &count, 0.2f, 3, 500))
                edit(session, session::with_argument(*list, index, row.argument, std::max(count, 1)),
                     tr("{}, tessellation", command.name()), fmt::format("slices {} {}", index, row.argument));
            end_group_after_drag(session);
            ImGui::PopID();
        }
    }
    if (mesh_error_.has_surfaces)
        dim_text(tr("The mesh is at most {:.3g} away from the surface: {:.2g} % of its half width.",
                    mesh_error_.distance, 100 * mesh_error_.of_size));
    const std::string all = session::tessellation(*list);
    if (all.empty()) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("all shapes: {}", all).c_str());
    for (const auto& [text, steps] : {std::pair("coarser (-)", -1), {"finer (+)", 1}}) {
        ImGui::SameLine();
        if (ImGui::Button(tr(text)))
            edit(session, session::change_tessellation(*list, steps),
                 tr(steps > 0 ? "finer meshes" : "coarser meshes"));
    }
}

}  // namespace twinlight::demo
