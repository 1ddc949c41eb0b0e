// Departures in bitmaps and pixel rectangles. Mesa lights a raster position by itself, not as it lights vertices.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "judge/compare/departure_rules.h"
#include "render/lighting_of.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::compare {

namespace {

bool is_lit_label(const Draw& draw) { return draw.pixels && draw.lighting.enabled; }

bool copies(const Draw& draw, CopiedBuffer buffer) {
    return draw.pixels && draw.pixels->copied && draw.pixels->copied->source.pixels->buffer == buffer;
}

}  // namespace

bool has_fog_at_raster_position(const Draw& draw) { return draw.pixels && draw.fog.enabled; }

bool has_raster_position_in_eye_coordinates(const Draw& draw) {
    return is_lit_label(draw) && draw.eye_from_object != glm::dmat4(1) &&
           (draw.lighting.light_model.local_viewer ||
            any_light(draw, [](const LightSource& light) { return !light.is_directional(); }));
}

// The driver takes the current values of glBitmap and glDrawPixels, which a Draw does not know.
bool has_texture_at_raster_position(const Draw& draw) {
    return draw.pixels && (draw.texture.texture || !draw.further_units.empty());
}

bool is_textured_bitmap(const Draw& draw) {
    return has_texture_at_raster_position(draw) && !draw.pixels->image && !draw.pixels->copied;
}

// Every pixel that is drawn lies as far from the pixel that is copied.
bool copies_pixels_without_zoom(const Draw& draw) {
    const bool has_mask = draw.fragment.color_mask != std::array{true, true, true, true};
    if (!copies(draw, CopiedBuffer::kColors) || (!has_mask && !draw.fragment.stencil)) return false;
    const std::vector<glm::ivec2>&to = draw.pixels->places, &from = draw.pixels->copied->places;
    for (std::size_t i = 0; i < to.size(); ++i)
        if (to[i] - from[i] != to[0] - from[0]) return false;
    return true;
}

bool draws_colors_of_copied_depths(const Draw& draw) {
    return copies(draw, CopiedBuffer::kDepths) &&
           (draw.fragment.alpha_test || draw.fragment.color_mask != std::array{false, false, false, false});
}

bool transfers_copied_depths(const Draw& draw) {
    return copies(draw, CopiedBuffer::kDepths) &&
           (draw.pixels->copied->depth_scale != 1 || draw.pixels->copied->depth_bias != 0);
}

bool has_secondary_color_at_raster_position(const Draw& draw) {
    if (draw.pixels && draw.column(VertexAttribute::kSecondaryColor)) return true;
    return is_lit_label(draw) && draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR &&
           glm::dvec3(draw.lighting.front.specular) != glm::dvec3(0) &&
           any_light(draw, [](const LightSource& light) { return glm::dvec3(light.specular) != glm::dvec3(0); });
}

bool has_long_normal_at_raster_position(const Draw& draw) {
    if (!is_lit_label(draw) || (!draw.lighting.normalize && !draw.lighting.rescale_normal)) return false;
    Draw unscaled = draw;
    unscaled.lighting.normalize = unscaled.lighting.rescale_normal = false;
    const Vertex& vertex = draw.vertices[0];
    const glm::dvec3 scaled = reference::vertex_stage(draw, {&vertex, 1}).front().normal_eye,
                     sent = reference::vertex_stage(unscaled, {&vertex, 1}).front().normal_eye;
    constexpr double kRounding = 1e-5;
    return glm::distance(scaled, sent) > kRounding;
}

// The driver leaves a light out if attenuation and spot make it weaker than a thousandth.
bool has_dim_light_at_raster_position(const Draw& draw) {
    return is_lit_label(draw) && any_light(draw, [&](const LightSource& light) {
               const glm::dvec4 eye = draw.eye_from_object * draw.vertices[0].position_object;
               constexpr double kDim = 1.1e-3;
               const double reach = arrival_at(glm::dvec3(eye) / eye.w, light).reach();
               return reach > 0 && reach < kDim;
           });
}

}  // namespace twinlight::compare
