// glPushAttrib and glPopAttrib (6.1.14): which bit saves what, after tables 6.5 to 6.35.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "scene/state/capabilities.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// Every capability, for GL_ENABLE_BIT; `pick` takes the state of one from the saved attributes.
void restore_enables(Attributes& now, const Attributes& saved) {
    now.lighting.enabled = saved.lighting.enabled;
    for (std::size_t i = 0; i < kMaxLights; ++i) {
        now.lighting.lights[i].enabled = saved.lighting.lights[i].enabled;
    }
    for (std::size_t i = 0; i < saved.clip_planes.size(); ++i) {
        now.clip_planes[i].enabled = saved.clip_planes[i].enabled;
    }
    now.lighting.color_material.enabled = saved.lighting.color_material.enabled;
    now.lighting.normalize = saved.lighting.normalize;
    now.lighting.rescale_normal = saved.lighting.rescale_normal;
    now.raster.cull_enabled = saved.raster.cull_enabled;
    now.raster.depth_test = saved.raster.depth_test;
    now.raster.polygon_offset.point = saved.raster.polygon_offset.point;
    now.raster.polygon_offset.line = saved.raster.polygon_offset.line;
    now.raster.polygon_offset.fill = saved.raster.polygon_offset.fill;
    now.fragment.scissor.enabled = saved.fragment.scissor.enabled;
    now.fragment.alpha_test = saved.fragment.alpha_test;
    now.fragment.blend = saved.fragment.blend;
    now.fragment.color_sum = saved.fragment.color_sum;
    now.fog.enabled = saved.fog.enabled;
    for (std::size_t i = 0; i < saved.units.size(); ++i) {
        now.units[i].enabled_1d = saved.units[i].enabled_1d;
        now.units[i].enabled_2d = saved.units[i].enabled_2d;
    }
}

void restore_lighting(LightingState& now, const LightingState& saved) {
    const bool normalize = now.normalize, rescale = now.rescale_normal;  // of GL_TRANSFORM_BIT
    now = saved;
    now.normalize = normalize;
    now.rescale_normal = rescale;
}

void restore_color_buffer(Attributes& now, const Attributes& saved) {
    const Scissor scissor = now.fragment.scissor;   // of GL_SCISSOR_BIT
    const bool color_sum = now.fragment.color_sum;  // of GL_FOG_BIT
    now.fragment = saved.fragment;
    now.fragment.scissor = scissor;
    now.fragment.color_sum = color_sum;
    now.clear.clear_color = saved.clear.clear_color;
    now.draws_color = saved.draws_color;
}

void restore_polygon(RasterState& now, const RasterState& saved) {
    now.front_face = saved.front_face;
    now.cull_enabled = saved.cull_enabled;
    now.cull_face = saved.cull_face;
    now.polygon_mode_front = saved.polygon_mode_front;
    now.polygon_mode_back = saved.polygon_mode_back;
    now.polygon_offset = saved.polygon_offset;
}

void restore_depth(Attributes& now, const Attributes& saved) {
    now.raster.depth_test = saved.raster.depth_test;
    now.raster.depth_func = saved.raster.depth_func;
    now.raster.depth_mask = saved.raster.depth_mask;
    now.clear.clear_depth = saved.clear.clear_depth;
}

void restore_transform(Attributes& now, const Attributes& saved) {
    now.matrix_mode = saved.matrix_mode;
    now.clip_planes = saved.clip_planes;
    now.lighting.normalize = saved.lighting.normalize;
    now.lighting.rescale_normal = saved.lighting.rescale_normal;
}

void restore(Attributes& now, const Attributes& saved, Enum mask) {
    const auto bit = [mask](Enum one) { return (mask & one) != 0; };
    if (bit(kGL_CURRENT_BIT)) {
        now.current = saved.current;
        now.secondary_color = saved.secondary_color;
    }
    if (bit(kGL_POINT_BIT)) {
        now.raster.point_size = saved.raster.point_size;
        now.point_parameters = saved.point_parameters;
    }
    if (bit(kGL_LINE_BIT)) now.raster.line_width = saved.raster.line_width;
    if (bit(kGL_POLYGON_BIT)) restore_polygon(now.raster, saved.raster);
    if (bit(kGL_LIGHTING_BIT)) restore_lighting(now.lighting, saved.lighting);
    if (bit(kGL_FOG_BIT)) {
        now.fog = saved.fog;
        now.fog_coordinates = saved.fog_coordinates;
        now.fragment.color_sum = saved.fragment.color_sum;
    }
    if (bit(kGL_DEPTH_BUFFER_BIT)) restore_depth(now, saved);
    if (bit(kGL_VIEWPORT_BIT)) {
        now.raster.viewport = saved.raster.viewport;
        now.raster.depth_near = saved.raster.depth_near;
        now.raster.depth_far = saved.raster.depth_far;
    }
    if (bit(kGL_TRANSFORM_BIT)) restore_transform(now, saved);
    if (bit(kGL_ENABLE_BIT)) restore_enables(now, saved);
    if (bit(kGL_COLOR_BUFFER_BIT)) restore_color_buffer(now, saved);
    if (bit(kGL_HINT_BIT)) now.hints = saved.hints;
    if (bit(kGL_LIST_BIT)) now.list_base = saved.list_base;
    if (bit(kGL_TEXTURE_BIT)) {
        now.units = saved.units;
        now.active_unit = saved.active_unit;
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

// The parameters of a texture (table 6.16 and 6.17), not its images.
bool same_parameters(const Texture& a, const Texture& b) {
    return a.min_filter == b.min_filter && a.mag_filter == b.mag_filter && a.wrap_s == b.wrap_s &&
           a.wrap_t == b.wrap_t && a.border_color == b.border_color && a.priority == b.priority &&
           a.generate_mipmap == b.generate_mipmap;
}

void restore_parameters(Texture& now, const Texture& saved) {
    now.min_filter = saved.min_filter;
    now.mag_filter = saved.mag_filter;
    now.wrap_s = saved.wrap_s;
    now.wrap_t = saved.wrap_t;
    now.border_color = saved.border_color;
    now.priority = saved.priority;
    now.generate_mipmap = saved.generate_mipmap;
}

}  // namespace

void State::push_attrib(const Command& c) {
    if (attribute_stack_.size() >= kAttributeStackDepth) {
        return raise(
            kGL_STACK_OVERFLOW, c,
            fmt::format("the attribute stack holds {} levels; a glPopAttrib is missing", kAttributeStackDepth));
    }
    const auto parameters = [this](Enum target) {
        Texture saved;
        restore_parameters(saved, bound_texture(target));
        return saved;
    };
    attribute_stack_.push_back({a_, c.enumerant(0), parameters(kGL_TEXTURE_1D), parameters(kGL_TEXTURE_2D), c.place});
}

void State::pop_attrib(const Command& c) {
    if (attribute_stack_.empty()) {
        return raise(kGL_STACK_UNDERFLOW, c, "glPopAttrib without a glPushAttrib");
    }
    const SavedAttributes saved = std::move(attribute_stack_.back());
    attribute_stack_.pop_back();
    restore(a_, saved.attributes, saved.mask);
    if ((saved.mask & kGL_TEXTURE_BIT) == 0) return;
    // What was deleted in between is bound no more (3.8.12), though another may have its name now.
    const auto keep = [this](std::uint32_t& bound, Enum target) {
        const auto found = textures_.named.find(bound);
        if (found == textures_.named.end() || !found->second || found->second->target != target) bound = 0;
    };
    for (TextureBindings& one : a_.units) {
        keep(one.bound_1d, kGL_TEXTURE_1D);
        keep(one.bound_2d, kGL_TEXTURE_2D);
    }
    const auto put_back = [&](Enum target, const Texture& parameters) {
        if (same_parameters(bound_texture(target), parameters)) return;  // a copy would be for nothing
        if (Texture* texture = writable_texture(c, target)) restore_parameters(*texture, parameters);
    };
    put_back(kGL_TEXTURE_1D, saved.texture_1d);
    put_back(kGL_TEXTURE_2D, saved.texture_2d);
}

}  // namespace twinlight
