// glGet* (6.1): the state as the query of doubles returns it.
#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "scene/state/capabilities.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

using Answer = std::vector<double>;

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
    switch (pname) {
        case kGL_LIGHT_MODEL_AMBIENT: return list(lighting.light_model.ambient);
        case kGL_LIGHT_MODEL_LOCAL_VIEWER: return one(lighting.light_model.local_viewer);
        case kGL_LIGHT_MODEL_TWO_SIDE: return one(lighting.light_model.two_side);
        case kGL_LIGHT_MODEL_COLOR_CONTROL: return one(lighting.light_model.color_control);
        case kGL_COLOR_MATERIAL_FACE: return one(lighting.color_material.face);
        case kGL_COLOR_MATERIAL_PARAMETER: return one(lighting.color_material.mode);
        case kGL_SHADE_MODEL: return one(lighting.shade_model);
        default: return {};
    }
}

Answer of_raster(const RasterState& raster, Enum pname) {
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
        case kGL_COLOR_CLEAR_VALUE: return list(clear.clear_color);
        case kGL_DEPTH_CLEAR_VALUE: return one(clear.clear_depth);
        default: return {};
    }
}

Answer of_hints(const Hints& hints, Enum pname) {
    switch (pname) {
        case kGL_PERSPECTIVE_CORRECTION_HINT: return one(hints.perspective_correction);
        case kGL_POINT_SMOOTH_HINT: return one(hints.point_smooth);
        case kGL_LINE_SMOOTH_HINT: return one(hints.line_smooth);
        case kGL_POLYGON_SMOOTH_HINT: return one(hints.polygon_smooth);
        case kGL_FOG_HINT: return one(hints.fog);
        case kGL_GENERATE_MIPMAP_HINT: return one(hints.generate_mipmap);
        case kGL_TEXTURE_COMPRESSION_HINT: return one(hints.texture_compression);
        default: return {};
    }
}

Answer of_pixel_store(const PixelStore& store, Enum pname) {
    switch (pname) {
        case kGL_UNPACK_SWAP_BYTES: return one(store.unpack_swap_bytes);
        case kGL_UNPACK_LSB_FIRST: return one(store.unpack_lsb_first);
        case kGL_UNPACK_ROW_LENGTH: return one(store.unpack_row_length);
        case kGL_UNPACK_SKIP_ROWS: return one(store.unpack_skip_rows);
        case kGL_UNPACK_SKIP_PIXELS: return one(store.unpack_skip_pixels);
        case kGL_UNPACK_ALIGNMENT: return one(store.unpack_alignment);
        case kGL_UNPACK_IMAGE_HEIGHT: return one(store.unpack_image_height);
        case kGL_UNPACK_SKIP_IMAGES: return one(store.unpack_skip_images);
        case kGL_PACK_SWAP_BYTES: return one(store.pack_swap_bytes);
        case kGL_PACK_LSB_FIRST: return one(store.pack_lsb_first);
        case kGL_PACK_ROW_LENGTH: return one(store.pack_row_length);
        case kGL_PACK_SKIP_ROWS: return one(store.pack_skip_rows);
        case kGL_PACK_SKIP_PIXELS: return one(store.pack_skip_pixels);
        case kGL_PACK_ALIGNMENT: return one(store.pack_alignment);
        case kGL_PACK_IMAGE_HEIGHT: return one(store.pack_image_height);
        case kGL_PACK_SKIP_IMAGES: return one(store.pack_skip_images);
        default: return {};
    }
}

}  // namespace

std::vector<double> State::get(Enum pname) const {
    if (const bool* followed = const_cast<State*>(this)->followed_capability(pname)) return one(*followed);  // NOLINT
    for (const DriverOnlyCapability& row : driver_only_capabilities()) {
        if (row.cap == pname) return one(a_.driver_only.contains({pname, row.of_unit() ? a_.active_unit : 0}));
    }
    for (const Answer& answer : {of_lighting(a_.lighting, pname), of_raster(a_.raster, pname),
                                 of_fragments(a_.fragment, a_.fog, a_.clear, pname), of_hints(a_.hints, pname),
                                 of_pixel_store(pixel_store_, pname), arrays_.get(pname)}) {
        if (!answer.empty()) return answer;
    }
    const glm::dmat4 &texture = texture_[a_.active_unit].back().matrix, &m = modelview(), &p = projection();
    switch (pname) {
        case kGL_CURRENT_COLOR: return list(a_.current.color);
        case kGL_CURRENT_NORMAL: {
            const glm::dvec3& n = a_.current.normal_object;
            return {n.x, n.y, n.z};
        }
        case kGL_CURRENT_TEXTURE_COORDS:  // the active unit's; those of unit 0 are followed
            return a_.active_unit == 0 ? list(a_.current.tex_coord) : Answer{};
        case kGL_EDGE_FLAG: return one(a_.current.edge_flag);
        case kGL_MATRIX_MODE: return one(a_.matrix_mode);
        case kGL_MODELVIEW_MATRIX: return list(m);
        case kGL_PROJECTION_MATRIX: return list(p);
        case kGL_TEXTURE_MATRIX: return list(texture);
        case kGL_TRANSPOSE_MODELVIEW_MATRIX: return list(glm::transpose(m));
        case kGL_TRANSPOSE_PROJECTION_MATRIX: return list(glm::transpose(p));
        case kGL_TRANSPOSE_TEXTURE_MATRIX: return list(glm::transpose(texture));
        case kGL_MODELVIEW_STACK_DEPTH: return one(modelview_.size());
        case kGL_PROJECTION_STACK_DEPTH: return one(projection_.size());
        case kGL_TEXTURE_STACK_DEPTH: return one(texture_[a_.active_unit].size());
        case kGL_ATTRIB_STACK_DEPTH: return one(attribute_stack_.size());
        case kGL_RENDER_MODE: return one(render_mode_);
        case kGL_ACTIVE_TEXTURE: return one(kGL_TEXTURE0 + a_.active_unit);
        case kGL_LIST_BASE: return one(a_.list_base);
        case kGL_TEXTURE_BINDING_1D: return one(unit().bound_1d);
        case kGL_TEXTURE_BINDING_2D: return one(unit().bound_2d);
        case kGL_LIST_INDEX: return one(lists_.open_name);
        case kGL_LIST_MODE: return one(lists_.open_name == 0 ? 0 : lists_.open_mode);
        case kGL_MAX_LIST_NESTING: return one(kMaxListNesting);
        case kGL_MAX_LIGHTS: return one(kMaxLights);
        case kGL_MAX_CLIP_PLANES: return one(kMaxClipPlanes);
        case kGL_MAX_TEXTURE_SIZE: return one(kMaxTextureSize);
        default: return {};
    }
}

std::vector<double> State::get_clip_plane(Enum plane) const {
    if (plane < kGL_CLIP_PLANE0 || plane >= kGL_CLIP_PLANE0 + kMaxClipPlanes) return {};
    return list(a_.clip_planes[plane - kGL_CLIP_PLANE0].equation_eye);
}

std::vector<double> State::get_tex_env(Enum target, Enum pname) const {
    if (target == kGL_TEXTURE_FILTER_CONTROL && pname == kGL_TEXTURE_LOD_BIAS) return one(unit().lod_bias);
    if (target != kGL_TEXTURE_ENV) return {};
    if (pname == kGL_TEXTURE_ENV_MODE) return one(unit().env_mode);
    return pname == kGL_TEXTURE_ENV_COLOR ? list(unit().env_color) : Answer{};
}

std::vector<double> State::get_tex_parameter(Enum target, Enum pname) const {
    if (target != kGL_TEXTURE_1D && target != kGL_TEXTURE_2D) return {};
    const Texture& texture = *const_cast<State*>(this)->bound_texture(target);  // NOLINT: nothing is changed
    switch (pname) {
        case kGL_TEXTURE_MIN_FILTER: return one(texture.min_filter);
        case kGL_TEXTURE_MAG_FILTER: return one(texture.mag_filter);
        case kGL_TEXTURE_WRAP_S: return one(texture.wrap_s);
        case kGL_TEXTURE_WRAP_T: return one(texture.wrap_t);
        case kGL_TEXTURE_BORDER_COLOR: return list(texture.border_color);
        case kGL_TEXTURE_PRIORITY: return one(texture.priority);
        case kGL_GENERATE_MIPMAP: return one(texture.generate_mipmap);
        default: return {};
    }
}

std::vector<double> State::get_tex_level_parameter(Enum target, int level, Enum pname) const {
    if ((target != kGL_TEXTURE_1D && target != kGL_TEXTURE_2D) || level < 0) return {};
    const Texture& texture = *const_cast<State*>(this)->bound_texture(target);  // NOLINT: nothing is changed
    const bool exists = static_cast<std::size_t>(level) < texture.levels.size();
    const bool has_image = exists && !texture.levels[static_cast<std::size_t>(level)].texels.empty();
    const TextureImage image = has_image ? texture.levels[static_cast<std::size_t>(level)] : TextureImage{.height = 0};
    switch (pname) {
        case kGL_TEXTURE_WIDTH: return one(image.width);
        case kGL_TEXTURE_HEIGHT: return one(image.height);
        case kGL_TEXTURE_BORDER: return one(0);
        case kGL_TEXTURE_INTERNAL_FORMAT: return one(has_image ? image.internal_format : 1);
        default: return {};
    }
}

}  // namespace twinlight
