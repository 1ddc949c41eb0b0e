#include "scene/state/state_variables.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <tuple>
#include <type_traits>
#include <unordered_map>

namespace twinlight {

namespace {

using Values = std::vector<double>;

template <class Value>
void add(Values& values, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>)
        values.push_back(static_cast<double>(value));
    else if constexpr (std::same_as<Value, Rectangle>)
        for (const int number : {value.x, value.y, value.width, value.height}) values.push_back(number);
    else if constexpr (requires { value.size(); })
        for (const auto part : value) values.push_back(part);
    else
        for (int i = 0; i < Value::length(); ++i) values.push_back(value[i]);
}

template <class Value>
Values numbers(const Value& value) {
    Values values;
    add(values, value);
    return values;
}
template <class... Parts>
Values numbers(const std::tuple<Parts&...>& parts) {
    Values values;
    std::apply([&](const auto&... part) { (add(values, part), ...); }, parts);
    return values;
}

// A row of a member, or of several as std::tie. `query`: what glGet returns, if that is not the value itself.
template <class Get, class Query>
constexpr StateVariable row(Enum pname, Enum groups, Get /*get*/, Query /*query*/) {
    return {pname, groups, [](const Attributes& of) { return Query{}(of); },
            [](Attributes& to, const Attributes& from) { Get{}(to) = Get{}(from); },
            [](const Attributes& of) -> const bool* {
                if constexpr (std::same_as<decltype(Get{}(of)), const bool&>)
                    return &Get{}(of);
                else
                    return nullptr;
            }};
}
template <class Get>
constexpr StateVariable row(Enum pname, Enum groups, Get get) {
    return row(pname, groups, get, [](const Attributes& of) { return numbers(Get{}(of)); });
}
// One that no query names.
template <class Get>
constexpr StateVariable row(Enum groups, Get get) {
    return row(0, groups, get, [](const Attributes& /*of*/) { return Values{}; });
}

// The member of Attributes.
#define AT(member) \
    [](auto& a) -> auto& { return a.member; }

constexpr auto kStencilRef = [](const StencilFace& face) { return numbers(std::clamp(face.ref, 0, kMaxStencil)); };

constexpr StateVariable kRows[] = {
    // Table 6.5. Texture coordinates belong to units.
    row(kGL_CURRENT_COLOR, kGL_CURRENT_BIT, AT(current.color)),
    row(kGL_CURRENT_NORMAL, kGL_CURRENT_BIT, AT(current.normal_object)),
    row(kGL_CURRENT_SECONDARY_COLOR, kGL_CURRENT_BIT, AT(current.further(VertexAttribute::kSecondaryColor))),
    row(kGL_CURRENT_FOG_COORD, kGL_CURRENT_BIT, AT(current.further(VertexAttribute::kFogCoord).x)),
    row(kGL_EDGE_FLAG, kGL_CURRENT_BIT, AT(current.edge_flag)),
    row(kGL_CURRENT_BIT, AT(current)),
    row(kGL_CURRENT_BIT, AT(raster_position)),

    // Table 6.10: transformation.
    row(kGL_MATRIX_MODE, kGL_TRANSFORM_BIT, AT(matrix_mode)),
    row(kGL_NORMALIZE, kGL_TRANSFORM_BIT | kGL_ENABLE_BIT, AT(lighting.normalize)),
    row(kGL_RESCALE_NORMAL, kGL_TRANSFORM_BIT | kGL_ENABLE_BIT, AT(lighting.rescale_normal)),
    row(kGL_VIEWPORT, kGL_VIEWPORT_BIT, AT(raster.viewport)),
    row(kGL_DEPTH_RANGE, kGL_VIEWPORT_BIT, [](auto& a) { return std::tie(a.raster.depth_near, a.raster.depth_far); }),

    // Tables 6.11 to 6.13: colouring and lighting. parameter_rows.h has the light model, lights and materials.
    row(kGL_FOG, kGL_FOG_BIT | kGL_ENABLE_BIT, AT(fog.enabled)),
    row(kGL_FOG_MODE, kGL_FOG_BIT, AT(fog.mode)),
    row(kGL_FOG_DENSITY, kGL_FOG_BIT, AT(fog.density)),
    row(kGL_FOG_START, kGL_FOG_BIT, AT(fog.start)),
    row(kGL_FOG_END, kGL_FOG_BIT, AT(fog.end)),
    row(kGL_FOG_COLOR, kGL_FOG_BIT, AT(fog.color)),
    row(kGL_FOG_COORD_SRC, kGL_FOG_BIT, AT(fog.by_coordinates),
        [](const Attributes& a) { return numbers(a.fog.by_coordinates ? kGL_FOG_COORD : kGL_FRAGMENT_DEPTH); }),
    row(kGL_COLOR_SUM, kGL_FOG_BIT | kGL_ENABLE_BIT, AT(fragment.color_sum)),
    row(kGL_SHADE_MODEL, kGL_LIGHTING_BIT, AT(lighting.shade_model)),
    row(kGL_LIGHTING, kGL_LIGHTING_BIT | kGL_ENABLE_BIT, AT(lighting.enabled)),
    row(kGL_COLOR_MATERIAL, kGL_LIGHTING_BIT | kGL_ENABLE_BIT, AT(lighting.color_material.enabled)),
    row(kGL_COLOR_MATERIAL_PARAMETER, kGL_LIGHTING_BIT, AT(lighting.color_material.mode)),
    row(kGL_COLOR_MATERIAL_FACE, kGL_LIGHTING_BIT, AT(lighting.color_material.face)),

    // Table 6.14: rasterisation.
    row(kGL_POINT_SIZE, kGL_POINT_BIT, AT(raster.point_size)),
    row(kGL_POINT_SMOOTH, kGL_POINT_BIT | kGL_ENABLE_BIT, AT(raster.point_smooth)),
    row(kGL_POINT_SPRITE, kGL_POINT_BIT | kGL_ENABLE_BIT, AT(raster.point_sprite)),
    row(kGL_POINT_SIZE_MIN, kGL_POINT_BIT, AT(raster.point_parameters.size_min)),
    row(kGL_POINT_SIZE_MAX, kGL_POINT_BIT, AT(raster.point_parameters.size_max)),
    row(kGL_POINT_FADE_THRESHOLD_SIZE, kGL_POINT_BIT, AT(raster.point_parameters.fade_threshold_size)),
    row(kGL_POINT_DISTANCE_ATTENUATION, kGL_POINT_BIT, AT(raster.point_parameters.distance_attenuation)),
    row(kGL_POINT_SPRITE_COORD_ORIGIN, kGL_POINT_BIT, AT(raster.point_parameters.sprite_coord_origin)),
    row(kGL_LINE_WIDTH, kGL_LINE_BIT, AT(raster.line_width)),
    row(kGL_LINE_SMOOTH, kGL_LINE_BIT | kGL_ENABLE_BIT, AT(raster.line_smooth)),
    row(kGL_LINE_STIPPLE, kGL_LINE_BIT | kGL_ENABLE_BIT, AT(line_stipple_enabled)),
    row(kGL_LINE_STIPPLE_PATTERN, kGL_LINE_BIT, AT(line_stipple.pattern)),
    row(kGL_LINE_STIPPLE_REPEAT, kGL_LINE_BIT, AT(line_stipple.factor)),
    row(kGL_CULL_FACE, kGL_POLYGON_BIT | kGL_ENABLE_BIT, AT(raster.cull_enabled)),
    row(kGL_CULL_FACE_MODE, kGL_POLYGON_BIT, AT(raster.cull_face)),
    row(kGL_FRONT_FACE, kGL_POLYGON_BIT, AT(raster.front_face)),
    row(kGL_POLYGON_MODE, kGL_POLYGON_BIT,
        [](auto& a) { return std::tie(a.raster.polygon_mode_front, a.raster.polygon_mode_back); }),
    row(kGL_POLYGON_OFFSET_FACTOR, kGL_POLYGON_BIT, AT(raster.polygon_offset.factor)),
    row(kGL_POLYGON_OFFSET_UNITS, kGL_POLYGON_BIT, AT(raster.polygon_offset.units)),
    row(kGL_POLYGON_OFFSET_POINT, kGL_POLYGON_BIT | kGL_ENABLE_BIT, AT(raster.polygon_offset.point)),
    row(kGL_POLYGON_OFFSET_LINE, kGL_POLYGON_BIT | kGL_ENABLE_BIT, AT(raster.polygon_offset.line)),
    row(kGL_POLYGON_OFFSET_FILL, kGL_POLYGON_BIT | kGL_ENABLE_BIT, AT(raster.polygon_offset.fill)),
    row(kGL_POLYGON_STIPPLE, kGL_POLYGON_BIT | kGL_ENABLE_BIT, AT(polygon_stipple_enabled)),
    row(kGL_POLYGON_STIPPLE_BIT, AT(polygon_stipple)),

    // Tables 6.21 to 6.23: pixel operations and framebuffer control.
    row(kGL_SCISSOR_TEST, kGL_SCISSOR_BIT | kGL_ENABLE_BIT, AT(fragment.scissor.enabled)),
    row(kGL_SCISSOR_BOX, kGL_SCISSOR_BIT, AT(fragment.scissor.box)),
    row(kGL_ALPHA_TEST, kGL_COLOR_BUFFER_BIT | kGL_ENABLE_BIT, AT(fragment.alpha_test)),
    row(kGL_ALPHA_TEST_FUNC, kGL_COLOR_BUFFER_BIT, AT(fragment.alpha_func)),
    row(kGL_ALPHA_TEST_REF, kGL_COLOR_BUFFER_BIT, AT(fragment.alpha_ref)),
    row(kGL_STENCIL_TEST, kGL_STENCIL_BUFFER_BIT | kGL_ENABLE_BIT, AT(stencil_enabled)),
    row(kGL_STENCIL_FUNC, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.front.func)),
    row(kGL_STENCIL_VALUE_MASK, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.front.mask)),
    row(kGL_STENCIL_REF, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.front.ref),
        [](const Attributes& a) { return kStencilRef(a.stencil_test.front); }),
    row(kGL_STENCIL_FAIL, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.front.fail)),
    row(kGL_STENCIL_PASS_DEPTH_FAIL, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.front.depth_fail)),
    row(kGL_STENCIL_PASS_DEPTH_PASS, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.front.depth_pass)),
    row(kGL_STENCIL_WRITEMASK, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.front.write_mask)),
    row(kGL_STENCIL_BACK_FUNC, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.back.func)),
    row(kGL_STENCIL_BACK_VALUE_MASK, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.back.mask)),
    row(kGL_STENCIL_BACK_REF, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.back.ref),
        [](const Attributes& a) { return kStencilRef(a.stencil_test.back); }),
    row(kGL_STENCIL_BACK_FAIL, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.back.fail)),
    row(kGL_STENCIL_BACK_PASS_DEPTH_FAIL, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.back.depth_fail)),
    row(kGL_STENCIL_BACK_PASS_DEPTH_PASS, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.back.depth_pass)),
    row(kGL_STENCIL_BACK_WRITEMASK, kGL_STENCIL_BUFFER_BIT, AT(stencil_test.back.write_mask)),
    row(kGL_DEPTH_TEST, kGL_DEPTH_BUFFER_BIT | kGL_ENABLE_BIT, AT(raster.depth_test)),
    row(kGL_DEPTH_FUNC, kGL_DEPTH_BUFFER_BIT, AT(raster.depth_func)),
    row(kGL_BLEND, kGL_COLOR_BUFFER_BIT | kGL_ENABLE_BIT, AT(fragment.blend)),
    row(kGL_BLEND_SRC, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_src)),
    row(kGL_BLEND_SRC_RGB, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_src)),
    row(kGL_BLEND_SRC_ALPHA, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_src_alpha)),
    row(kGL_BLEND_DST, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_dst)),
    row(kGL_BLEND_DST_RGB, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_dst)),
    row(kGL_BLEND_DST_ALPHA, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_dst_alpha)),
    row(kGL_BLEND_EQUATION, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_equation)),
    row(kGL_BLEND_EQUATION_ALPHA, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_equation_alpha)),
    row(kGL_BLEND_COLOR, kGL_COLOR_BUFFER_BIT, AT(fragment.blend_color)),
    row(kGL_COLOR_LOGIC_OP, kGL_COLOR_BUFFER_BIT | kGL_ENABLE_BIT, AT(logic_op_enabled)),
    row(kGL_LOGIC_OP_MODE, kGL_COLOR_BUFFER_BIT, AT(logic_op)),
    row(kGL_COLOR_BUFFER_BIT, AT(fragment.srgb_coded)),
    row(kGL_COLOR_BUFFER_BIT, AT(draws_color)),
    row(kGL_COLOR_WRITEMASK, kGL_COLOR_BUFFER_BIT, AT(fragment.color_mask)),
    row(kGL_DEPTH_WRITEMASK, kGL_DEPTH_BUFFER_BIT, AT(raster.depth_mask)),
    row(kGL_COLOR_CLEAR_VALUE, kGL_COLOR_BUFFER_BIT, AT(clear.clear_color)),
    row(kGL_DEPTH_CLEAR_VALUE, kGL_DEPTH_BUFFER_BIT, AT(clear.clear_depth)),
    row(kGL_STENCIL_CLEAR_VALUE, kGL_STENCIL_BUFFER_BIT, AT(clear.clear_stencil)),
    row(kGL_ACCUM_CLEAR_VALUE, kGL_ACCUM_BUFFER_BIT, AT(clear.clear_accumulation)),

    // Tables 6.25 and 6.26: pixels.
    row(kGL_MAP_COLOR, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.map_color)),
    row(kGL_MAP_STENCIL, kGL_PIXEL_MODE_BIT, AT(stencil_transfer.map)),
    row(kGL_INDEX_SHIFT, kGL_PIXEL_MODE_BIT, AT(stencil_transfer.shift)),
    row(kGL_INDEX_OFFSET, kGL_PIXEL_MODE_BIT, AT(stencil_transfer.offset)),
    row(kGL_RED_SCALE, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.scale.r)),
    row(kGL_GREEN_SCALE, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.scale.g)),
    row(kGL_BLUE_SCALE, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.scale.b)),
    row(kGL_ALPHA_SCALE, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.scale.a)),
    row(kGL_RED_BIAS, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.bias.r)),
    row(kGL_GREEN_BIAS, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.bias.g)),
    row(kGL_BLUE_BIAS, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.bias.b)),
    row(kGL_ALPHA_BIAS, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.bias.a)),
    row(kGL_DEPTH_SCALE, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.depth_scale)),
    row(kGL_DEPTH_BIAS, kGL_PIXEL_MODE_BIT, AT(pixel_transfer.depth_bias)),
    row(kGL_ZOOM_X, kGL_PIXEL_MODE_BIT, AT(pixel_zoom.x)),
    row(kGL_ZOOM_Y, kGL_PIXEL_MODE_BIT, AT(pixel_zoom.y)),

    // Table 6.24 and 6.28: evaluators and lists.
    row(kGL_MAP1_GRID_DOMAIN, kGL_EVAL_BIT, [](auto& a) { return std::tie(a.grid1.first, a.grid1.last); }),
    row(kGL_MAP1_GRID_SEGMENTS, kGL_EVAL_BIT, AT(grid1.segments)),
    row(kGL_MAP2_GRID_DOMAIN, kGL_EVAL_BIT,
        [](auto& a) { return std::tie(a.grid2_u.first, a.grid2_u.last, a.grid2_v.first, a.grid2_v.last); }),
    row(kGL_MAP2_GRID_SEGMENTS, kGL_EVAL_BIT, [](auto& a) { return std::tie(a.grid2_u.segments, a.grid2_v.segments); }),
    row(kGL_LIST_BASE, kGL_LIST_BIT, AT(list_base)),
};
#undef AT

}  // namespace

std::span<const StateVariable> state_variables() { return kRows; }

const StateVariable* find_state_variable(Enum pname) {
    static const auto by_name = [] {
        std::unordered_map<Enum, const StateVariable*> rows;
        for (const StateVariable& one : kRows)
            if (one.pname != 0) rows.emplace(one.pname, &one);
        return rows;
    }();
    const auto found = by_name.find(pname);
    return found == by_name.end() ? nullptr : found->second;
}

}  // namespace twinlight
