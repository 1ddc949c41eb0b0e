// glPushAttrib and glPopAttrib (6.1.14). Tables 6.5 to 6.35 list the state that each bit saves.

#include <algorithm>
#include <iterator>
#include <tuple>

#include "scene/state/capabilities.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// Groups of attributes as tuples of references, so that a saved group can be assigned to the current one.

auto capabilities(auto& a) {  // GL_ENABLE_BIT, without lights, clip planes and textures
    return std::tie(a.lighting.enabled, a.lighting.color_material.enabled, a.lighting.normalize,
                    a.lighting.rescale_normal, a.raster.cull_enabled, a.raster.depth_test,
                    a.raster.polygon_offset.point, a.raster.polygon_offset.line, a.raster.polygon_offset.fill,
                    a.fragment.scissor.enabled, a.fragment.alpha_test, a.fragment.blend, a.fragment.color_sum,
                    a.fog.enabled, a.stencil_enabled, a.line_stipple_enabled, a.polygon_stipple_enabled,
                    a.logic_op_enabled, a.raster.line_smooth, a.raster.point_smooth, a.raster.point_sprite);
}

auto line(auto& a) {
    return std::tie(a.raster.line_width, a.raster.line_smooth, a.line_stipple_enabled, a.line_stipple);
}

auto points(auto& a) {
    return std::tie(a.raster.point_size, a.raster.point_smooth, a.raster.point_parameters, a.raster.point_sprite);
}

auto polygon(auto& a) {
    return std::tie(a.raster.front_face, a.raster.cull_enabled, a.raster.cull_face, a.raster.polygon_mode_front,
                    a.raster.polygon_mode_back, a.raster.polygon_offset, a.polygon_stipple_enabled);
}

auto depth(auto& a) {
    return std::tie(a.raster.depth_test, a.raster.depth_func, a.raster.depth_mask, a.clear.clear_depth);
}

auto stencil(auto& a) { return std::tie(a.stencil_enabled, a.stencil_test, a.clear.clear_stencil); }

auto transform(auto& a) {
    return std::tie(a.matrix_mode, a.clip_planes, a.lighting.normalize, a.lighting.rescale_normal);
}

auto viewport(auto& a) { return std::tie(a.raster.viewport, a.raster.depth_near, a.raster.depth_far); }

// The parameters of a texture (tables 6.16 and 6.17), without its images.
auto parameters(auto& texture) {
    return std::tie(texture.min_filter, texture.mag_filter, texture.wrap_s, texture.wrap_t, texture.wrap_r,
                    texture.border_color, texture.priority, texture.generate_mipmap, texture.lod_bias, texture.min_lod,
                    texture.max_lod, texture.base_level, texture.max_level, texture.max_anisotropy);
}

void restore_enables(Attributes& now, const Attributes& saved) {
    capabilities(now) = capabilities(saved);
    for (std::size_t i = 0; i < kMaxLights; ++i) now.lighting.lights[i].enabled = saved.lighting.lights[i].enabled;
    for (std::size_t i = 0; i < saved.clip_planes.size(); ++i)
        now.clip_planes[i].enabled = saved.clip_planes[i].enabled;
    for (std::size_t i = 0; i < saved.units.size(); ++i) {
        now.units[i].enabled_1d = saved.units[i].enabled_1d;
        now.units[i].enabled_2d = saved.units[i].enabled_2d;
        now.units[i].enabled_3d = saved.units[i].enabled_3d;
        now.units[i].enabled_cube = saved.units[i].enabled_cube;
        for (std::size_t n = 0; n < saved.units[i].tex_gen.size(); ++n)
            now.units[i].tex_gen[n].enabled = saved.units[i].tex_gen[n].enabled;
    }
}

void restore_lighting(LightingState& now, const LightingState& saved) {
    const bool normalize = now.normalize, rescale = now.rescale_normal;  // these belong to GL_TRANSFORM_BIT
    now = saved;
    now.normalize = normalize;
    now.rescale_normal = rescale;
}

void restore_color_buffer(Attributes& now, const Attributes& saved) {
    const Scissor scissor = now.fragment.scissor;   // belongs to GL_SCISSOR_BIT
    const bool color_sum = now.fragment.color_sum;  // belongs to GL_FOG_BIT
    now.fragment = saved.fragment;
    now.fragment.scissor = scissor;
    now.fragment.color_sum = color_sum;
    now.clear.clear_color = saved.clear.clear_color;
    now.draws_color = saved.draws_color;
    now.logic_op_enabled = saved.logic_op_enabled;
    now.logic_op = saved.logic_op;
}

void restore(Attributes& now, const Attributes& saved, Enum mask) {
    const auto bit = [mask](Enum one) { return (mask & one) != 0; };
    if (bit(kGL_CURRENT_BIT)) {
        now.current = saved.current;
        now.further_tex_coords = saved.further_tex_coords;
        now.secondary_color = saved.secondary_color;
        now.fog_coord = saved.fog_coord;
        now.raster_position = saved.raster_position;
    }
    if (bit(kGL_POINT_BIT)) {
        points(now) = points(saved);
        for (std::size_t i = 0; i < now.units.size(); ++i) now.units[i].coord_replace = saved.units[i].coord_replace;
    }
    if (bit(kGL_LINE_BIT)) line(now) = line(saved);
    if (bit(kGL_POLYGON_BIT)) polygon(now) = polygon(saved);
    if (bit(kGL_POLYGON_STIPPLE_BIT)) now.polygon_stipple = saved.polygon_stipple;
    if (bit(kGL_LIGHTING_BIT)) restore_lighting(now.lighting, saved.lighting);
    if (bit(kGL_FOG_BIT)) {
        now.fog = saved.fog;
        now.fragment.color_sum = saved.fragment.color_sum;
    }
    if (bit(kGL_DEPTH_BUFFER_BIT)) depth(now) = depth(saved);
    if (bit(kGL_STENCIL_BUFFER_BIT)) stencil(now) = stencil(saved);
    if (bit(kGL_ACCUM_BUFFER_BIT)) now.clear.clear_accumulation = saved.clear.clear_accumulation;
    if (bit(kGL_VIEWPORT_BIT)) viewport(now) = viewport(saved);
    if (bit(kGL_TRANSFORM_BIT)) transform(now) = transform(saved);
    if (bit(kGL_ENABLE_BIT)) restore_enables(now, saved);
    if (bit(kGL_COLOR_BUFFER_BIT)) restore_color_buffer(now, saved);
    if (bit(kGL_EVAL_BIT)) {
        now.grid1 = saved.grid1;
        now.grid2_u = saved.grid2_u;
        now.grid2_v = saved.grid2_v;
    }
    if (bit(kGL_HINT_BIT)) now.hints = saved.hints;
    if (bit(kGL_LIST_BIT)) now.list_base = saved.list_base;
    if (bit(kGL_TEXTURE_BIT)) {
        std::array<bool, kMaxTextureUnits> coord_replace{};  // belongs to GL_POINT_BIT
        for (std::size_t i = 0; i < now.units.size(); ++i) coord_replace[i] = now.units[i].coord_replace;
        now.units = saved.units;
        for (std::size_t i = 0; i < now.units.size(); ++i) now.units[i].coord_replace = coord_replace[i];
        now.active_unit = saved.active_unit;
    }
    if (bit(kGL_PIXEL_MODE_BIT)) {
        now.pixel_transfer = saved.pixel_transfer;
        now.stencil_transfer = saved.stencil_transfer;
        now.pixel_zoom = saved.pixel_zoom;
    }
    if (bit(kGL_SCISSOR_BIT)) now.fragment.scissor = saved.fragment.scissor;
    for (const DriverOnlyCapability& row : driver_only_capabilities()) {
        if (!bit(row.group) && !bit(kGL_ENABLE_BIT)) continue;
        const auto is_of_row = [&row](const auto& on) { return on.first.first == row.cap; };
        std::erase_if(now.driver_only, is_of_row);
        std::copy_if(saved.driver_only.begin(), saved.driver_only.end(),
                     std::inserter(now.driver_only, now.driver_only.end()), is_of_row);
    }
}

}  // namespace

void State::push_attrib(const Command& c) {
    if (attribute_stack_.size() >= kAttributeStackDepth) {
        return raise(kGL_STACK_OVERFLOW, c, "the attribute stack is full ({} levels); a glPopAttrib is missing",
                     kAttributeStackDepth);
    }
    SavedAttributes saved{a_, c.enumerant(0), {}, c.place};
    if (saved.mask & kGL_TEXTURE_BIT)  // 6.1.14: of the textures that are bound in any unit
        for (const TextureBindings& one : a_.units)
            for (const Enum target : kTextureTargets) {
                const auto [at, is_new] = saved.textures.try_emplace({target, one.bound(target)});
                if (is_new) parameters(at->second) = parameters(*texture_of(one, target));
            }
    attribute_stack_.push_back(std::move(saved));
}

void State::pop_attrib(const Command& c) {
    if (attribute_stack_.empty()) return raise(kGL_STACK_UNDERFLOW, c, "glPopAttrib without a glPushAttrib");
    const SavedAttributes saved = std::move(attribute_stack_.back());
    attribute_stack_.pop_back();
    restore(a_, saved.attributes, saved.mask);
    if ((saved.mask & kGL_TEXTURE_BIT) == 0) return;
    // A texture that was deleted in between is no longer bound (3.8.12), even if a new one has its name.
    const auto keep = [this](std::uint32_t& bound, Enum target) {
        const auto found = textures_.named.find(bound);
        if (found == textures_.named.end() || !found->second || found->second->target != target) bound = 0;
    };
    for (TextureBindings& one : a_.units)
        for (const Enum target : kTextureTargets) keep(one.bound(target), target);
    for (const TextureBindings& one : a_.units)
        for (const Enum target : kTextureTargets) {
            const auto found = saved.textures.find({target, one.bound(target)});
            if (found == saved.textures.end() ||
                parameters(*texture_of(one, target)) == parameters(found->second))  // avoids a copy
                continue;
            if (Texture* texture = writable_texture(c, one, target)) parameters(*texture) = parameters(found->second);
        }
}

}  // namespace twinlight
