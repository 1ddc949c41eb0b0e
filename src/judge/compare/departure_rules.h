// The rules of the table in departures.cpp. Each decides whether a driver's known bug may show: in the commands so far, in a Draw,
// or at a vertex of a Draw.
#pragma once

#include "judge/compare/departures.h"

namespace twinlight::compare {

// ---- In the order of commands ----

CommandRule mixes_glcolor3_and_4();
CommandRule mixes_tex_coords();
CommandRule sets_material_before_pop();
CommandRule shades_after_pop_in_list();
CommandRule switches_lights_before_pop();
CommandRule generates_mipmaps_after_pop();
CommandRule restores_tracked_color();
CommandRule sets_sides_apart();
CommandRule sets_both_sides_after_vertex();
CommandRule sets_color_before_new_mode();
CommandRule tracks_color_before_list();
CommandRule lists_edge_flags();
CommandRule shows_cut_of_rectangles();

// ---- Between vertices and pixels ----

bool draws_borders_of_clipped_polygons(const Draw& draw);
bool has_faces_on_borders(const Draw& draw);
bool has_wide_lines(const Draw& draw);
bool has_level_of_detail(const Draw& draw);
bool has_edge_flags_in_strip(const Draw& draw);
bool offsets_other_modes_alone(const Draw& draw);
bool offsets_one_of_two_modes(const Draw& draw);
bool offsets_borders_without_area(const Draw& draw);
bool offsets_borders_out_of_range(const Draw& draw);
bool has_no_q(const Draw& draw, const Vertex& vertex);
bool has_wide_points(const Draw& draw);
bool biases_level_of_points(const Draw& draw);
bool adds_secondary_color_in_fog(const Draw& draw);
bool clamps_between_nearest_and_linear(const Draw& draw);

// ---- In lighting ----

bool has_shininess_0_with_factors(const Draw& draw);
bool has_shininess_0_on_one_side(const Draw& draw);
bool has_color_material_of_no_color(const Draw& draw, const Vertex& vertex);
bool has_color_material_on_back_alone(const Draw& draw);
bool has_w_under_positional_light(const Draw& draw, const Vertex& vertex);
bool has_w_in_fog(const Draw& draw);
bool has_extreme_direction(const Draw& draw, const Vertex& vertex);
bool rescales_much(const Draw& draw);
bool has_no_answer(const Draw& draw, const Vertex& vertex);
bool is_at_exact_edge_of_cone(const Draw& draw, const Vertex& vertex);
bool is_near_edge_of_cone(const Draw& draw, const Vertex& vertex);
bool has_light_at_horizon(const Draw& draw, const Vertex& vertex);

}  // namespace twinlight::compare
