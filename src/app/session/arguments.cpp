#include "app/session/arguments.h"

#include <cmath>
#include <optional>
#include <vector>

#include "app/session/edits.h"
#include "scene/command/memory.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

// The parameter that an argument belongs to, and the number of the element in it.
struct At {
    std::size_t parameter = 0, element = 0;
};
At at(const Command& command, std::size_t argument) {
    const std::size_t parameters = command.sig().parameters.size();
    std::size_t first = 0;
    for (std::size_t i = 0; i < parameters; ++i) {
        const std::size_t count = command.count(i);
        if (argument < first + count) return {i, argument - first};
        first += count;
    }
    return {parameters == 0 ? 0 : parameters - 1, 0};
}

std::optional<std::size_t> pname_argument(const Command& command) {
    if (!owner_of(command.id)) return std::nullopt;
    const std::vector<Parameter>& parameters = command.sig().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].name == "pname") return command.first(i);
    return std::nullopt;
}

// A real number as an integer argument for a colour would give it (table 2.9, inverted).
double as_argument(double value, Kind kind, Meaning meaning) {
    if (is_real(kind) || meaning != Meaning::kColor) return value;
    const auto [smallest, largest] = whole_range(kind);
    return smallest < 0 ? std::round((value * (largest - smallest) - 1) / 2) : std::round(value * largest);
}

std::vector<double> numbers(const glm::dvec4& v) { return {v.x, v.y, v.z, v.w}; }
std::vector<double> one(double value) { return {value}; }

// The initial values of a parameter, from a fresh State (tables 6.5 to 6.35). Empty if there is none.
std::vector<double> initial_parameter(const Command& command, Owner owner, Enum pname) {
    static const State fresh;
    switch (owner) {
        case Owner::kLight: {
            const bool is_pragma = command.id == CommandId::pragma_light;
            return fresh.get_light(is_pragma ? kGL_LIGHT1 : command.enumerant(0), pname);
        }
        case Owner::kMaterial: return fresh.get_material(kGL_FRONT, pname);
        case Owner::kLightModel: {
            const LightModel& model = fresh.lighting().light_model;
            if (pname == kGL_LIGHT_MODEL_AMBIENT) return numbers(model.ambient);
            if (pname == kGL_LIGHT_MODEL_COLOR_CONTROL) return one(model.color_control);
            return one(0);
        }
        case Owner::kFog: {
            const Fog fog;
            switch (pname) {
                case kGL_FOG_MODE: return one(fog.mode);
                case kGL_FOG_DENSITY: return one(fog.density);
                case kGL_FOG_START: return one(fog.start);
                case kGL_FOG_END: return one(fog.end);
                case kGL_FOG_COLOR: return numbers(fog.color);
                case kGL_FOG_COORD_SRC: return one(kGL_FRAGMENT_DEPTH);
                default: return one(0);
            }
        }
        case Owner::kTexEnv: return pname == kGL_TEXTURE_ENV_COLOR ? std::vector<double>(4, 0.0) : one(kGL_MODULATE);
        case Owner::kTexFilterControl: return one(0);
        case Owner::kTexture: {
            const Texture texture;
            switch (pname) {
                case kGL_TEXTURE_MIN_FILTER: return one(texture.min_filter);
                case kGL_TEXTURE_MAG_FILTER: return one(texture.mag_filter);
                case kGL_TEXTURE_WRAP_S:
                case kGL_TEXTURE_WRAP_T:
                case kGL_TEXTURE_WRAP_R: return one(kGL_REPEAT);
                case kGL_TEXTURE_BORDER_COLOR: return numbers(texture.border_color);
                case kGL_TEXTURE_PRIORITY: return one(texture.priority);
                default: return one(0);
            }
        }
        case Owner::kPixelStore:
            for (const PixelStoreRow& row : kPixelStoreRows)
                if (row.pname == pname) return one(row.value(PixelStore{}));
            return {};
        case Owner::kPoint:
            if (pname == kGL_POINT_DISTANCE_ATTENUATION) return {1, 0, 0};
            if (pname == kGL_POINT_FADE_THRESHOLD_SIZE) return one(1);
            return {};
    }
    return {};
}

}  // namespace

Command changed_argument(const Command& command, std::size_t argument, double value) {
    if (argument >= command.arguments.size()) return command;
    Command result = command;
    const std::vector<Parameter>& parameters = command.sig().parameters;
    const Kind kind = parameters[at(command, argument).parameter].kind;
    result.arguments[argument] = as_kind(value, kind);
    if (pname_argument(command) != argument) return result;

    const ParameterInfo* before = parameter_info(command);
    const ParameterInfo* after = parameter_info(result);
    if (!after || (before && before->count == after->count && before->meaning == after->meaning)) return result;
    const Parameter& values = parameters.back();
    const bool is_scalar = values.extent == Extent::kValue;
    if (is_scalar && after->count > 1) return result;
    std::vector<double> initial = initial_parameter(result, after->owner, after->pname);
    initial.resize(static_cast<std::size_t>(after->count), 0.0);
    result.arguments.resize(parameters.size() - 1);
    for (const double v : initial)
        result.arguments.push_back(as_kind(as_argument(v, values.kind, after->meaning), values.kind));
    return result;
}

}  // namespace twinlight::session
