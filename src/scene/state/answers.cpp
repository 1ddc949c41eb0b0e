// glGet* (6.1), answered from State.
#include "scene/state/answers.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "base/math/as_float.h"
#include "scene/state/lighting_parameters.h"
#include "scene/state/pixel_unpacking.h"

namespace twinlight {

namespace {

Answer list(const glm::dvec4& v) { return {v.x, v.y, v.z, v.w}; }
Answer list(const glm::dmat4& m) { return {glm::value_ptr(m), glm::value_ptr(m) + 16}; }
Answer list(const Viewport& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.width),
            static_cast<double>(v.height)};
}
template <class Number>
Answer one(Number value) {
    return {static_cast<double>(value)};
}

Answer of_lighting(const LightingState& lighting, Enum pname) {
    if (const auto* const of_model = find_lighting_parameter<LightModel>(pname))
        return values_of(lighting.light_model, *of_model);
    switch (pname) {
        case kGL_COLOR_MATERIAL_FACE: return one(lighting.color_material.face);
        case kGL_COLOR_MATERIAL_PARAMETER: return one(lighting.color_material.mode);
        case kGL_SHADE_MODEL: return one(lighting.shade_model);
        default: return {};
    }
}

Answer of_raster(const RasterState& raster, Enum pname) {
    const PointParameters& points = raster.point_parameters;
    const glm::dvec3& attenuation = points.distance_attenuation;
    switch (pname) {
        case kGL_VIEWPORT: return list(raster.viewport);
        case kGL_DEPTH_RANGE: return {raster.depth_near, raster.depth_far};
        case kGL_FRONT_FACE: return one(raster.front_face);
        case kGL_CULL_FACE_MODE: return one(raster.cull_face);
        case kGL_POLYGON_MODE:
            return {static_cast<double>(raster.polygon_mode_front), static_cast<double>(raster.polygon_mode_back)};
        case kGL_POLYGON_OFFSET_FACTOR: return one(raster.polygon_offset.factor);
        case kGL_POLYGON_OFFSET_UNITS: return one(raster.polygon_offset.units);
        case kGL_LINE_WIDTH: return one(raster.line_width);
        case kGL_POINT_SIZE: return one(raster.point_size);
        case kGL_POINT_SIZE_MIN: return one(points.size_min);
        case kGL_POINT_SIZE_MAX: return one(points.size_max);
        case kGL_POINT_FADE_THRESHOLD_SIZE: return one(points.fade_threshold_size);
        case kGL_POINT_DISTANCE_ATTENUATION: return {attenuation.x, attenuation.y, attenuation.z};
        case kGL_POINT_SPRITE_COORD_ORIGIN: return one(points.sprite_coord_origin);
        case kGL_DEPTH_FUNC: return one(raster.depth_func);
        case kGL_DEPTH_WRITEMASK: return one(raster.depth_mask);
        default: return {};
    }
}

Answer of_fragments(const FragmentState& fragment, const Fog& fog, const Clear& clear, Enum pname) {
    switch (pname) {
        case kGL_SCISSOR_BOX: return list(fragment.scissor.box);
        case kGL_ALPHA_TEST_FUNC: return one(fragment.alpha_func);
        case kGL_ALPHA_TEST_REF: return one(fragment.alpha_ref);
        case kGL_BLEND_SRC:
        case kGL_BLEND_SRC_RGB: return one(fragment.blend_src);
        case kGL_BLEND_DST:
        case kGL_BLEND_DST_RGB: return one(fragment.blend_dst);
        case kGL_BLEND_SRC_ALPHA: return one(fragment.blend_src_alpha);
        case kGL_BLEND_DST_ALPHA: return one(fragment.blend_dst_alpha);
        case kGL_BLEND_EQUATION: return one(fragment.blend_equation);
        case kGL_BLEND_EQUATION_ALPHA: return one(fragment.blend_equation_alpha);
        case kGL_BLEND_COLOR: return list(fragment.blend_color);
        case kGL_COLOR_WRITEMASK: return {fragment.color_mask.begin(), fragment.color_mask.end()};
        case kGL_FOG_MODE: return one(fog.mode);
        case kGL_FOG_DENSITY: return one(fog.density);
        case kGL_FOG_START: return one(fog.start);
        case kGL_FOG_END: return one(fog.end);
        case kGL_FOG_COLOR: return list(fog.color);
        case kGL_FOG_COORD_SRC: return one(fog.by_coordinates ? kGL_FOG_COORD : kGL_FRAGMENT_DEPTH);
        case kGL_COLOR_CLEAR_VALUE: return list(clear.clear_color);
        case kGL_DEPTH_CLEAR_VALUE: return one(clear.clear_depth);
        default: return {};
    }
}

// Tables 6.12, 6.21, 6.22, 6.23.
Answer of_buffers(const Attributes& a, Enum pname) {
    const StencilFace &front = a.stencil_test.front, &back = a.stencil_test.back;
    const auto ref = [](const StencilFace& face) { return one(std::clamp(face.ref, 0, kMaxStencil)); };
    switch (pname) {
        case kGL_STENCIL_FUNC: return one(front.func);
        case kGL_STENCIL_REF: return ref(front);
        case kGL_STENCIL_VALUE_MASK: return one(front.mask);
        case kGL_STENCIL_FAIL: return one(front.fail);
        case kGL_STENCIL_PASS_DEPTH_FAIL: return one(front.depth_fail);
        case kGL_STENCIL_PASS_DEPTH_PASS: return one(front.depth_pass);
        case kGL_STENCIL_WRITEMASK: return one(front.write_mask);
        case kGL_STENCIL_BACK_FUNC: return one(back.func);
        case kGL_STENCIL_BACK_REF: return ref(back);
        case kGL_STENCIL_BACK_VALUE_MASK: return one(back.mask);
        case kGL_STENCIL_BACK_FAIL: return one(back.fail);
        case kGL_STENCIL_BACK_PASS_DEPTH_FAIL: return one(back.depth_fail);
        case kGL_STENCIL_BACK_PASS_DEPTH_PASS: return one(back.depth_pass);
        case kGL_STENCIL_BACK_WRITEMASK: return one(back.write_mask);
        case kGL_LINE_STIPPLE_PATTERN: return one(a.line_stipple.pattern);
        case kGL_LINE_STIPPLE_REPEAT: return one(a.line_stipple.factor);
        case kGL_LOGIC_OP_MODE: return one(a.logic_op);
        case kGL_STENCIL_CLEAR_VALUE: return one(a.clear.clear_stencil);
        case kGL_ACCUM_CLEAR_VALUE: return list(a.clear.clear_accumulation);
        default: return {};
    }
}

Answer of_hints(const Hints& hints, Enum pname) {
    const auto hint = hints.find(pname);
    return hint == hints.end() ? Answer{} : one(hint->second);
}

Answer of_pixel_store(const PixelStore& store, Enum pname) {
    const auto* row = std::ranges::find(kPixelStoreRows, pname, &PixelStoreRow::pname);
    return row == std::end(kPixelStoreRows) ? Answer{} : one(row->value(store));
}

// Table 6.5. Nothing where only a renderer knows the answer: the colour of a lit raster position, texture coordinates
// that are generated.
Answer of_raster_position(const Attributes& a, Enum pname) {
    const RasterPosition& position = a.raster_position;
    const RasterVertex::Unit& unit = position.vertex->units[a.active_unit];
    if (pname == kGL_CURRENT_RASTER_POSITION_VALID && !position.is_doubtful) return one(position.is_valid);
    if (!position.is_valid || position.is_doubtful) return {};
    switch (pname) {
        case kGL_CURRENT_RASTER_POSITION: return list(position.position_window);
        case kGL_CURRENT_RASTER_COLOR:
            return position.vertex->lighting.enabled ? Answer{}
                                                     : list(glm::clamp(position.vertex->vertex.color, 0.0, 1.0));
        case kGL_CURRENT_RASTER_SECONDARY_COLOR:
            return position.vertex->lighting.enabled
                       ? Answer{}
                       : list(glm::dvec4(glm::clamp(position.vertex->secondary_color, 0.0, 1.0), 1));
        case kGL_CURRENT_RASTER_TEXTURE_COORDS:
            return unit.generated.empty() ? list(unit.texture_matrix * unit.tex_coord) : Answer{};
        default: return {};
    }
}

// Tables 6.25 and 6.26.
Answer of_pixel_transfer(const Attributes& a, const PixelMaps& maps, Enum pname) {
    const PixelTransfer& transfer = a.pixel_transfer;
    switch (pname) {
        case kGL_MAP_COLOR: return one(transfer.map_color);
        case kGL_MAP_STENCIL: return one(a.stencil_transfer.map);
        case kGL_INDEX_SHIFT: return one(a.stencil_transfer.shift);
        case kGL_INDEX_OFFSET: return one(a.stencil_transfer.offset);
        case kGL_RED_SCALE: return one(transfer.scale.r);
        case kGL_GREEN_SCALE: return one(transfer.scale.g);
        case kGL_BLUE_SCALE: return one(transfer.scale.b);
        case kGL_ALPHA_SCALE: return one(transfer.scale.a);
        case kGL_RED_BIAS: return one(transfer.bias.r);
        case kGL_GREEN_BIAS: return one(transfer.bias.g);
        case kGL_BLUE_BIAS: return one(transfer.bias.b);
        case kGL_ALPHA_BIAS: return one(transfer.bias.a);
        case kGL_DEPTH_SCALE: return one(transfer.depth_scale);
        case kGL_DEPTH_BIAS: return one(transfer.depth_bias);
        case kGL_ZOOM_X: return one(a.pixel_zoom.x);
        case kGL_ZOOM_Y: return one(a.pixel_zoom.y);
        case kGL_PIXEL_MAP_R_TO_R_SIZE:
        case kGL_PIXEL_MAP_G_TO_G_SIZE:
        case kGL_PIXEL_MAP_B_TO_B_SIZE:
        case kGL_PIXEL_MAP_A_TO_A_SIZE: return one(maps[pname - kGL_PIXEL_MAP_R_TO_R_SIZE].size());
        case kGL_MAX_PIXEL_MAP_TABLE: return one(kMaxPixelMap);
        default: return {};
    }
}

// Tables 6.6 to 6.9.
Answer of_arrays(const VertexArrays& arrays, Enum pname) {
    const ClientArrays& client = arrays.client();
    const ArrayPointer& tex_coord = client.tex_coord[client.active_unit];
    struct Row {
        Enum array, size, type, stride, buffer;
        const ArrayPointer* pointer;
    };
    const Row rows[] = {
        {kGL_VERTEX_ARRAY, kGL_VERTEX_ARRAY_SIZE, kGL_VERTEX_ARRAY_TYPE, kGL_VERTEX_ARRAY_STRIDE,
         kGL_VERTEX_ARRAY_BUFFER_BINDING, &client.vertex},
        {kGL_NORMAL_ARRAY, 0, kGL_NORMAL_ARRAY_TYPE, kGL_NORMAL_ARRAY_STRIDE, kGL_NORMAL_ARRAY_BUFFER_BINDING,
         &client.normal},
        {kGL_COLOR_ARRAY, kGL_COLOR_ARRAY_SIZE, kGL_COLOR_ARRAY_TYPE, kGL_COLOR_ARRAY_STRIDE,
         kGL_COLOR_ARRAY_BUFFER_BINDING, &client.color},
        {kGL_TEXTURE_COORD_ARRAY, kGL_TEXTURE_COORD_ARRAY_SIZE, kGL_TEXTURE_COORD_ARRAY_TYPE,
         kGL_TEXTURE_COORD_ARRAY_STRIDE, kGL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, &tex_coord},
        {kGL_EDGE_FLAG_ARRAY, 0, 0, kGL_EDGE_FLAG_ARRAY_STRIDE, kGL_EDGE_FLAG_ARRAY_BUFFER_BINDING, &client.edge_flag},
    };
    for (const Row& row : rows) {
        if (pname == 0) break;
        if (pname == row.array) return one(row.pointer->enabled);
        if (pname == row.size) return one(row.pointer->size);
        if (pname == row.type) return one(row.pointer->type);
        if (pname == row.stride) return one(row.pointer->stride);
        if (pname == row.buffer) return one(row.pointer->buffer);
    }
    switch (pname) {
        case kGL_ARRAY_BUFFER_BINDING: return one(client.array_buffer);
        case kGL_ELEMENT_ARRAY_BUFFER_BINDING: return one(client.element_buffer);
        case kGL_PIXEL_PACK_BUFFER_BINDING: return one(arrays.pixel_pack_name());
        case kGL_PIXEL_UNPACK_BUFFER_BINDING: return one(arrays.pixel_unpack_name());
        case kGL_CLIENT_ACTIVE_TEXTURE: return one(kGL_TEXTURE0 + client.active_unit);
        case kGL_CLIENT_ATTRIB_STACK_DEPTH: return one(arrays.stack_depth());
        default: return {};
    }
}

}  // namespace

Answer answer(const State& state, Enum pname) {
    if (const auto on = state.capability(pname)) return one(*on);
    const Attributes& a = state.attributes();
    for (const Answer& answer :
         {of_lighting(a.lighting, pname), of_raster(a.raster, pname), of_fragments(a.fragment, a.fog, a.clear, pname),
          of_buffers(a, pname), of_hints(a.hints, pname), of_pixel_store(state.pixel_store(), pname),
          of_arrays(state.arrays(), pname), of_raster_position(a, pname),
          of_pixel_transfer(a, state.pixel_maps(), pname)}) {
        if (!answer.empty()) return answer;
    }
    const TextureBindings& unit = a.units[a.active_unit];
    const glm::dmat4 &texture = state.texture_matrix(), &m = state.modelview(), &p = state.projection();
    switch (pname) {
        case kGL_CURRENT_COLOR: return list(a.current.color);
        case kGL_CURRENT_SECONDARY_COLOR: return list(glm::dvec4(a.secondary_color, 1));
        case kGL_CURRENT_FOG_COORD: return one(a.fog_coord);
        case kGL_CURRENT_NORMAL: {
            const glm::dvec3& n = a.current.normal_object;
            return {n.x, n.y, n.z};
        }
        case kGL_CURRENT_TEXTURE_COORDS: return list(a.tex_coord(a.active_unit));
        case kGL_EDGE_FLAG: return one(a.current.edge_flag);
        case kGL_MATRIX_MODE: return one(a.matrix_mode);
        case kGL_MODELVIEW_MATRIX: return list(m);
        case kGL_PROJECTION_MATRIX: return list(p);
        case kGL_TEXTURE_MATRIX: return list(texture);
        case kGL_TRANSPOSE_MODELVIEW_MATRIX: return list(glm::transpose(m));
        case kGL_TRANSPOSE_PROJECTION_MATRIX: return list(glm::transpose(p));
        case kGL_TRANSPOSE_TEXTURE_MATRIX: return list(glm::transpose(texture));
        case kGL_MODELVIEW_STACK_DEPTH: return one(state.matrix_depth(kGL_MODELVIEW));
        case kGL_PROJECTION_STACK_DEPTH: return one(state.matrix_depth(kGL_PROJECTION));
        case kGL_TEXTURE_STACK_DEPTH: return one(state.matrix_depth(kGL_TEXTURE));
        case kGL_ATTRIB_STACK_DEPTH: return one(state.attribute_depth());
        case kGL_RENDER_MODE: return one(state.render_mode());
        case kGL_ACTIVE_TEXTURE: return one(kGL_TEXTURE0 + a.active_unit);
        case kGL_LIST_BASE: return one(a.list_base);
        case kGL_TEXTURE_BINDING_1D: return one(unit.bound_1d);
        case kGL_TEXTURE_BINDING_2D: return one(unit.bound_2d);
        case kGL_TEXTURE_BINDING_3D: return one(unit.bound_3d);
        case kGL_TEXTURE_BINDING_CUBE_MAP: return one(unit.bound_cube);
        case kGL_FRAMEBUFFER_BINDING: return one(state.framebuffers().draw);
        case kGL_READ_FRAMEBUFFER_BINDING: return one(state.framebuffers().read);
        case kGL_RENDERBUFFER_BINDING: return one(state.framebuffers().renderbuffer);
        case kGL_MAX_RENDERBUFFER_SIZE: return one(kMaxRenderbufferSize);
        case kGL_MAX_COLOR_ATTACHMENTS: return one(kMaxColorAttachments);
        case kGL_LIST_INDEX: return one(state.lists().open_name);
        case kGL_LIST_MODE: return one(state.lists().open_name == 0 ? 0 : state.lists().open_mode);
        case kGL_MAX_LIST_NESTING: return one(kMaxListNesting);
        case kGL_MAP1_GRID_DOMAIN: return {a.grid1.first, a.grid1.last};
        case kGL_MAP1_GRID_SEGMENTS: return one(a.grid1.segments);
        case kGL_MAP2_GRID_DOMAIN: return {a.grid2_u.first, a.grid2_u.last, a.grid2_v.first, a.grid2_v.last};
        case kGL_MAP2_GRID_SEGMENTS:
            return {static_cast<double>(a.grid2_u.segments), static_cast<double>(a.grid2_v.segments)};
        case kGL_MAX_EVAL_ORDER: return one(kMaxEvalOrder);
        case kGL_MAX_LIGHTS: return one(kMaxLights);
        case kGL_MAX_CLIP_PLANES: return one(kMaxClipPlanes);
        case kGL_MAX_TEXTURE_SIZE: return one(kMaxTextureSize);
        case kGL_MAX_3D_TEXTURE_SIZE: return one(kMax3dTextureSize);
        case kGL_MAX_TEXTURE_UNITS: return one(kMaxTextureUnits);
        case kGL_MAX_TEXTURE_LOD_BIAS: return one(kMaxLodBias);
        case kGL_MAX_TEXTURE_MAX_ANISOTROPY_EXT: return one(kMaxAnisotropy);
        default: return {};
    }
}

Answer clip_plane_answer(const State& state, Enum plane) {
    if (plane < kGL_CLIP_PLANE0 || plane >= kGL_CLIP_PLANE0 + kMaxClipPlanes) return {};
    return list(state.attributes().clip_planes[plane - kGL_CLIP_PLANE0].equation_eye);
}

Answer tex_env_answer(const State& state, Enum target, Enum pname) {
    const TextureBindings& unit = state.attributes().units[state.attributes().active_unit];
    if (target == kGL_TEXTURE_FILTER_CONTROL && pname == kGL_TEXTURE_LOD_BIAS) return one(unit.lod_bias);
    if (target == kGL_POINT_SPRITE && pname == kGL_COORD_REPLACE) return one(unit.coord_replace);
    if (target != kGL_TEXTURE_ENV) return {};
    const Combine& combine = unit.combine;
    switch (pname) {
        case kGL_TEXTURE_ENV_MODE: return one(unit.env_mode);
        case kGL_TEXTURE_ENV_COLOR: return list(unit.env_color);
        case kGL_COMBINE_RGB: return one(combine.rgb);
        case kGL_COMBINE_ALPHA: return one(combine.alpha);
        case kGL_RGB_SCALE: return one(combine.rgb_scale);
        case kGL_ALPHA_SCALE: return one(combine.alpha_scale);
        case kGL_SRC0_RGB:
        case kGL_SRC1_RGB:
        case kGL_SRC2_RGB: return one(combine.rgb_sources[pname - kGL_SRC0_RGB]);
        case kGL_SRC0_ALPHA:
        case kGL_SRC1_ALPHA:
        case kGL_SRC2_ALPHA: return one(combine.alpha_sources[pname - kGL_SRC0_ALPHA]);
        case kGL_OPERAND0_RGB:
        case kGL_OPERAND1_RGB:
        case kGL_OPERAND2_RGB: return one(combine.rgb_operands[pname - kGL_OPERAND0_RGB]);
        case kGL_OPERAND0_ALPHA:
        case kGL_OPERAND1_ALPHA:
        case kGL_OPERAND2_ALPHA: return one(combine.alpha_operands[pname - kGL_OPERAND0_ALPHA]);
        default: return {};
    }
}

Answer tex_gen_answer(const State& state, Enum coord, Enum pname) {
    if (coord < kGL_S || coord > kGL_Q) return {};
    const TexGen& gen = state.attributes().units[state.attributes().active_unit].tex_gen[coord - kGL_S];
    switch (pname) {
        case kGL_TEXTURE_GEN_MODE: return one(gen.mode);
        case kGL_OBJECT_PLANE: return list(gen.object_plane);
        case kGL_EYE_PLANE: return list(gen.plane_eye);
        default: return {};
    }
}

Answer tex_parameter_answer(const State& state, Enum target, Enum pname) {
    if (std::ranges::find(kTextureTargets, target) == kTextureTargets.end()) return {};
    const Texture& texture = state.bound_texture(target);
    switch (pname) {
        case kGL_TEXTURE_MIN_FILTER: return one(texture.min_filter);
        case kGL_TEXTURE_MAG_FILTER: return one(texture.mag_filter);
        case kGL_TEXTURE_WRAP_S: return one(texture.wrap_s);
        case kGL_TEXTURE_WRAP_T: return one(texture.wrap_t);
        case kGL_TEXTURE_WRAP_R: return one(texture.wrap_r);
        case kGL_TEXTURE_BORDER_COLOR: return list(texture.border_color);
        case kGL_TEXTURE_PRIORITY: return one(texture.priority);
        case kGL_GENERATE_MIPMAP: return one(texture.generate_mipmap);
        case kGL_TEXTURE_LOD_BIAS: return one(texture.lod_bias);
        case kGL_TEXTURE_MIN_LOD: return one(texture.min_lod);
        case kGL_TEXTURE_MAX_LOD: return one(texture.max_lod);
        case kGL_TEXTURE_BASE_LEVEL: return one(texture.base_level);
        case kGL_TEXTURE_MAX_LEVEL: return one(texture.max_level);
        case kGL_TEXTURE_MAX_ANISOTROPY_EXT: return one(texture.max_anisotropy);
        case kGL_DEPTH_TEXTURE_MODE: return one(texture.depth_mode);
        case kGL_TEXTURE_COMPARE_MODE: return one(texture.compare_mode);
        case kGL_TEXTURE_COMPARE_FUNC: return one(texture.compare_func);
        default: return {};
    }
}

Answer tex_level_answer(const State& state, Enum target, int level, Enum pname) {
    const std::optional<ImageTarget> named = image_target(target);
    if (!named || level < 0) return {};
    const std::vector<TextureImage>& levels = state.bound_texture(named->texture).face(named->face);
    const auto index = static_cast<std::size_t>(level);
    const bool has_image = index < levels.size() && !levels[index].texels.empty();
    const TextureImage* const image = has_image ? &levels[index] : nullptr;
    switch (pname) {
        case kGL_TEXTURE_WIDTH: return one(image ? image->width : 0);
        case kGL_TEXTURE_HEIGHT: return one(image ? image->height : 0);
        case kGL_TEXTURE_DEPTH: return one(image ? image->depth : 0);
        case kGL_TEXTURE_BORDER: return one(0);
        case kGL_TEXTURE_INTERNAL_FORMAT: return one(image ? image->internal_format : 1);
        case kGL_TEXTURE_DEPTH_SIZE: {
            const bool has_depths = image && image->base_format == kGL_DEPTH_COMPONENT;
            return one(has_depths ? internal_format(image->internal_format)->red : 0);
        }
        default: return {};
    }
}

bool is_answered(CommandId id) {
    switch (id) {
        case CommandId::glGetLightfv:
        case CommandId::glGetLightiv:
        case CommandId::glGetMaterialfv:
        case CommandId::glGetMaterialiv:
        case CommandId::glGetBooleanv:
        case CommandId::glGetIntegerv:
        case CommandId::glGetFloatv:
        case CommandId::glGetDoublev:
        case CommandId::glGetClipPlane:
        case CommandId::glGetTexEnvfv:
        case CommandId::glGetTexEnviv:
        case CommandId::glGetTexGenfv:
        case CommandId::glGetTexGendv:
        case CommandId::glGetTexGeniv:
        case CommandId::glGetTexParameterfv:
        case CommandId::glGetTexParameteriv:
        case CommandId::glIsEnabled: return true;
        default: return false;
    }
}

namespace {

// Whether glGetIntegerv maps this value from [-1, 1] to all integers (6.1.2).
bool is_fraction(const Command& query) {
    if (owner_of(query.id)) {
        const ParameterInfo* info = parameter_info(query);
        return info && info->meaning == Meaning::kColor;
    }
    switch (query.enumerant(0)) {
        case kGL_CURRENT_COLOR:
        case kGL_CURRENT_SECONDARY_COLOR:
        case kGL_CURRENT_NORMAL:
        case kGL_FOG_COLOR:
        case kGL_LIGHT_MODEL_AMBIENT:
        case kGL_COLOR_CLEAR_VALUE:
        case kGL_ACCUM_CLEAR_VALUE:
        case kGL_BLEND_COLOR:
        case kGL_ALPHA_TEST_REF:
        case kGL_DEPTH_RANGE:
        case kGL_DEPTH_CLEAR_VALUE: return true;
        default: return false;
    }
}

Answer answer_in_doubles(const State& state, const Command& query) {
    switch (query.id) {
        case CommandId::glGetLightfv:
        case CommandId::glGetLightiv: return state.get_light(query.enumerant(0), query.enumerant(1));
        case CommandId::glGetMaterialfv:
        case CommandId::glGetMaterialiv: return state.get_material(query.enumerant(0), query.enumerant(1));
        case CommandId::glGetClipPlane: return clip_plane_answer(state, query.enumerant(0));
        case CommandId::glGetTexEnvfv:
        case CommandId::glGetTexEnviv: return tex_env_answer(state, query.enumerant(0), query.enumerant(1));
        case CommandId::glGetTexGenfv:
        case CommandId::glGetTexGendv:
        case CommandId::glGetTexGeniv: return tex_gen_answer(state, query.enumerant(0), query.enumerant(1));
        case CommandId::glGetTexParameterfv:
        case CommandId::glGetTexParameteriv: return tex_parameter_answer(state, query.enumerant(0), query.enumerant(1));
        default: return answer(state, query.enumerant(0));
    }
}

}  // namespace

// 6.1.2.
Answer answer(const State& state, const Command& query) {
    Answer values = answer_in_doubles(state, query);
    const Kind kind = query.sig().parameters.back().kind;
    const bool fraction = kind == Kind::kInt && is_fraction(query);
    for (double& value : values) {
        if (kind == Kind::kBoolean) value = value != 0 ? 1 : 0;
        if (kind == Kind::kInt) value = std::nearbyint(fraction ? (4294967295.0 * value - 1) / 2 : value);
        if (kind == Kind::kFloat) value = as_float(value);
    }
    return values;
}

}  // namespace twinlight
