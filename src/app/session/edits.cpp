#include "app/session/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "app/session/arguments.h"
#include "base/math/as_float.h"
#include "base/text/translation.h"
#include "judge/study/scene_of_choice.h"
#include "render/effect/plan.h"
#include "scene/command/command_set.h"
#include "scene/command/memory.h"
#include "scene/frame/parameter_rows.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

bool switches(const Command& command, Enum cap) {
    return (command.id == CommandId::glEnable || command.id == CommandId::glDisable) && command.enumerant(0) == cap;
}

bool sets_light_model(const Command& command, Enum pname) {
    constexpr CommandSet kSetters = CommandSet::of({"light_model"});
    return kSetters.contains(command.id) && command.enumerant(0) == pname && command.arguments.size() > 1;
}

bool starts_drawing(const Command& command) {
    constexpr CommandSet kDrawing = kDrawCommands | kListCommands;
    return kDrawing.contains(command.id);
}

bool is_initially_on(Enum cap) { return State().capability(cap).value_or(false); }

// The place of commands that the window made.
const std::shared_ptr<const std::string>& windows_file() {
    static const auto kFile = std::make_shared<const std::string>(tr("the window"));
    return kFile;
}

// Without the calls that keys inserted at the start and that now set GL's initial value, so that a key pressed twice leaves no trace.
template <class SetsInitialValue>
CommandList without_idle(CommandList commands, const SetsInitialValue& sets_initial_value) {
    auto& list = commands.commands;
    for (auto at = list.begin(); at != list.end() && at->place.file == windows_file();)
        at = sets_initial_value(*at) ? list.erase(at) : at + 1;
    return commands;
}

constexpr double kMostSlices = 10'000;

int scaled_count(int count, int steps) {
    constexpr int kFewest = 3;
    if (count <= 0) return count;  // draws nothing
    const int scaled = static_cast<int>(std::lround(count * std::pow(2, steps / 2.0)));
    if (steps > 0) return std::max(scaled, count + 1);
    return std::max(scaled, std::min(count, kFewest));
}

bool is_lit_by(const Draw& draw, std::size_t light) {
    const LightSources& lights = draw.lighting.lights;
    return light < lights.size() && lights[light].enabled;
}

// Whether GL_NORMALIZE changes no normal of this Draw: in eye space all have length 1 without it (2.11.3).
bool has_unit_normals(const Draw& draw) {
    constexpr double kRounding = 1e-5;  // matrices and normals may come from floats
    const glm::dmat3 to_eye(draw.eye_from_object);
    if (glm::determinant(to_eye) == 0) return false;
    const glm::dmat3 normal_matrix = glm::inverse(glm::transpose(to_eye));
    return std::ranges::all_of(draw.vertices, [&](const Vertex& vertex) {
        return std::abs(glm::length(normal_matrix * vertex.normal_object) - 1) <= kRounding;
    });
}

bool has_highlights(const Draw& draw) {
    if (!draw.lighting.enabled) return false;
    const Plan plan = plan_effects(draw, {});
    return plan.effects.any_light(&LightEffects::specular);
}

bool can_show_back_faces(const Frame& frame) {
    return std::ranges::any_of(frame.draws(), [](const Draw* draw) {
        return draw->lighting.enabled && draws_polygons(draw->mode) &&
               !(draw->raster.cull_enabled && draw->raster.cull_face != kGL_FRONT);
    });
}

// Whether the capability is on for any Draw.
bool is_on(const CommandList& commands, Enum cap) {
    State state;
    std::size_t seen = 0;
    for (const Command& command : commands.commands) {
        state.apply(command);
        for (; seen < state.items().size(); ++seen)
            if (std::holds_alternative<Draw>(state.items()[seen]) && state.capability(cap).value_or(false)) return true;
    }
    return false;
}

}  // namespace

double as_kind(double value, Kind kind) {
    if (kind == Kind::kDouble) return value;
    if (kind == Kind::kFloat) return as_float(value);
    if (kind == Kind::kBoolean) return value != 0 ? 1 : 0;
    const WholeRange range = whole_range(kind);
    return std::isnan(value) ? 0 : std::clamp(std::round(value), range.smallest, range.largest);
}

Command new_command(CommandId id, std::vector<double> arguments) {
    Command command{id, std::move(arguments), {windows_file(), 0, 0}};
    const std::vector<Parameter>& parameters = command.sig().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const std::size_t first = command.first(i);
        const std::size_t end = std::min(first + command.count(i), command.arguments.size());
        for (std::size_t at = first; at < end; ++at)
            command.arguments[at] = as_kind(command.arguments[at], parameters[i].kind);
    }
    return command;
}

// ---- What the keys do ----

CommandList toggle_capability(const CommandList& commands, Enum cap) {
    CommandList result = commands;
    bool found = false;
    for (Command& command : result.commands) {
        if (!switches(command, cap)) continue;
        command.id = command.id == CommandId::glEnable ? CommandId::glDisable : CommandId::glEnable;
        found = true;
    }
    const CommandId id = is_initially_on(cap) ? CommandId::glDisable : CommandId::glEnable;
    if (found) return without_idle(std::move(result), [&](const Command& c) { return switches(c, cap) && c.id != id; });
    return with_inserted(commands, 0, new_command(id, {static_cast<double>(cap)}));
}

CommandList toggle_light(const CommandList& commands, int light) {
    return toggle_capability(commands, kGL_LIGHT0 + static_cast<Enum>(light));
}

CommandList toggle_light_model(const CommandList& commands, Enum pname) {
    CommandList result = commands;
    bool found = false;
    for (Command& command : result.commands) {
        if (!sets_light_model(command, pname)) continue;
        command.arguments[1] = command.arguments[1] == 0 ? 1 : 0;
        found = true;
    }
    if (found)
        return without_idle(std::move(result),
                            [&](const Command& c) { return sets_light_model(c, pname) && c.arguments[1] == 0; });
    return with_inserted(commands, 0, new_command(CommandId::glLightModeli, {static_cast<double>(pname), 1}));
}

CommandList toggle_shade_model(const CommandList& commands) {
    const auto sets = [](const Command& command) { return command.id == CommandId::glShadeModel; };
    const auto first =
        std::ranges::find_if(commands.commands, [&](const Command& c) { return sets(c) || starts_drawing(c); });
    const bool starts_with_initial = first == commands.commands.end() || !sets(*first);
    const bool is_flat = !starts_with_initial && first->enumerant(0) == kGL_FLAT;
    const double other = is_flat ? kGL_SMOOTH : kGL_FLAT;
    CommandList result = commands;
    for (Command& command : result.commands)
        if (sets(command)) command.arguments[0] = other;
    if (starts_with_initial) return with_inserted(result, 0, new_command(CommandId::glShadeModel, {other}));
    return without_idle(std::move(result), [&](const Command& c) { return sets(c) && c.enumerant(0) == kGL_SMOOTH; });
}

// ---- Tessellation ----

CommandList change_tessellation(const CommandList& commands, int steps) {
    if (steps == 0) return commands;
    CommandList result = commands;
    for (Command& command : result.commands) {
        const study::SliceArguments slices = study::slice_arguments(command);
        double facets = 1;
        bool fits = true;
        Command changed = command;
        for (const std::size_t i : {slices.around, slices.across}) {
            if (i == 0) continue;
            changed.arguments.at(i) = scaled_count(static_cast<int>(command.number(i)), steps);
            facets *= std::max(1.0, changed.number(i));
            fits = fits && changed.number(i) <= kMostSlices;
        }
        if (steps < 0 || (fits && facets <= kMostShapeFacets)) command = std::move(changed);
    }
    return result;
}

std::string tessellation(const CommandList& commands) {
    std::vector<std::pair<int, int>> counts;
    for (const Command& command : commands.commands) {
        const study::SliceArguments slices = study::slice_arguments(command);
        if (slices.around == 0) continue;
        counts.emplace_back(static_cast<int>(command.number(slices.around)),
                            slices.across == 0 ? 0 : static_cast<int>(command.number(slices.across)));
    }
    if (counts.empty()) return "";
    const auto [least, most] = std::ranges::minmax(counts);
    const auto words = [](const std::pair<int, int>& count) {
        return count.second == 0 ? fmt::format("{}", count.first) : fmt::format("{} x {}", count.first, count.second);
    };
    return least == most ? words(least) : tr("{} to {}", words(least), words(most));
}

// ---- Single commands ----

CommandList with_argument(const CommandList& commands, std::size_t command, std::size_t argument, double value) {
    if (command >= commands.commands.size()) return commands;
    return with_command(commands, command, changed_argument(commands.commands[command], argument, value));
}

CommandList with_command(const CommandList& commands, std::size_t index, Command command) {
    CommandList result = commands;
    if (index < result.commands.size()) result.commands[index] = std::move(command);
    return result;
}

CommandList with_inserted(const CommandList& commands, std::size_t index, Command command) {
    CommandList result = commands;
    if (index <= result.commands.size())
        result.commands.insert(result.commands.begin() + static_cast<std::ptrdiff_t>(index), std::move(command));
    return result;
}

CommandList without_command(const CommandList& commands, std::size_t index, std::size_t count) {
    CommandList result = commands;
    if (index >= result.commands.size()) return result;
    const auto first = result.commands.begin() + static_cast<std::ptrdiff_t>(index);
    const auto left = result.commands.end() - first;
    result.commands.erase(first, first + std::min(static_cast<std::ptrdiff_t>(count), left));
    return result;
}

CommandList with_moved(const CommandList& commands, std::size_t from, std::size_t to, std::size_t count) {
    CommandList result = commands;
    const std::size_t size = result.commands.size();
    if (count > size || from > size - count || to > size - count) return result;
    const auto at = [&](std::size_t i) { return result.commands.begin() + static_cast<std::ptrdiff_t>(i); };
    if (to < from) std::rotate(at(to), at(from), at(from + count));
    if (to > from) std::rotate(at(from), at(from + count), at(to + count));
    return result;
}

std::size_t end_of_group(const CommandList& commands, std::size_t index) {
    if (index >= commands.commands.size() || commands.commands[index].id != CommandId::glBegin) return index;
    for (std::size_t i = index + 1; i < commands.commands.size(); ++i) {
        if (commands.commands[i].id == CommandId::glEnd) return i;
        if (commands.commands[i].id == CommandId::glBegin) break;
    }
    return index;
}

CommandList with_duplicate(const CommandList& commands, std::size_t index) {
    CommandList result = commands;
    if (index >= commands.commands.size()) return result;
    const std::size_t after = end_of_group(commands, index) + 1;
    for (std::size_t i = index; i < after; ++i) {
        const Command& command = commands.commands[i];
        Command copy = new_command(command.id, command.arguments);
        copy.memory = command.memory;
        result = with_inserted(result, after + (i - index), std::move(copy));
    }
    return result;
}

std::size_t index_above(const CommandList& commands, std::size_t index) {
    if (index == 0 || index >= commands.commands.size()) return index;
    if (commands.commands[index - 1].id == CommandId::glEnd)
        for (std::size_t i = index - 1; i-- > 0;)
            if (commands.commands[i].id == CommandId::glBegin)
                return end_of_group(commands, i) + 1 == index ? i : index - 1;
    return index - 1;
}

std::size_t index_below(const CommandList& commands, std::size_t index) {
    const std::size_t next = end_of_group(commands, index) + 1;
    if (next >= commands.commands.size()) return index;
    return index + end_of_group(commands, next) - next + 1;
}

std::vector<std::size_t> commands_of_draws(const CommandList& commands) {
    std::vector<std::size_t> result;
    State state;
    std::size_t seen = 0, begin = 0;
    for (std::size_t i = 0; i < commands.commands.size(); ++i) {
        const Command& command = commands.commands[i];
        if (command.id == CommandId::glBegin) begin = i;
        state.apply(command);
        for (; seen < state.items().size(); ++seen)
            if (std::holds_alternative<Draw>(state.items()[seen]))
                result.push_back(command.id == CommandId::glEnd ? begin : i);
    }
    return result;
}

// ---- What the user sees of it ----

bool is_black(const LightSource& light) {
    const auto black = [](const glm::dvec4& color) { return glm::dvec3(color) == glm::dvec3(0); };
    return black(light.ambient) && black(light.diffuse) && black(light.specular);
}

std::string what_light_shows(const Frame& frame, int light) {
    const std::string name = light_name(light);
    const auto number = static_cast<std::size_t>(light);
    bool is_on = false, is_used = false;
    const LightSource* source = nullptr;
    std::optional<LightBound> without_effect;
    for (const Draw* draw : frame.draws()) {
        if (!is_lit_by(*draw, number)) continue;
        is_on = true;
        if (!draw->lighting.enabled) continue;
        is_used = true;
        source = &draw->lighting.lights[number];
        const Plan plan = plan_effects(*draw, {});
        const auto bound = std::ranges::find(plan.light_bounds, light, &LightBound::number);
        const bool has_effect = bound == plan.light_bounds.end() || bound->in() ||
                                bound->fate == LightFate::kAmbientOnly || bound->fate == LightFate::kDisabled;
        if (has_effect && !is_black(*source)) return tr("{} is on", name);
        if (!without_effect && bound != plan.light_bounds.end()) without_effect = *bound;
    }
    if (!is_on) return tr("{} is off", name);
    if (!is_used) return tr("{} is on, but GL_LIGHTING is off", name);
    if (is_black(*source)) {
        return light == 0
                   ? tr("{} is on, but its colours are black", name)
                   : tr("{} is on, but its colours are black (only GL_LIGHT0 starts white); set its GL_DIFFUSE", name);
    }
    return tr("{} is on, but {}", name, without_effect ? reason(*without_effect) : tr("it lights nothing"));
}

std::string what_capability_shows(const CommandList& commands, const Frame& frame, Enum cap) {
    if (cap >= kGL_LIGHT0 && cap < kGL_LIGHT0 + kMaxLights)
        return what_light_shows(frame, static_cast<int>(cap - kGL_LIGHT0));
    const std::string name = enum_name(cap);
    const bool on = is_on(commands, cap);
    const auto lit = [](const Draw* draw) { return draw->lighting.enabled; };
    if (cap == kGL_LIGHTING)
        return on ? tr("{} is on", name) : tr("{} is off: every vertex has the colour that glColor gave it", name);
    if (cap == kGL_NORMALIZE) {
        const std::vector<const Draw*> draws = frame.draws();
        if (std::ranges::none_of(draws, lit))
            return on ? tr("{} is on, but nothing is lit", name) : tr("{} is off, but nothing is lit", name);
        const bool all_unit =
            std::ranges::all_of(draws, [&](const Draw* draw) { return !lit(draw) || has_unit_normals(*draw); });
        if (all_unit)
            return on ? tr("{} is on; all normals have length 1 anyway", name)
                      : tr("{} is off; all normals have length 1 anyway", name);
    }
    return on ? tr("{} is on", name) : tr("{} is off", name);
}

std::string what_light_model_shows(const Frame& frame, Enum pname) {
    const auto is_set = [&](const Draw* draw) {
        return values_of(draw->lighting.light_model, *find_parameter_row<LightModel>(pname)).front() != 0;
    };
    const std::vector<const Draw*> draws = frame.draws();
    const bool on = std::ranges::any_of(draws, is_set);
    const std::string words = on ? tr("{} is on", enum_name(pname)) : tr("{} is off", enum_name(pname));
    if (std::ranges::none_of(draws, [](const Draw* draw) { return draw->lighting.enabled; }))
        return words + tr(", but nothing is lit");
    if (pname == kGL_LIGHT_MODEL_LOCAL_VIEWER &&
        std::ranges::none_of(draws, [](const Draw* draw) { return has_highlights(*draw); }))
        return words + tr(", but nothing has a highlight");
    if (pname == kGL_LIGHT_MODEL_TWO_SIDE && !can_show_back_faces(frame))
        return words + tr(", but all back faces are culled");
    return words;
}

}  // namespace twinlight::session
