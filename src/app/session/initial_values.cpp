#include "app/session/initial_values.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

#include "app/session/argument_places.h"
#include "scene/command/memory.h"
#include "scene/frame/parameter_rows.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

std::vector<double> components(const glm::dvec4& v) { return {v.x, v.y, v.z, v.w}; }

// The initial values of all arguments of a command, by its effect: what glGet returns for these names in GL's initial state, ...
struct QueriedRow {
    std::string_view effect;
    std::initializer_list<Enum> names;
};
constexpr QueriedRow kQueriedRows[] = {
    {"color_material", {kGL_COLOR_MATERIAL_FACE, kGL_COLOR_MATERIAL_PARAMETER}},
    {"shade_model", {kGL_SHADE_MODEL}},
    {"color", {kGL_CURRENT_COLOR}},
    {"normal", {kGL_CURRENT_NORMAL}},
    {"tex_coord", {kGL_CURRENT_TEXTURE_COORDS}},
    {"secondary_color", {kGL_CURRENT_SECONDARY_COLOR}},
    {"fog_coord", {kGL_CURRENT_FOG_COORD}},
    {"edge_flag", {kGL_EDGE_FLAG}},
    {"matrix_mode", {kGL_MATRIX_MODE}},
    {"depth_range", {kGL_DEPTH_RANGE}},
    {"front_face", {kGL_FRONT_FACE}},
    {"cull_face", {kGL_CULL_FACE_MODE}},
    {"polygon_offset", {kGL_POLYGON_OFFSET_FACTOR, kGL_POLYGON_OFFSET_UNITS}},
    {"line_width", {kGL_LINE_WIDTH}},
    {"point_size", {kGL_POINT_SIZE}},
    {"line_stipple", {kGL_LINE_STIPPLE_REPEAT, kGL_LINE_STIPPLE_PATTERN}},
    {"logic_op", {kGL_LOGIC_OP_MODE}},
    {"depth_func", {kGL_DEPTH_FUNC}},
    {"depth_mask", {kGL_DEPTH_WRITEMASK}},
    {"color_mask", {kGL_COLOR_WRITEMASK}},
    {"clear_color", {kGL_COLOR_CLEAR_VALUE}},
    {"clear_depth", {kGL_DEPTH_CLEAR_VALUE}},
    {"alpha_func", {kGL_ALPHA_TEST_FUNC, kGL_ALPHA_TEST_REF}},
    {"blend_func", {kGL_BLEND_SRC_RGB, kGL_BLEND_DST_RGB, kGL_BLEND_SRC_ALPHA, kGL_BLEND_DST_ALPHA}},
    {"blend_equation", {kGL_BLEND_EQUATION, kGL_BLEND_EQUATION_ALPHA}},
    {"blend_color", {kGL_BLEND_COLOR}},
    {"active_texture", {kGL_ACTIVE_TEXTURE}},
    {"list_base", {kGL_LIST_BASE}},
};
// ... or these; NaN for an argument without.
struct InitialRow {
    std::string_view effect;
    std::vector<double> values;
};
const std::vector<InitialRow>& initial_rows() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    static const std::vector<InitialRow> rows = [] {
        std::vector<InitialRow> all = {
            {"multi_tex_coord", {kNone, 0, 0, 0, 1}},
            {"clip_plane", {kNone, 0, 0, 0, 0}},
            {"polygon_mode", {kGL_FRONT_AND_BACK, kGL_FILL}},
            {"hint", {kNone, kGL_DONT_CARE}},
            {"specular_model", {static_cast<double>(Word::half_vector)}},
            {"ambient_model", {static_cast<double>(Word::attenuated)}},
            {"transfer", {static_cast<double>(Word::linear)}},
        };
        const State fresh;
        for (const QueriedRow& queried : kQueriedRows) {
            InitialRow row{queried.effect, {}};
            for (const Enum name : queried.names)
                std::ranges::copy(answer(fresh, name), std::back_inserter(row.values));
            all.push_back(std::move(row));
        }
        return all;
    }();
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
        case Owner::kLightModel: return values_of(LightModel(), *find_parameter_row<LightModel>(pname));
        case Owner::kFog: return pname == kGL_FOG_INDEX ? std::vector<double>{0} : answer(fresh, pname);
        case Owner::kTexEnv: return tex_env_answer(fresh, kGL_TEXTURE_ENV, pname);
        case Owner::kTexGen: {
            const bool is_known = command.enumerant(0) >= kGL_S && command.enumerant(0) <= kGL_Q;
            const TexGen gen = TextureBindings{}.tex_gen[is_known ? command.enumerant(0) - kGL_S : 0];
            return pname == kGL_TEXTURE_GEN_MODE ? one(gen.mode) : components(gen.object_plane);
        }
        case Owner::kTexFilterControl:
        case Owner::kPointSprite: return one(0);
        case Owner::kTexture: return tex_parameter_answer(fresh, kGL_TEXTURE_2D, pname);
        case Owner::kPixelStore:
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
