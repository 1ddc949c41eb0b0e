// glGet* (6.1), answered from State.
#include "scene/state/answers.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "base/math/as_float.h"
#include "scene/frame/parameter_rows.h"
#include "scene/state/pixel_unpacking.h"
#include "scene/state/state_variables.h"

namespace twinlight {

namespace {

Answer list(const glm::dvec4& v) { return {v.x, v.y, v.z, v.w}; }
Answer list(const glm::dmat4& m) { return {glm::value_ptr(m), glm::value_ptr(m) + 16}; }
template <class Number>
Answer one(Number value) {
    return {static_cast<double>(value)};
}

// A parameter of an Owner (parameter_rows.h).
template <class Owner>
Answer of(const Owner& owner, Enum pname) {
    const ParameterRow<Owner>* const row = find_parameter_row<Owner>(pname);
    return row ? values_of(owner, *row) : Answer{};
}

Answer of_hints(const Hints& hints, Enum pname) {
    const auto hint = hints.find(pname);
    return hint == hints.end() ? Answer{} : one(hint->second);
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
                       : list(glm::clamp(position.vertex->vertex.further(VertexAttribute::kSecondaryColor), 0.0, 1.0));
        case kGL_CURRENT_RASTER_TEXTURE_COORDS:
            return unit.generated.empty()
                       ? list(unit.texture_matrix * position.vertex->vertex.tex_coord_of(a.active_unit))
                       : Answer{};
        default: return {};
    }
}

Answer of_pixel_maps(const PixelMaps& maps, Enum pname) {
    switch (pname) {
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
    if (const StateVariable* const row = find_state_variable(pname)) return row->values(a);
    for (const Answer& answer :
         {of(a.lighting.light_model, pname), of_hints(a.hints, pname), of(state.pixel_store(), pname),
          of_arrays(state.arrays(), pname), of_raster_position(a, pname), of_pixel_maps(state.pixel_maps(), pname)}) {
        if (!answer.empty()) return answer;
    }
    const TextureBindings& unit = a.units[a.active_unit];
    const glm::dmat4 &texture = state.texture_matrix(), &m = state.modelview(), &p = state.projection();
    switch (pname) {
        case kGL_CURRENT_TEXTURE_COORDS: return list(a.current.tex_coord_of(a.active_unit));
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
    return of(state.bound_texture(target), pname);
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
