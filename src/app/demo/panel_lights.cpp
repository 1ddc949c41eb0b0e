#include "app/demo/panel_lights.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/demo/theme.h"
#include "app/session/edits.h"
#include "app/session/presets.h"
#include "judge/study/scene_of_choice.h"
#include "scene/command/text.h"

namespace twinlight::demo {
namespace {

using session::SetBy;
using session::Source;

constexpr float kLabelWidth = 114;  // at scale 1
constexpr ImGuiColorEditFlags kColorFlags =
    ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoLabel;
constexpr const char* kNumber = "%.3g";

float at_scale(float pixels) { return pixels * static_cast<float>(scale()); }

// What a widget gives, without the digits that only floats have.
double readable(float value) { return std::round(static_cast<double>(value) * 1000) / 1000; }

void begin_value() {
    ImGui::SameLine(at_scale(kLabelWidth));
    ImGui::SetNextItemWidth(-1);
}

bool color_edit(const char* id, const glm::dvec4& color, std::vector<double>& edited) {
    float rgb[3] = {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
    if (!ImGui::ColorEdit3(id, rgb, kColorFlags)) return false;
    edited = {readable(rgb[0]), readable(rgb[1]), readable(rgb[2]), color.a};
    return true;
}

template <class Vector>
bool vector_edit(const char* id, const Vector& vector, std::vector<double>& edited, float speed) {
    constexpr int kCount = static_cast<int>(Vector::length());
    float numbers[4] = {};
    for (int i = 0; i < kCount; ++i) numbers[i] = static_cast<float>(vector[i]);
    if (!ImGui::DragScalarN(id, ImGuiDataType_Float, numbers, kCount, speed, nullptr, nullptr, kNumber)) return false;
    edited.clear();
    for (int i = 0; i < kCount; ++i) edited.push_back(readable(numbers[i]));
    return true;
}

bool number_edit(const char* id, double number, float smallest, float largest, const char* format, double& edited) {
    auto value = static_cast<float>(number);
    if (!ImGui::SliderFloat(id, &value, smallest, largest, format)) return false;
    edited = readable(value);
    return true;
}

std::string text_of(const glm::dvec4& v) { return fmt::format("{:.4g}, {:.4g}, {:.4g}, {:.4g}", v.x, v.y, v.z, v.w); }
std::string text_of(const glm::dvec3& v) { return fmt::format("{:.4g}, {:.4g}, {:.4g}", v.x, v.y, v.z); }

// "point light, cone of 14 degrees"
std::string kind_of(const LightSource& light) {
    std::string kind = light.position_eye.w == 0 ? "directional" : "point";
    if (light.spot_cutoff_deg != 180) kind += fmt::format(", cone of {:.4g} degrees", light.spot_cutoff_deg);
    if (light.position_eye.w != 0 && !light.has_initial_attenuation()) kind += ", attenuated";
    return kind;
}

bool is_black(const LightSource& light) {
    const glm::dvec3 sum = glm::dvec3(light.ambient) + glm::dvec3(light.diffuse) + glm::dvec3(light.specular);
    return sum == glm::dvec3(0);
}

ImVec4 brightest(const LightSource& light) {
    const glm::dvec4& color = glm::dvec3(light.diffuse) == glm::dvec3(0) ? light.specular : light.diffuse;
    return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b), 1};
}

// The badge of a value that no glMaterial rules.
const char* badge_of(Source source) {
    switch (source) {
        case Source::kColor: return "from glColor";
        case Source::kOldColor: return "from an earlier glColor";
        case Source::kOther: return "from a list or glPopAttrib";
        case Source::kInitial:
        case Source::kCommand: return nullptr;
    }
    return nullptr;
}

void end_group_after_drag(session::Session& session) {
    if (ImGui::IsItemDeactivatedAfterEdit()) session.history.end_group();
}

bool header(const char* title, bool is_open = true) {
    ImGui::PushFont(fonts().bold);
    const bool open =
        ImGui::CollapsingHeader(title, is_open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
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
    ImGui::PushStyleColor(ImGuiCol_Text, kDim);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    if (!ImGui::IsItemHovered()) return;
    const std::vector<Command>& list = commands(session).commands;
    if (!by.command || *by.command >= list.size()) {
        ImGui::SetTooltip("GL's initial value; a change inserts a call");
        return;
    }
    const Command& command = list[*by.command];
    const std::string line = command.place.line > 0 ? fmt::format("line {}: ", command.place.line) : "";
    ImGui::SetTooltip("%s%s\nclick to show this call", line.c_str(), print_command(command).c_str());
    if (ImGui::IsItemClicked()) session.selected_command = by.command;
}

const SetBy& LightsPanel::set_by(int light, Enum pname) const {
    const auto found = std::ranges::find(session::kLightPnames, pname);
    return values_->lights[static_cast<std::size_t>(light)]
        .set_by[static_cast<std::size_t>(found - session::kLightPnames.begin())];
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
    ImGui::TextUnformatted("What lights");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##drawing", drawing_[chosen_].name.c_str(), ImGuiComboFlags_HeightLarge)) return;
    for (std::size_t i = 0; i < drawing_.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string name = drawing_[i].name + (drawing_[i].is_lit ? "" : "  (not lit)");
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
        edit(session, session::toggle_light(commands(session), light), "switch " + light_name(light));
        session.selected_light = light;
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("glEnable(%s); key %d", light_name(light).c_str(), light + 1);
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
    const std::string kind = !source.enabled ? "off" : is_black(source) ? "on, but black" : kind_of(source);
    const ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_FramePadding |
                                     ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                     (session.selected_light == light ? ImGuiTreeNodeFlags_Selected : 0);
    ImGui::PushStyleColor(ImGuiCol_Text, source.enabled ? kText : kDim);
    const bool open = ImGui::TreeNodeEx("light", flags, "%s  %s", light_name(light).c_str(), kind.c_str());
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
    dim_text(fmt::format("stored in eye space: {}", text_of(source.position_eye)).c_str());
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("the modelview matrix at the call, times what was typed (2.14.1); w = 0: a direction");

    if (source.position_eye.w != 0) {
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
            if (ImGui::DragFloat(row.text, &factor, 0.002f, 0, 1000, kNumber))
                edit_light(session, light, row.pname, {readable(std::max(factor, 0.0f))});
            end_group_after_drag(session);
            if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
                ImGui::SetTooltip("%s in 1 / (k0 + k1 d + k2 d d)", enum_name(row.pname).c_str());
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
    bool is_spot = source.spot_cutoff_deg != kNoCone;
    if (ImGui::Checkbox("##cone", &is_spot))
        edit_light(session, light, kGL_SPOT_CUTOFF, {is_spot ? kNewCone : kNoCone});
    if (!is_spot || source.spot_cutoff_deg == kNoCone) return;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (number_edit("##cutoff", source.spot_cutoff_deg, 0, 90, "cutoff %.3g degrees", number))
        edit_light(session, light, kGL_SPOT_CUTOFF, {number});
    end_group_after_drag(session);
    label(session, "exponent", set_by(light, kGL_SPOT_EXPONENT));
    begin_value();
    if (number_edit("##exponent", source.spot_exponent, 0, 128, kNumber, number))
        edit_light(session, light, kGL_SPOT_EXPONENT, {number});
    end_group_after_drag(session);
    label(session, "direction", set_by(light, kGL_SPOT_DIRECTION));
    begin_value();
    if (vector_edit("##direction", values.typed.spot_direction.value, edited, 0.01f))
        edit_light(session, light, kGL_SPOT_DIRECTION, edited);
    end_group_after_drag(session);
    ImGui::SetCursorPosX(at_scale(kLabelWidth));
    dim_text(fmt::format("stored in eye space: {}", text_of(source.spot_direction_eye)).c_str());
}

// ---- Material ----

void LightsPanel::show_face(session::Session& session, Enum face) {
    const session::FaceValues& values = face == kGL_BACK ? values_->back : values_->front;
    const Enum edited_face =
        face == kGL_FRONT && !values_->state.light_model.two_side ? static_cast<Enum>(kGL_FRONT_AND_BACK) : face;
    const SetBy &ambient = values.set_by[0], &diffuse = values.set_by[1];
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
    rows.push_back({"specular", kGL_SPECULAR, material.specular, values.set_by[2]});
    rows.push_back({"emission", kGL_EMISSION, material.emission, values.set_by[3]});
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
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", badge);
        }
        ImGui::PopID();
    }
    label(session, "shininess", values.set_by[4]);
    begin_value();
    double number = 0;
    if (number_edit("##shininess", material.shininess, 0, 128, kNumber, number))
        edit_material(session, edited_face, kGL_SHININESS, {number});
    end_group_after_drag(session);
}

void LightsPanel::show_presets(session::Session& session) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, kDim);
    ImGui::TextUnformatted("preset");
    ImGui::PopStyleColor();
    begin_value();
    if (!ImGui::BeginCombo("##preset", "gold, jade, ruby ...", ImGuiComboFlags_HeightLarge)) return;
    for (const session::MaterialPreset& preset : session::material_presets()) {
        const auto part = [&](std::size_t i) {
            return static_cast<float>(std::min(1.0, preset.ambient[i] + preset.diffuse[i]));
        };
        ImGui::PushID(preset.name.data());
        const float side = ImGui::GetTextLineHeight();
        ImGui::ColorButton("colour", {part(0), part(1), part(2), 1}, ImGuiColorEditFlags_NoTooltip, {side, side});
        ImGui::SameLine();
        if (ImGui::Selectable(std::string(preset.name).c_str())) {
            edit(session, session::with_preset(commands(session), drawing_[chosen_].command, preset),
                 "material " + std::string(preset.name));
            say(session, fmt::format("{} is now {}", drawing_[chosen_].name, preset.name));
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
        if (!ImGui::BeginTabItem(name)) continue;
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
        if (ImGui::Checkbox(text, &on))
            edit(session, session::toggle_capability(commands(session), cap), "switch " + enum_name(cap));
    };
    const auto of_model = [&](const char* text, Enum pname, bool on, const char* tip) {
        if (ImGui::Checkbox(text, &on))
            edit(session, session::toggle_light_model(commands(session), pname), "switch " + enum_name(pname));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
    };
    label(session, "ambient", values_->ambient);
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
        edit(session, session::toggle_shade_model(commands(session)), "switch glShadeModel");
    of_model("local viewer (v)", kGL_LIGHT_MODEL_LOCAL_VIEWER, model.local_viewer,
             "highlights use the direction to the eye at each vertex, not (0, 0, 1); 2.14.1");
    ImGui::SameLine(half);
    of_model("two-sided (t)", kGL_LIGHT_MODEL_TWO_SIDE, model.two_side,
             "back faces use the back material and the reversed normal; 2.14.1");
    capability("GL_NORMALIZE (x)", kGL_NORMALIZE, state.normalize);
    ImGui::SameLine(half);
    capability("GL_RESCALE_NORMAL", kGL_RESCALE_NORMAL, state.rescale_normal);
    bool separate = model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    if (ImGui::Checkbox("highlights after the texture", &separate))
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
        edit(session, session::toggle_capability(commands(session), kGL_COLOR_MATERIAL), "switch GL_COLOR_MATERIAL");
    const std::string words = session::color_material_words(*values_);
    const bool has_effect = tracking.enabled && values_->state.enabled;
    ImGui::PushStyleColor(ImGuiCol_Text, has_effect ? kAccent : kDim);
    ImGui::TextWrapped("%s", words.c_str());
    ImGui::PopStyleColor();

    label(session, "glColorMaterial", values_->color_material_mode);
    ImGui::SameLine(at_scale(kLabelWidth));
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    const auto pick = [&](const char* id, Enum current, std::initializer_list<Enum> names, const auto& set) {
        ImGui::SetNextItemWidth(width);
        if (!ImGui::BeginCombo(id, enum_name(current).c_str())) return;
        for (const Enum name : names)
            if (ImGui::Selectable(enum_name(name).c_str(), name == current)) set(name);
        ImGui::EndCombo();
    };
    const auto set = [&](Enum face, Enum mode) {
        edit(session, session::with_color_material(commands(session), *values_, face, mode), "glColorMaterial");
    };
    pick("##face", tracking.face, {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK}, [&](Enum f) { set(f, tracking.mode); });
    ImGui::SameLine();
    pick("##mode", tracking.mode, {kGL_AMBIENT, kGL_DIFFUSE, kGL_AMBIENT_AND_DIFFUSE, kGL_SPECULAR, kGL_EMISSION},
         [&](Enum m) { set(tracking.face, m); });
}

void LightsPanel::show_mesh(session::Session& session) {
    const std::size_t index = drawing_[chosen_].command;
    const std::shared_ptr<const CommandList> list = session.history.now();
    const Command& command = list->commands[index];
    const study::SliceArguments slices = study::slice_arguments(command);
    if (slices.around == 0) {
        dim_text("This call has no slices and stacks.");
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
                     std::string(command.name()) + ", tessellation", fmt::format("slices {} {}", index, row.argument));
            end_group_after_drag(session);
            ImGui::PopID();
        }
    }
    if (mesh_error_.has_surfaces)
        dim_text(fmt::format("The mesh is at most {:.3g} away from the surface: {:.2g} % of its half width.",
                             mesh_error_.distance, 100 * mesh_error_.of_size)
                     .c_str());
    const std::string all = session::tessellation(*list);
    if (all.empty()) return;
    ImGui::AlignTextToFramePadding();
    ImGui::Text("all shapes: %s", all.c_str());
    for (const auto& [text, steps] : {std::pair("coarser (-)", -1), {"finer (+)", 1}}) {
        ImGui::SameLine();
        if (ImGui::Button(text))
            edit(session, session::change_tessellation(*list, steps), steps > 0 ? "finer meshes" : "coarser meshes");
    }
}

void LightsPanel::show(session::Session& session) {
    refresh(session);
    if (!values_) {
        dim_text("Nothing is drawn, so nothing is lit.");
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
