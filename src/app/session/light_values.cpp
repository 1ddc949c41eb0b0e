#include "app/session/light_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/session/edits.h"
#include "base/text/translation.h"
#include "scene/command/command_set.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

constexpr CommandSet kSetsLight = CommandSet::of({"light"});
constexpr CommandSet kSetsMaterial = CommandSet::of({"material"});
constexpr CommandSet kSetsLightModel = CommandSet::of({"light_model"});
constexpr CommandSet kSetsColor = CommandSet::of({"color"});

bool tracks_color(const LightingState& state, Enum face, Enum pname) {
    const ColorMaterial& tracking = state.color_material;
    const bool has_face = tracking.face == face || tracking.face == kGL_FRONT_AND_BACK;
    const bool is_both = tracking.mode == kGL_AMBIENT_AND_DIFFUSE && (pname == kGL_AMBIENT || pname == kGL_DIFFUSE);
    return tracking.enabled && has_face && (tracking.mode == pname || is_both);
}

// Follows which command set each value.
struct Origins : ValueOrigins {
    void set_color(const LightingState& state, std::size_t command) {
        for (const auto& [face, values] : {std::pair(kGL_FRONT, &front), {kGL_BACK, &back}})
            for (std::size_t i = 0; i < kMaterialParameters.size(); ++i)
                if (tracks_color(state, face, kMaterialParameters[i].pname))
                    values->set_by[i] = {Source::kOldColor, command};
    }

    void set_material(const Command& command, const LightingState& state, std::size_t index) {
        const Enum given = command.enumerant(0), pname = command.enumerant(1);
        for (const auto& [face, values] : {std::pair(kGL_FRONT, &front), {kGL_BACK, &back}}) {
            if (given != face && given != kGL_FRONT_AND_BACK) continue;
            for (std::size_t i = 0; i < kMaterialParameters.size(); ++i) {
                const Enum here = kMaterialParameters[i].pname;
                const bool sets =
                    pname == here || (pname == kGL_AMBIENT_AND_DIFFUSE && (here == kGL_AMBIENT || here == kGL_DIFFUSE));
                if (sets && !tracks_color(state, face, here)) values->set_by[i] = {Source::kCommand, index};
            }
        }
    }

    // For a command of the scene itself. `state` is that after the command.
    void follow(const Command& command, const LightingState& state, std::size_t index) {
        const SetBy here{Source::kCommand, index};
        if (kSetsLight.contains(command.id)) {
            const Enum light = command.enumerant(0) - kGL_LIGHT0;
            const std::size_t number = number_of_parameter<LightSource>(command.enumerant(1));
            if (light < kMaxLights && number < kLightParameters.size()) lights[light].set_by[number] = here;
        } else if (kSetsMaterial.contains(command.id)) {
            set_material(command, state, index);
        } else if (kSetsLightModel.contains(command.id)) {
            const std::size_t number = number_of_parameter<LightModel>(command.enumerant(0));
            if (number < light_model.size()) light_model[number] = here;
        } else if (command.id == CommandId::glColorMaterial) {
            color_material_mode = here;
            set_color(state, index);
        } else if (command.id == CommandId::glEnable || command.id == CommandId::glDisable) {
            const Enum cap = command.enumerant(0);
            if (cap >= kGL_LIGHT0 && cap < kGL_LIGHT0 + kMaxLights) lights[cap - kGL_LIGHT0].enabled = here;
            if (cap == kGL_COLOR_MATERIAL) {
                color_material = here;
                set_color(state, index);
            }
        } else if (kSetsColor.contains(command.id)) {
            set_color(state, index);
        }
    }

    // The values that differ between two states are those of `origin`, or were set by `other` if that is null.
    void take_changed(const LightingState& before, const LightingState& after, const Origins* origin, SetBy other) {
        const auto take = [&](bool is_changed, SetBy& of, const SetBy* from) {
            if (is_changed) of = from ? *from : other;
        };
        const auto take_all = [&](const auto& a, const auto& b, auto& of, const auto* from) {
            const auto rows = kParameterRows<std::remove_cvref_t<decltype(a)>>;
            for (std::size_t i = 0; i < rows.size(); ++i)
                take(!has_equal(a, b, rows[i]), of[i], from ? &(*from)[i] : nullptr);
        };
        for (std::size_t l = 0; l < lights.size(); ++l) {
            const LightSource &a = before.lights[l], &b = after.lights[l];
            take_all(a, b, lights[l].set_by, origin ? &origin->lights[l].set_by : nullptr);
            take(a.enabled != b.enabled, lights[l].enabled, origin ? &origin->lights[l].enabled : nullptr);
        }
        take_all(before.front, after.front, front.set_by, origin ? &origin->front.set_by : nullptr);
        take_all(before.back, after.back, back.set_by, origin ? &origin->back.set_by : nullptr);
        take_all(before.light_model, after.light_model, light_model, origin ? &origin->light_model : nullptr);
        const ColorMaterial &a = before.color_material, &b = after.color_material;
        take(a.enabled != b.enabled, color_material, origin ? &origin->color_material : nullptr);
        take(a.mode != b.mode || a.face != b.face, color_material_mode,
             origin ? &origin->color_material_mode : nullptr);
    }
};

std::string line_of(const Command& command) {
    const Place& place = command.place;
    if (place.column == Place::kCallNumber) return tr(", call {}", place.line);
    return place.line > 0 ? tr(", line {}", place.line) : "";
}

std::string name_of_drawing(const Command& command) {
    if (command.id == CommandId::glBegin) return fmt::format("glBegin({})", primitive_name(command.enumerant(0)));
    if (command.id == CommandId::pragma_shape) return fmt::format("shape({})", word_name(command.word(0)));
    return std::string(command.name());
}

// Applies the command at `index`, and for glBegin all up to glEnd. Returns the index of the next command.
std::size_t apply_group(State& state, const CommandList& commands, std::size_t index) {
    const std::size_t last = end_of_group(commands, index);
    for (std::size_t i = index; i <= last; ++i) state.apply(commands.commands[i]);
    return last + 1;
}

// The command with other values, in its own form; colours as integers become floats.
Command with_values(const Command& command, std::size_t first, const std::vector<double>& values) {
    const bool is_light = kSetsLight.contains(command.id);
    std::vector<double> arguments(command.arguments.begin(),
                                  command.arguments.begin() + static_cast<std::ptrdiff_t>(first));
    arguments.insert(arguments.end(), values.begin(), values.end());
    const CommandId many = is_light ? CommandId::glLightfv : CommandId::glMaterialfv;
    const CommandId one = is_light ? CommandId::glLightf : CommandId::glMaterialf;
    const bool is_float = command.id == many || command.id == one;
    Command result = new_command(is_float ? command.id : values.size() == 1 ? one : many, std::move(arguments));
    result.place = command.place;
    return result;
}

}  // namespace

std::vector<DrawingCommand> drawing_commands(const CommandList& commands) {
    std::vector<DrawingCommand> result;
    State state;
    std::size_t seen = 0, draws = 0, next = 0;
    for (std::size_t i = 0; i < commands.commands.size(); i = next) {
        next = apply_group(state, commands, i);
        std::size_t added = 0;
        bool is_lit = false;
        for (; seen < state.items().size(); ++seen) {
            const Draw* const draw = std::get_if<Draw>(&state.items()[seen]);
            if (!draw) continue;
            if (added == 0) is_lit = draw->lighting.enabled;
            ++added;
        }
        if (added == 0) continue;
        const Command& command = commands.commands[i];
        result.push_back({i, draws, added, is_lit, name_of_drawing(command) + line_of(command)});
        draws += added;
    }
    return result;
}

std::size_t drawing_command_of(const std::vector<DrawingCommand>& drawing, std::size_t command) {
    for (std::size_t i = 0; i < drawing.size(); ++i) {
        const bool is_last = i + 1 == drawing.size();
        if (drawing[i].command >= command || is_last || drawing[i + 1].command > command) {
            // Between two that draw, a command belongs to the later one; inside glBegin to that.
            const bool is_after = drawing[i].command < command && !is_last;
            return is_after ? i + 1 : i;
        }
    }
    return 0;
}

std::optional<LightingValues> lighting_values(const CommandList& commands, std::size_t drawing_command) {
    if (drawing_command >= commands.commands.size()) return std::nullopt;
    constexpr CommandSet kIndirect = CommandSet::of({"call_list", "call_lists", "pop_attrib"});
    constexpr CommandSet kPush = CommandSet::of({"push_attrib"});
    State state;
    Origins origins;
    std::vector<Origins> saved;
    LightingValues values;
    for (std::size_t i = 0; i < drawing_command; ++i) {
        const Command& command = commands.commands[i];
        const std::size_t depth = state.attribute_depth();
        if (kIndirect.contains(command.id)) {
            const LightingState before = state.lighting();
            state.apply(command);
            const bool pops = state.attribute_depth() < depth && !saved.empty();
            origins.take_changed(before, state.lighting(), pops ? &saved.back() : nullptr, {Source::kOther, i});
            if (pops) saved.pop_back();
            continue;
        }
        if (kPush.contains(command.id)) saved.push_back(origins);
        state.apply(command);
        if (kPush.contains(command.id) && state.attribute_depth() == depth) saved.pop_back();  // it was an error
        origins.follow(command, state.lighting(), i);
        if (kSetsColor.contains(command.id)) values.color_command = i;
    }
    const std::size_t before = state.items().size();
    apply_group(state, commands, drawing_command);
    const Frame frame = state.take_frame();
    const auto draw =
        std::find_if(frame.items.begin() + static_cast<std::ptrdiff_t>(std::min(before, frame.items.size())),
                     frame.items.end(), [](const auto& item) { return std::holds_alternative<Draw>(item); });
    if (draw == frame.items.end()) return std::nullopt;
    const Draw& first = std::get<Draw>(*draw);

    const Command& command = commands.commands[drawing_command];
    values.drawing = {drawing_command, 0, 1, first.lighting.enabled, name_of_drawing(command) + line_of(command)};
    values.state = first.lighting;
    static_cast<ValueOrigins&>(values) = std::move(origins);
    for (std::size_t l = 0; l < values.lights.size(); ++l) {
        values.lights[l].stored = first.lighting.lights[l];
        values.lights[l].typed = frame.typed_lights.at(first.lighting.lights[l].typed);
    }
    values.front.material = first.lighting.front;
    values.back.material = first.lighting.back;
    for (const auto& [face, of] : {std::pair(kGL_FRONT, &values.front), {kGL_BACK, &values.back}}) {
        for (std::size_t i = 0; i < kMaterialParameters.size(); ++i) {
            const ParameterRow<Material>& row = kMaterialParameters[i];
            if (!tracks_color(first.lighting, face, row.pname)) continue;
            of->set_by[i] = {Source::kColor, values.color_command};
            const glm::dvec4 color = first.vertices.empty() ? glm::dvec4(1) : first.vertices.front().color;
            set_parameter(of->material, row, std::span(&color[0], 4));
        }
    }
    return values;
}

std::string color_material_words(const LightingValues& values) {
    const ColorMaterial& tracking = values.state.color_material;
    const bool is_colored = values.color_command.has_value();
    if (!values.state.enabled) return tr("not lit: the colour is that of glColor");
    if (!tracking.enabled)
        return tr(is_colored ? "glColor has no effect here, because GL_COLOR_MATERIAL is off"
                             : "off: glMaterial rules");
    const char* const faces = tr(tracking.face == kGL_FRONT_AND_BACK ? "both faces"
                                 : tracking.face == kGL_FRONT        ? "the front"
                                                                     : "the back");
    return tracking.mode == kGL_AMBIENT_AND_DIFFUSE
               ? tr("GL_AMBIENT and GL_DIFFUSE of {} follow glColor; glMaterial cannot change them", faces)
               : tr("{} of {} follows glColor; glMaterial cannot change it", enum_name(tracking.mode), faces);
}

// ---- Edits ----

CommandList with_light_parameter(const CommandList& commands, const LightingValues& values, int light, Enum pname,
                                 const std::vector<double>& numbers) {
    if (light < 0 || light >= kMaxLights || !find_parameter_row<LightSource>(pname)) return commands;
    const LightValues& of = values.lights[static_cast<std::size_t>(light)];
    const SetBy& set_by = of.set_by_of(pname);
    if (set_by.source == Source::kCommand)
        return with_command(commands, *set_by.command, with_values(commands.commands[*set_by.command], 2, numbers));
    // Where the light's other parameters are set, or else where it is enabled: with the same modelview matrix.
    std::size_t index = 0;
    for (const SetBy& other : of.set_by)
        if (other.source == Source::kCommand) index = std::max(index, *other.command + 1);
    if (index == 0 && of.enabled.source == Source::kCommand) index = *of.enabled.command;
    std::vector<double> arguments{static_cast<double>(kGL_LIGHT0) + light, static_cast<double>(pname)};
    arguments.insert(arguments.end(), numbers.begin(), numbers.end());
    const CommandId id = numbers.size() == 1 ? CommandId::glLightf : CommandId::glLightfv;
    return with_inserted(commands, index, new_command(id, std::move(arguments)));
}

CommandList with_material_parameter(const CommandList& commands, const LightingValues& values, Enum face, Enum pname,
                                    const std::vector<double>& numbers) {
    const Enum looked_up = pname == kGL_AMBIENT_AND_DIFFUSE ? kGL_DIFFUSE : pname;
    if (!find_parameter_row<Material>(looked_up)) return commands;
    const FaceValues& of = face == kGL_BACK ? values.back : values.front;
    const SetBy& set_by = of.set_by_of(looked_up);
    std::size_t index = values.drawing.command;
    if (set_by.source == Source::kCommand) {
        const Command& command = commands.commands[*set_by.command];
        if (command.enumerant(1) == pname)
            return with_command(commands, *set_by.command, with_values(command, 2, numbers));
        index = *set_by.command + 1;
        face = command.enumerant(0);
    }
    std::vector<double> arguments{static_cast<double>(face), static_cast<double>(pname)};
    arguments.insert(arguments.end(), numbers.begin(), numbers.end());
    const CommandId id = numbers.size() == 1 ? CommandId::glMaterialf : CommandId::glMaterialfv;
    return with_inserted(commands, index, new_command(id, std::move(arguments)));
}

CommandList with_light_model(const CommandList& commands, const LightingValues& values, Enum pname,
                             const std::vector<double>& numbers) {
    std::vector<double> arguments{static_cast<double>(pname)};
    arguments.insert(arguments.end(), numbers.begin(), numbers.end());
    Command call =
        new_command(numbers.size() == 1 ? CommandId::glLightModeli : CommandId::glLightModelfv, std::move(arguments));
    const SetBy& by = values.light_model_set_by(pname);
    if (by.source != Source::kCommand) return with_inserted(commands, 0, std::move(call));
    call.place = commands.commands[*by.command].place;
    return with_command(commands, *by.command, std::move(call));
}

CommandList with_color_material(const CommandList& commands, const LightingValues& values, Enum face, Enum mode) {
    Command call = new_command(CommandId::glColorMaterial, {static_cast<double>(face), static_cast<double>(mode)});
    const SetBy& by = values.color_material_mode;
    if (by.source != Source::kCommand) return with_inserted(commands, values.color_material.command.value_or(0), call);
    call.place = commands.commands[*by.command].place;
    return with_command(commands, *by.command, std::move(call));
}

}  // namespace twinlight::session
