#include "app/session/initial_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "app/session/argument_places.h"
#include "scene/command/memory.h"
#include "scene/state/answers.h"
#include "scene/state/lighting_parameters.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

std::vector<double> components(const glm::dvec4& v) { return {v.x, v.y, v.z, v.w}; }

// The initial values of all arguments of a command, by its effect; NaN for one without. Empty: none has one.
struct InitialRow {
    std::string_view effect;
    std::vector<double> values;
};
const std::vector<InitialRow>& initial_rows() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    static const std::vector<InitialRow> rows = {
        {"color_material", {kGL_FRONT_AND_BACK, kGL_AMBIENT_AND_DIFFUSE}},
        {"shade_model", {kGL_SMOOTH}},
        {"color", {1, 1, 1, 1}},
        {"normal", {0, 0, 1}},
        {"tex_coord", {0, 0, 0, 1}},
        {"multi_tex_coord", {kNone, 0, 0, 0, 1}},
        {"secondary_color", {0, 0, 0}},
        {"fog_coord", {0}},
        {"edge_flag", {1}},
        {"matrix_mode", {kGL_MODELVIEW}},
        {"depth_range", {0, 1}},
        {"clip_plane", {kNone, 0, 0, 0, 0}},
        {"front_face", {kGL_CCW}},
        {"cull_face", {kGL_BACK}},
        {"polygon_mode", {kGL_FRONT_AND_BACK, kGL_FILL}},
        {"polygon_offset", {0, 0}},
        {"line_width", {1}},
        {"point_size", {1}},
        {"line_stipple", {1, 0xFFFF}},
        {"logic_op", {kGL_COPY}},
        {"depth_func", {kGL_LESS}},
        {"depth_mask", {1}},
        {"color_mask", {1, 1, 1, 1}},
        {"clear_color", {0, 0, 0, 0}},
        {"clear_depth", {1}},
        {"alpha_func", {kGL_ALWAYS, 0}},
        {"blend_func", {kGL_ONE, kGL_ZERO, kGL_ONE, kGL_ZERO}},
        {"blend_equation", {kGL_FUNC_ADD, kGL_FUNC_ADD}},
        {"blend_color", {0, 0, 0, 0}},
        {"hint", {kNone, kGL_DONT_CARE}},
        {"active_texture", {kGL_TEXTURE0}},
        {"list_base", {0}},
        {"specular_model", {static_cast<double>(Word::half_vector)}},
        {"ambient_model", {static_cast<double>(Word::attenuated)}},
        {"transfer", {static_cast<double>(Word::linear)}},
    };
    return rows;
}

}  // namespace

double as_argument(double value, Kind kind, bool is_color) {
    if (is_real(kind) || !is_color) return value;
    const auto [smallest, largest] = whole_range(kind);
    return smallest < 0 ? std::round((value * (largest - smallest) - 1) / 2) : std::round(value * largest);
}

std::vector<double> initial_parameter(const Command& command, Owner owner, Enum pname) {
    static const State fresh;
    const auto one = [](double value) { return std::vector<double>{value}; };
    switch (owner) {
        case Owner::kLight: {
            const bool is_extra = command.id == CommandId::pragma_light;  // starts like all but GL_LIGHT0
            return fresh.get_light(is_extra ? kGL_LIGHT1 : command.enumerant(0), pname);
        }
        case Owner::kMaterial: return fresh.get_material(kGL_FRONT, pname);
        case Owner::kLightModel: return values_of(LightModel(), *find_lighting_parameter<LightModel>(pname));
        case Owner::kFog: {
            const Fog fog;
            switch (pname) {
                case kGL_FOG_MODE: return one(fog.mode);
                case kGL_FOG_DENSITY: return one(fog.density);
                case kGL_FOG_START: return one(fog.start);
                case kGL_FOG_END: return one(fog.end);
                case kGL_FOG_COLOR: return components(fog.color);
                case kGL_FOG_COORD_SRC: return one(kGL_FRAGMENT_DEPTH);
                default: return one(0);
            }
        }
        case Owner::kTexEnv: return tex_env_answer(fresh, kGL_TEXTURE_ENV, pname);
        case Owner::kTexGen: {
            const bool is_known = command.enumerant(0) >= kGL_S && command.enumerant(0) <= kGL_Q;
            const TexGen gen = TextureBindings{}.tex_gen[is_known ? command.enumerant(0) - kGL_S : 0];
            return pname == kGL_TEXTURE_GEN_MODE ? one(gen.mode) : components(gen.object_plane);
        }
        case Owner::kTexFilterControl:
        case Owner::kPointSprite: return one(0);
        case Owner::kTexture: {
            const Texture texture;
            switch (pname) {
                case kGL_TEXTURE_MIN_FILTER: return one(texture.min_filter);
                case kGL_TEXTURE_MAG_FILTER: return one(texture.mag_filter);
                case kGL_TEXTURE_WRAP_S:
                case kGL_TEXTURE_WRAP_T:
                case kGL_TEXTURE_WRAP_R: return one(kGL_REPEAT);
                case kGL_TEXTURE_BORDER_COLOR: return components(texture.border_color);
                case kGL_TEXTURE_PRIORITY: return one(texture.priority);
                case kGL_TEXTURE_MAX_ANISOTROPY_EXT: return one(texture.max_anisotropy);
                default: return one(0);
            }
        }
        case Owner::kPixelStore:
            for (const PixelStoreRow& row : kPixelStoreRows)
                if (row.pname == pname) return one(row.value(PixelStore{}));
            return {};
        case Owner::kPoint: return answer(fresh, pname);
    }
    return {};
}

std::optional<double> initial_value(const Command& command, std::size_t argument) {
    const Parameter& parameter = command.sig().parameters[place_of(command, argument).parameter];
    if (is_parameter_value(command, argument)) {
        const ParameterInfo* const info = parameter_set(command);
        if (!info) return std::nullopt;
        const std::vector<double> values = initial_parameter(command, info->owner, info->pname);
        const std::size_t element = argument - *pname_argument(command) - 1;
        if (element >= values.size()) return std::nullopt;
        return as_argument(values[element], parameter.kind, info->meaning == Meaning::kColor);
    }
    const auto row = std::ranges::find(initial_rows(), effect_of(command), &InitialRow::effect);
    if (row == initial_rows().end() || argument >= row->values.size() || std::isnan(row->values[argument]))
        return std::nullopt;
    const bool is_converted = row->effect == "color" || row->effect == "secondary_color" || row->effect == "normal";
    return as_argument(row->values[argument], parameter.kind, is_converted);
}

}  // namespace twinlight::session
