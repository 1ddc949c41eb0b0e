// The rules of the table in departures.cpp. Each decides whether a driver's known bug may show: in the commands so far, in a Draw,
// or at a vertex of a Draw.
#pragma once

#include <algorithm>

#include "judge/compare/departures.h"

namespace twinlight::compare {

// ---- In the order of commands ----

MakeCommandRule mixes_glcolor3_and_4, mixes_tex_coords, sets_material_before_pop, sets_color_before_pop,
    sets_material_before_tracking, shades_after_pop_in_list, switches_lights_before_pop, generates_mipmaps_after_pop,
    restores_tracked_color, sets_sides_apart, sets_both_sides_after_vertex, sets_color_before_new_mode,
    tracks_color_before_list, lists_edge_flags, shows_cut_of_rectangles, shades_evaluated_meshes_flat,
    draws_others_beside_sprites, maps_drawn_pixels, mirrors_stenciled_pixels, transfers_stencil_values,
    copies_depths_after_mode, blends_over_color_sums, attenuates_points_in_viewport, copies_texels_after_smooth_ones,
    lists_strips_with_late_attributes, draws_loops_with_late_attributes, lists_attributes_after_vertices,
    executes_listed_loops, makes_mipmaps_before_object_draws, stipples_after_framebuffer, enables_incomplete_texture,
    sets_base_above_greatest_level;

bool enables_color_material(const Command& command);
bool draws_other_than_points(const Command& command);

// ---- Between vertices and pixels ----

DrawRule draws_borders_of_clipped_polygons, has_faces_on_borders, has_faces_in_stencil_of_borders, has_smooth_points,
    has_wide_lines, has_level_of_detail, has_edge_flags_in_strip, offsets_other_modes_alone, offsets_one_of_two_modes,
    offsets_borders_without_area, offsets_out_of_range, has_wide_points, biases_level_of_points,
    adds_secondary_color_in_fog, clips_under_singular_projection, contains_no_direction, has_w_in_fog,
    has_exponential_fog_behind_the_eye, has_negative_fog_coords, stipples_listed_strips,
    clamps_between_nearest_and_linear, attenuates_points_aside, has_levels_in_wrong_order, has_sizes_in_wrong_order,
    has_no_size_of_points, has_faces_in_doubt, fills_one_face, has_polygons_as_smooth_lines,
    has_faces_in_stencil_of_lines, has_fog_at_raster_position, has_raster_position_in_eye_coordinates,
    has_secondary_color_at_raster_position, has_long_normal_at_raster_position, has_dim_light_at_raster_position,
    has_texture_at_raster_position, is_textured_bitmap, copies_pixels_without_zoom, draws_colors_of_copied_depths,
    transfers_copied_depths, stipples_in_perspective, has_scissored_sprites, stipples_borders, wraps_cube_maps,
    compares_depths_in_one_dimension, has_eye_plane_of_singular_matrix, has_clipped_wide_points,
    has_sprites_between_sizes, scales_dot3_rgba;
VertexRule has_no_q, has_no_direction_into_cube;

// ---- In lighting ----

// Whether an enabled light of a lit Draw is so.
template <class Predicate>
bool any_light(const Draw& draw, Predicate predicate) {
    return draw.lighting.enabled && std::ranges::any_of(draw.lighting.lights, [&](const LightSource& light) {
               return light.enabled && predicate(light);
           });
}

DrawRule has_shininess, has_shininess_0, has_shininess_0_with_factors, has_shininess_0_on_one_side,
    has_color_material_on_back_alone, rescales_much, has_normals_in_projection;
VertexRule has_w_under_positional_light, has_extreme_direction, has_overflowing_highlight,
    has_w_0_under_directional_light, has_w_0_under_positional_light, has_no_answer, is_at_exact_edge_of_cone,
    is_near_edge_of_cone, has_light_at_horizon;

}  // namespace twinlight::compare
