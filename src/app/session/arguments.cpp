#include "app/session/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "app/session/argument_places.h"
#include "app/session/edits.h"
#include "app/session/initial_values.h"
#include "base/text/translation.h"
#include "scene/command/command_set.h"
#include "scene/command/memory.h"
#include "scene/command/print_parts.h"
#include "scene/frame/parameter_rows.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// ---- Ranges and kinds ----

// The range of an argument by effect and parameter (an empty name: all of them).
struct RangeRow {
    std::string_view effect, parameter;
    double smallest, largest;
    bool is_clamped;
};
constexpr double kSmallestAboveZero = 0.001;
constexpr RangeRow kRanges[] = {
    {"clear_color", "", 0, 1, true},
    {"clear_depth", "", 0, 1, true},
    {"depth_range", "", 0, 1, true},
    {"blend_color", "", 0, 1, true},
    {"alpha_func", "ref", 0, 1, true},
    {"line_stipple", "factor", 1, 256, true},
    {"line_width", "", kSmallestAboveZero, kUnlimited, false},
    {"point_size", "", kSmallestAboveZero, kUnlimited, false},
    {"perspective", "fovy", 1, 179, false},
    {"perspective", "", kSmallestAboveZero, kUnlimited, false},
    {"frustum", "zNear", kSmallestAboveZero, kUnlimited, false},
    {"frustum", "zFar", kSmallestAboveZero, kUnlimited, false},
    {"viewport", "width", 0, kUnlimited, false},
    {"viewport", "height", 0, kUnlimited, false},
    {"scissor", "width", 0, kUnlimited, false},
    {"scissor", "height", 0, kUnlimited, false},
    {"spot_cone", "inner_deg", 0, 180, false},
    {"spot_cone", "outer_deg", 0, 180, false},
};

// Below these counts a shape has no inside.
bool is_count_of_slices(std::string_view parameter) {
    return parameter == "slices" || parameter == "stacks" || parameter == "sides" || parameter == "rings" ||
           parameter == "loops";
}

bool is_clamped_parameter(Enum pname) {
    return pname == kGL_FOG_COLOR || pname == kGL_TEXTURE_ENV_COLOR || pname == kGL_TEXTURE_BORDER_COLOR ||
           pname == kGL_TEXTURE_PRIORITY;
}

void set_range(const Command& command, std::size_t argument, ArgumentInfo& info) {
    info.smallest = -kUnlimited;
    info.largest = kUnlimited;
    const Parameter& parameter = command.sig().parameters[info.parameter];
    if (!is_real(parameter.kind)) {
        const WholeRange range = whole_range(parameter.kind);
        std::tie(info.smallest, info.largest) = std::pair(range.smallest, range.largest);
    }
    if (const ParameterInfo* const set = parameter_set(command); set && is_parameter_value(command, argument)) {
        info.smallest = std::max(info.smallest, set->smallest);
        info.largest = std::min(info.largest, set->largest);
        info.is_clamped = is_clamped_parameter(set->pname) && is_real(parameter.kind);
        if (info.is_clamped) std::tie(info.smallest, info.largest) = std::pair(0.0, 1.0);
    }
    for (const RangeRow& row : kRanges) {
        if (row.effect != effect_of(command) || !(row.parameter.empty() || row.parameter == parameter.name)) continue;
        info.smallest = row.smallest;
        info.largest = row.largest;
        info.is_clamped = row.is_clamped;
        return;
    }
    if (is_count_of_slices(parameter.name)) info.smallest = 1;
    if (command.id == CommandId::pragma_shape && argument > 0) info.smallest = kSmallestAboveZero;
}

double drag_speed(const Command& command, const ArgumentInfo& info, std::size_t argument) {
    constexpr double kOfCounts = 0.2, kOfColors = 0.004, kOfDegrees = 0.5, kOfLengths = 0.01;
    if (!is_real(info.kind)) return info.is_color ? 1 : kOfCounts;
    if (info.is_color) return kOfColors;
    const ParameterInfo* const set = parameter_set(command);
    const Enum pname = set && is_parameter_value(command, argument) ? set->pname : 0;
    if (pname == kGL_SPOT_CUTOFF || pname == kGL_SHININESS || pname == kGL_SPOT_EXPONENT) return kOfDegrees;
    const std::string_view name = command.sig().parameters[info.parameter].name;
    if (name == "angle" || name == "fovy" || name.ends_with("_deg") || name == "start" || name == "sweep")
        return kOfDegrees;
    return kOfLengths;
}

// The kind of editing: 1 or 0, a legal name, bits, or a number.
Editing editing_of(const Command& command, std::size_t argument) {
    const Parameter& parameter = command.sig().parameters[place_of(command, argument).parameter];
    if (parameter.extent != Extent::kValue && !parameter.is_array() && parameter.extent != Extent::kRest)
        return Editing::kFixed;
    if (parameter.is_output() || parameter.extent == Extent::kNewNames) return Editing::kFixed;
    switch (parameter.kind) {
        case Kind::kEnum:
        case Kind::kWord: return Editing::kName;
        case Kind::kBitfield: return Editing::kBits;
        case Kind::kBoolean: return Editing::kFlag;
        case Kind::kQuadric:
        case Kind::kSizeiptr: return Editing::kFixed;
        default: break;
    }
    if (const ParameterInfo* const set = parameter_set(command); set && is_parameter_value(command, argument)) {
        if (set->meaning == Meaning::kEnum) return Editing::kName;
        const Enum pname = set->pname;
        const auto* const of_model = find_parameter_row<LightModel>(pname);
        if ((of_model && is_flag(*of_model)) || pname == kGL_GENERATE_MIPMAP) return Editing::kFlag;
    }
    // Numbers of objects, and sizes of memory, hang together with other commands.
    constexpr CommandSet kObjects =
        CommandSet::of({"gen_lists", "new_list", "call_list", "call_lists", "delete_lists", "gen_textures",
                        "delete_textures", "bind_texture", "client_arrays", "tex_image", "tex_sub_image",
                        "copy_tex_image", "copy_tex_sub_image", "build_mipmaps", "texture_file"});
    return kObjects.contains(command.id) ? Editing::kFixed : Editing::kNumber;
}

bool is_color(const Command& command, std::size_t argument) {
    const ParameterInfo* const set = parameter_set(command);
    if (set && is_parameter_value(command, argument)) return set->meaning == Meaning::kColor;
    constexpr CommandSet kColors = CommandSet::of({"color", "clear_color", "blend_color", "secondary_color"});
    return kColors.contains(command.id);
}

// "red" for an element of a colour, "x" for one of a vector, "GL_SPOT_CUTOFF" for its only value; "m[4]" for other arrays.
std::string name_of_element(const Command& command, const Parameter& parameter, std::size_t element, bool color,
                            bool is_value) {
    constexpr std::string_view kColor[] = {"red", "green", "blue", "alpha"}, kVector[] = {"x", "y", "z", "w"};
    const ParameterInfo* const set = is_value ? parameter_set(command) : nullptr;
    if (set && set->count == 1) return enum_name(set->pname);
    if (!parameter.is_array() && parameter.extent != Extent::kRest) return std::string(parameter.name);
    if (color && element < std::size(kColor)) return std::string(kColor[element]);
    const bool is_vector = set ? set->meaning != Meaning::kScalar : parameter.extent == Extent::kArray;
    if (is_vector && parameter.count <= 4 && element < std::size(kVector)) return std::string(kVector[element]);
    return fmt::format("{}[{}]", parameter.name, element);
}

// ---- Help ----

struct HelpRow {
    std::string_view effect, parameter;
    Enum pname;
    std::string_view words, section;
};
constexpr HelpRow kHelp[] = {
#define HELP(effect, parameter, pname, words, section) {effect, parameter, pname, words, section},
#include "app/session/argument_help.def"
#undef HELP
};

const HelpRow* help_row(const Command& command, std::size_t argument) {
    std::string_view effect = effect_of(command);
    const std::string_view parameter = command.sig().parameters[place_of(command, argument).parameter].name;
    Enum pname = 0;
    if (is_parameter_value(command, argument)) pname = command.enumerant(*pname_argument(command));
    if (effect == "enable" || effect == "disable") {
        effect = "switch";
        pname = command.enumerant(0);
        if (pname > kGL_LIGHT0 && pname < kGL_LIGHT0 + kMaxLights) pname = kGL_LIGHT0;
    }
    if (effect == "extra_light" && pname != 0) effect = "light";
    for (const HelpRow& row : kHelp) {
        const bool fits = row.parameter.empty() || row.parameter == parameter;
        if (row.effect == effect && fits && (row.pname == 0 || row.pname == pname)) return &row;
    }
    return nullptr;
}

// ---- Legal values ----

// A State in which any command may be tried: it has a quadric.
State state_to_try(const Command& command) {
    State state;
    if (effect_of(command) == "set_quadric" || effect_of(command) == "quadric_shape")
        state.apply({CommandId::gluNewQuadric, {command.number(0)}, {}});
    return state;
}

bool is_legal_name(const Command& command) {
    State state = state_to_try(command);
    state.apply(command);
    return std::ranges::none_of(state.errors(), [](const GlError& error) {
        return error.code == kGL_INVALID_ENUM || error.code == kGLU_INVALID_ENUM || error.code == kGL_INVALID_VALUE;
    });
}

std::vector<Choice> names_to_try(const Command& command, Kind kind) {
    std::vector<Choice> names;
    const auto add = [&](double value, std::string name) {
        const bool is_known = std::ranges::any_of(names, [&](const Choice& choice) { return choice.value == value; });
        if (!is_known) names.push_back({std::move(name), value});
    };
    for (const NamedValue& row : kind == Kind::kWord ? words() : gl_names())
        add(row.value, kind == Kind::kWord ? std::string(row.name) : value_name(command.id, row.value));
    return names;
}

std::vector<Choice> legal_names(const Command& command, std::size_t argument, Kind kind) {
    constexpr std::size_t kMostChoices = 100;  // State takes nearly any name for what only the driver supports
    std::vector<Choice> legal;
    for (Choice& choice : names_to_try(command, kind)) {
        if (is_legal_name(changed_argument(command, argument, choice.value))) legal.push_back(std::move(choice));
        if (legal.size() > kMostChoices) return {};
    }
    return legal;
}

std::vector<Choice> bits(const Command& command) {
    std::vector<Choice> result;
    if (command.id == CommandId::glClear) {
        for (const Enum bit :
             {kGL_COLOR_BUFFER_BIT, kGL_DEPTH_BUFFER_BIT, kGL_STENCIL_BUFFER_BIT, kGL_ACCUM_BUFFER_BIT})
            result.push_back({bit_names(bit), static_cast<double>(bit)});
    } else if (command.id == CommandId::glPushAttrib) {
        for (std::uint32_t bit = 1; bit != 0 && bit <= kGL_MULTISAMPLE_BIT; bit <<= 1)
            if (const std::string name = bit_names(bit); name.starts_with("GL_"))
                result.push_back({name, static_cast<double>(bit)});
    }
    return result;
}

}  // namespace

ArgumentInfo argument_info(const Command& command, std::size_t argument) {
    ArgumentInfo info;
    const ArgumentPlace place = place_of(command, argument);
    const Parameter& parameter = command.sig().parameters[place.parameter];
    info.parameter = place.parameter;
    info.kind = parameter.kind;
    info.editing = editing_of(command, argument);
    info.is_color = info.editing == Editing::kNumber && is_color(command, argument);
    info.name =
        name_of_element(command, parameter, place.element, info.is_color, is_parameter_value(command, argument));
    info.initial = initial_value(command, argument);
    set_range(command, argument, info);
    info.drag_speed = drag_speed(command, info, argument);
    return info;
}

std::string argument_help(const Command& command, std::size_t argument) {
    const HelpRow* const row = help_row(command, argument);
    std::string text = row ? tr(row->words) : command.sig().usage();
    if (const auto initial = initial_value(command, argument))
        text += tr("; initially {}", printed_argument(command, argument, *initial));
    if (row) text += tr("; {}", tr(row->section));
    return text;
}

std::string printed_argument(const Command& command, std::size_t argument, double value) {
    Command with = command;
    with.arguments[argument] = value;
    for (const PrintedPart& part : print_parts(with, std::numeric_limits<std::size_t>::max()))
        if (part.argument == argument) return part.text;
    return fmt::format("{}", value);
}

std::vector<Choice> legal_choices(const Command& command, std::size_t argument) {
    if (argument >= command.arguments.size()) return {};
    const Kind kind = command.sig().parameters[place_of(command, argument).parameter].kind;
    switch (editing_of(command, argument)) {
        case Editing::kFlag: {
            const bool is_named = kind == Kind::kBoolean;
            return {{is_named ? "GL_FALSE" : "0", 0}, {is_named ? "GL_TRUE" : "1", 1}};
        }
        case Editing::kBits: return bits(command);
        case Editing::kName: return legal_names(command, argument, kind);
        case Editing::kNumber:
        case Editing::kFixed: return {};
    }
    return {};
}

Command changed_argument(const Command& command, std::size_t argument, double value) {
    if (argument >= command.arguments.size()) return command;
    Command result = command;
    const std::vector<Parameter>& parameters = command.sig().parameters;
    result.arguments[argument] = as_kind(value, parameters[place_of(command, argument).parameter].kind);
    if (!owner_of_command(command) || pname_argument(command) != argument) return result;

    // Another pname: the old values mean something else.
    const ParameterInfo* const before = parameter_set(command);
    const ParameterInfo* const after = parameter_set(result);
    const auto same = [&] {
        return before->count == after->count && before->meaning == after->meaning && after->meaning != Meaning::kEnum &&
               before->smallest == after->smallest && before->largest == after->largest;
    };
    if (!after || (before && same())) return result;
    const Parameter& values = parameters.back();
    if (values.extent == Extent::kValue && after->count > 1) return result;  // GL raises its error
    std::vector<double> initial = initial_parameter(result, after->owner, after->pname);
    initial.resize(static_cast<std::size_t>(after->count), 0.0);
    result.arguments.resize(argument + 1);
    for (const double v : initial) {
        const double number = as_argument(v, values.kind, after->meaning == Meaning::kColor);
        result.arguments.push_back(as_kind(number, values.kind));
    }
    return result;
}

double nearest_legal(const Command& command, std::size_t argument, double value) {
    const ArgumentInfo info = argument_info(command, argument);
    const double legal = as_kind(std::clamp(value, info.smallest, info.largest), info.kind);
    const ParameterInfo* const set = parameter_set(command);
    const bool is_cutoff = set && set->pname == kGL_SPOT_CUTOFF && is_parameter_value(command, argument);
    constexpr double kWidest = 90, kNoCone = 180;
    if (is_cutoff && legal > kWidest) return legal < (kWidest + kNoCone) / 2 ? kWidest : kNoCone;
    return legal;
}

Command with_initial_values(const Command& command) {
    Command result = command;
    for (std::size_t i = 0; i < command.arguments.size(); ++i)
        if (const auto initial = initial_value(command, i))
            result.arguments[i] = as_kind(*initial, command.sig().parameters[place_of(command, i).parameter].kind);
    return result;
}

std::string error_of(const Command& command) {
    State state = state_to_try(command);
    state.apply(command);
    for (const GlError& error : state.errors()) {
        const bool is_of_value = error.code == kGL_INVALID_ENUM || error.code == kGL_INVALID_VALUE ||
                                 error.code == kGLU_INVALID_ENUM || error.code == kGLU_INVALID_VALUE;
        if (is_of_value) return fmt::format("{} ({})", error.message, enum_name(error.code));
    }
    return "";
}

// ---- What was changed ----

std::vector<std::optional<std::size_t>> opened_commands(const CommandList& opened, const CommandList& now) {
    using Key = std::tuple<const std::string*, int, int>;
    const auto key = [](const Place& place) { return Key(place.file.get(), place.line, place.column); };
    std::map<Key, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < opened.commands.size(); ++i) at[key(opened.commands[i].place)].push_back(i);
    std::map<Key, std::size_t> taken;
    std::vector<std::optional<std::size_t>> result(now.commands.size());
    for (std::size_t i = 0; i < now.commands.size(); ++i) {
        const auto found = at.find(key(now.commands[i].place));
        if (found == at.end()) continue;
        std::size_t& next = taken[found->first];
        if (next < found->second.size()) result[i] = found->second[next++];
    }
    return result;
}

bool is_changed(const Command* opened, const Command& now, std::size_t argument) {
    if (!opened || opened->id != now.id || argument >= opened->arguments.size()) return true;
    return opened->arguments[argument] != now.arguments[argument];
}

}  // namespace twinlight::session
