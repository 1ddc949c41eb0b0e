// The table of departures, and the rules that find those of a scene.
#include "judge/compare/departures.h"

#include <algorithm>

#include "judge/compare/departure_rules.h"

namespace twinlight::compare {

namespace {

constexpr SeenOn kBoth[] = {{"llvmpipe"}, {"softpipe"}};
constexpr SeenOn kBothUntilFixed[] = {{"llvmpipe", {.before = "25.0"}}, {"softpipe", {.before = "25.0"}}};
constexpr SeenOn kBothIn25_1[] = {{"llvmpipe", {.from = "25.1", .before = "26.0"}},
                                  {"softpipe", {.from = "25.1", .before = "26.0"}}};
constexpr SeenOn kNvidia[] = {{"NVIDIA"}};
constexpr SeenOn kBothAndNvidia[] = {{"llvmpipe"}, {"softpipe"}, {"NVIDIA"}};
constexpr SeenOn kBothUntilFixedAndNvidia[] = {
    {"llvmpipe", {.before = "25.0"}}, {"softpipe", {.before = "25.0"}}, {"NVIDIA"}};
constexpr SeenOn kLlvmpipe[] = {{"llvmpipe"}};
constexpr SeenOn kLlvmpipeUntilFixed[] = {{"llvmpipe", {.before = "25.0"}}};
constexpr SeenOn kSoftpipe[] = {{"softpipe"}};

}  // namespace

const std::vector<Departure>& departures() {
    static const std::vector<Departure> list = {
        // Departures that affect shaders too come first: if one of these applies, the others do not matter.
        {.name = "no answer in the specification",
         .section = "2.1.1, 2.11.3, 2.14.1: singular matrix, direction of length 0, vertex whose w is negative, light "
                    "at the vertex, clip coordinates that are all 0 or near the largest float",
         .cause = Cause::kUnspecified,
         .vertex_rule = has_no_answer},
        {.name = "primitives through a point whose clip coordinates are all 0",
         .section = "2.11, 2.12: such a point lies in the view volume, and is divided by a w of 0",
         .cause = Cause::kUnspecified,
         .draw_rule = contains_no_direction},
        {.name = "light at the horizon of a vertex",
         .section = "2.14.1: f_i jumps where n.VP is 0, so rounding decides",
         .cause = Cause::kUnspecified,
         .vertex_rule = has_light_at_horizon},
        {.name = "a vertex on the edge of a spot's cone",
         .section =
             "2.14.1: a vertex is lit if its angle equals the cutoff, here of 0 or 90 degrees, and behind one of 90",
         .seen_on = kBothAndNvidia,
         .vertex_rule = is_at_exact_edge_of_cone,
         .where = "src/mesa/main/ffvertex_prog.c, calculate_light_attenuation(): nir_flt(cutoff, spot) leaves out a "
                  "vertex whose cosine equals the cutoff's; section 2.14.1 requires one that is not less, of "
                  "max(cosine, 0)"},
        {.name = "vertex near the edge of a spot's cone",
         .section = "2.14.1: spot_i jumps at the cutoff, so rounding decides",
         .cause = Cause::kUnspecified,
         .vertex_rule = is_near_edge_of_cone},
        {.name = "texture coordinates whose q is 0",
         .section = "3.8.7: s/q and t/q are undefined",
         .cause = Cause::kUnspecified,
         .vertex_rule = has_no_q},
        {.name = "texture coordinates of a cube map that are 0",
         .section = "3.8.6: the coordinates are divided by the largest of s, t and r",
         .cause = Cause::kUnspecified,
         .vertex_rule = has_no_direction_into_cube},
        {.name = "size of points whose factors are negative or 0",
         .section = "3.3: the root of a negative sum, and 1 divided by 0, are undefined",
         .cause = Cause::kUnspecified,
         .draw_rule = has_no_size_of_points},
        {.name = "size of points whose limits are in the wrong order",
         .section = "3.3: if GL_POINT_SIZE_MIN is above GL_POINT_SIZE_MAX, the size is undefined",
         .cause = Cause::kUnspecified,
         .draw_rule = has_sizes_in_wrong_order},
        {.name = "limits of the level of detail in the wrong order",
         .section = "3.8.8: if GL_TEXTURE_MIN_LOD is above GL_TEXTURE_MAX_LOD, lambda is undefined",
         .cause = Cause::kUnspecified,
         .draw_rule = has_levels_in_wrong_order},
        {.name = "size of points by their distance",
         .section = "3.3: d is the distance from the eye; the driver takes |z_e|",
         .seen_on = kBoth,
         .draw_rule = attenuates_points_aside,
         .where = "src/mesa/main/ffvertex_prog.c, build_atten_pointsize(): the distance is nir_fabs() of z in eye "
                  "coordinates"},
        {.name = "clipped polygons as lines and points",
         .section = "2.12, 3.5.4",
         .cause = Cause::kDriver,
         .seen_on = kBothAndNvidia,
         .draw_rule = draws_borders_of_clipped_polygons},
        {.name = "clip planes under a projection without an inverse",
         .section = "2.12: the planes are in eye coordinates; the driver takes them to clip coordinates",
         .seen_on = kBoth,
         .draw_rule = clips_under_singular_projection,
         .where = "src/mesa/main/clip.c, _mesa_update_clip_plane(): multiplies the plane in eye coordinates by "
                  "the inverse of the projection matrix"},
        {.name = "stippled lines in perspective",
         .section =
             "3.4.1: colours and texture coordinates are divided by w; the driver cuts the line where the pattern "
             "does, and they change evenly in the window from piece to piece",
         .cause = Cause::kDriver,
         .seen_on = kBoth,
         .draw_rule = stipples_in_perspective},
        {.name = "attenuated points beyond the viewport",
         .section = "2.12, 3.3: a point whose vertex is in the view volume is drawn as a whole",
         .cause = Cause::kDriver,
         .seen_on = kLlvmpipeUntilFixed,
         .command_rule = attenuates_points_in_viewport},
        {.name = "point sprites below the scissor box",
         .section = "4.1.2: no fragment outside the box is drawn",
         .cause = Cause::kDriver,
         .seen_on = kLlvmpipe,
         .draw_rule = has_scissored_sprites},
        {.name = "polygon stipple where one face is filled",
         .section = "3.5.3, 3.5.4: only filled polygons are stippled",
         .cause = Cause::kDriver,
         .seen_on = kLlvmpipe,
         .draw_rule = stipples_borders},
        {.name = "wrap modes of cube maps",
         .section = "3.8.7: they apply to the image of a face as to a two-dimensional texture",
         .cause = Cause::kDriver,
         .seen_on = kLlvmpipe,
         .draw_rule = wraps_cube_maps},
        {.name = "edge flags of strips and fans",
         .section = "2.6.2",
         .cause = Cause::kDriver,
         .seen_on = kBoth,
         .draw_rule = has_edge_flags_in_strip},
        {.name = "two-sided stencil of polygons as lines and points",
         .section = "4.1.5: a polygon drawn as lines or points is still a polygon",
         .cause = Cause::kDriver,
         .seen_on = kBoth,
         .draw_rule = has_faces_in_stencil_of_borders},
        {.name = "the alpha of smooth points",
         .section = "3.3, 3.11: it is multiplied by the coverage, which is at most 1",
         .cause = Cause::kDriver,
         .seen_on = kBoth,
         .draw_rule = has_smooth_points},
        {.name = "faces of polygons that cross themselves or have no area",
         .section = "2.6.1: polygons must be convex; 2.14.1: the sign of the area decides which side is seen",
         .cause = Cause::kUnspecified,
         .draw_rule = has_faces_in_doubt},
        {.name = "polygons as smooth lines",
         .section = "3.4.2, 3.5.4: only the alpha of lines is multiplied by their coverage",
         .cause = Cause::kDriver,
         .seen_on = kLlvmpipe,
         .draw_rule = has_polygons_as_smooth_lines},
        {.name = "polygons of which one face is filled, in softpipe",
         .section = "3.5.4",
         .cause = Cause::kDriver,
         .draw_rule = fills_one_face,
         .crashes_on = kSoftpipe},
        {.name = "two-sided stencil of lines in softpipe",
         .section = "4.1.5: points and lines have the state of the front",
         .cause = Cause::kDriver,
         .seen_on = kSoftpipe,
         .draw_rule = has_faces_in_stencil_of_lines},
        {.name = "polygon offset of borders without area",
         .section = "3.5.5: m is a slope, and these polygons have none",
         .cause = Cause::kUnspecified,
         .draw_rule = offsets_borders_without_area},
        {.name = "polygon offset that leaves the depth range",
         .section =
             "3.5.5: the depth of each fragment is offset and clamped; the driver clamps the depths of the corners",
         .cause = Cause::kDriver,
         .seen_on = kBoth,
         .draw_rule = offsets_out_of_range},
        {.name = "polygon offset of only lines or points",
         .section = "3.5.5: filled polygons are offset only if GL_POLYGON_OFFSET_FILL is enabled",
         .cause = Cause::kDriver,
         .seen_on = kLlvmpipe,
         .draw_rule = offsets_other_modes_alone},
        {.name = "polygon offset of one of two polygon modes",
         .section = "3.5.5",
         .cause = Cause::kDriver,
         .seen_on = kBoth,
         .draw_rule = offsets_one_of_two_modes},
        {.name = "level of detail of points",
         .section = "3.8.8",
         .cause = Cause::kDriver,
         .seen_on = kBoth,
         .draw_rule = biases_level_of_points},
        {.name = "faces of borders in softpipe's shaders",
         .section = "GLSL 1.20 section 7.2: gl_FrontFacing describes the whole polygon, also for its edges and corners",
         .cause = Cause::kDriver,
         .seen_on = kSoftpipe,
         .draw_rule = has_faces_on_borders},
        {.name = "wide lines in softpipe",
         .section = "3.4.2: a wide line ends where a thin one does; softpipe's ends half a pixel later",
         .cause = Cause::kDriver,
         .seen_on = kSoftpipe,
         .draw_rule = has_wide_lines},
        {.name = "wide points in softpipe",
         .section = "3.3: a wide point is a square of whole pixels; softpipe does not align it to pixels",
         .cause = Cause::kDriver,
         .seen_on = kSoftpipe,
         .draw_rule = has_wide_points},
        {.name = "level of detail in softpipe",
         .section = "3.8.8: rho may be as small as the larger of m_u and m_v; the reference allows a narrower range",
         .cause = Cause::kUnspecified,
         .seen_on = kSoftpipe,
         .draw_rule = has_level_of_detail},
        {.name = "points whose vertex is clipped away",
         .section = "2.12: the whole point is clipped away",
         .cause = Cause::kDriver,
         .seen_on = kNvidia,
         .draw_rule = has_clipped_wide_points},
        {.name = "the size of point sprites",
         .section = "3.3.1: the driver rounds it to eighths of a pixel",
         .cause = Cause::kDriver,
         .seen_on = kNvidia,
         .draw_rule = has_sprites_between_sizes},
        {.name = "the colour sum in fog",
         .section = "3.9, 3.10",
         .seen_on = kBothAndNvidia,
         .draw_rule = adds_secondary_color_in_fog,
         .where = "src/mesa/main/ff_fragment_shader.c, emit_instructions(): the sum of the two colours is not "
                  "clamped before st_nir_lower_fog()"},
        {.name = "GL_CLAMP between a nearest and a linear filter",
         .section = "3.8.7, 3.8.8",
         .cause = Cause::kDriver,
         .seen_on = kLlvmpipe,
         .draw_rule = clamps_between_nearest_and_linear},
        {.name = "shininess 0 with attenuation or a spot",
         .section = "2.14.1: (n.h)^0 is 1; the driver computes (n.VP)^(n.VP)",
         .seen_on = kBoth,
         .draw_rule = has_shininess_0_with_factors,
         .rewrite = &sets_some_shininess,
         .where = "src/mesa/main/ffvertex_prog.c, build_lighting(): where material_shininess_is_zero, all four dots "
                  "are n.VP; with an attenuation they go to emit_lit(), whose power then has n.VP as base and "
                  "exponent, and not to emit_degenerate_lit()"},
        {.name = "shininess 0 on one side of two",
         .section = "2.14.1: (n.h)^0 is 1, whatever the shininess of the other side",
         .seen_on = kLlvmpipe,
         .draw_rule = has_shininess_0_on_one_side,
         .rewrite = &sets_some_shininess_of_sides,
         .where = "src/mesa/main/ffvertex_prog.c, build_lighting(): material_shininess_is_zero holds only if both "
                  "sides have 0; otherwise emit_lit() computes 0 to the power of 0 with nir_fpow()"},
        {.name = "glMaterial before glEnable(GL_COLOR_MATERIAL)",
         .section = "2.14.3: from glEnable on, the material follows the current colour",
         .seen_on = kBothUntilFixed,
         .command_rule = sets_material_before_tracking,
         .rewrite = &asks_before_color_material},
        {.name = "glMaterial, a tracked glColor, glNewList",
         .section = "2.14.3: the material follows the colour",
         .seen_on = kBothUntilFixed,
         .command_rule = tracks_color_before_list,
         .rewrite = &asks_before_list},
        {.name = "two-sided colour material only on the back",
         .section = "2.14.3: all channels of the back material follow the colour; the driver updates only red",
         .seen_on = kBothUntilFixed,
         .draw_rule = has_color_material_on_back_alone},
        {.name = "vertex materials that differ between two sides",
         .section = "2.14.2: glMaterial between glBegin and glEnd changes all channels of the side that it names",
         .seen_on = kBothUntilFixed,
         .command_rule = sets_sides_apart,
         .rewrite = &sets_both_sides},
        {.name = "glMaterial of two sides after a vertex",
         .section = "2.6, 2.14.2: vertices before it in the same glBegin keep the old material of each side",
         .seen_on = kBothUntilFixedAndNvidia,
         .command_rule = sets_both_sides_after_vertex},
        {.name = "glColor before a new glColorMaterial",
         .section = "2.14.3",
         .seen_on = kBoth,
         .command_rule = sets_color_before_new_mode,
         .rewrite = &asks_before_new_mode},
        {.name = "colour material after glPopAttrib",
         .section = "2.14.3",
         .seen_on = kBothUntilFixed,
         .command_rule = restores_tracked_color,
         .rewrite = &sets_color_after_pop},
        {.name = "glColor3 after glColor4",
         .section = "2.7",
         .seen_on = kBoth,
         .command_rule = mixes_glcolor3_and_4,
         .rewrite = &sends_alpha},
        {.name = "glTexCoord1 to 3 after glTexCoord4",
         .section = "2.7",
         .seen_on = kBoth,
         .command_rule = mixes_tex_coords,
         .rewrite = &sends_all_coordinates},
        {.name = "glMaterial right before glPopAttrib",
         .section = "6.2: glPopAttrib restores what glPushAttrib saved",
         .seen_on = kBoth,
         .command_rule = sets_material_before_pop,
         .rewrite = &asks_before_pop},
        {.name = "glColor right before glPopAttrib",
         .section = "6.2: glPopAttrib restores what glPushAttrib saved",
         .seen_on = kBothUntilFixed,
         .command_rule = sets_color_before_pop,
         .rewrite = &asks_before_pop},
        {.name = "edge flags in a display list",
         .section = "5.4, 2.6.2: a list draws the same as its commands",
         .seen_on = kBothUntilFixed,
         .command_rule = lists_edge_flags,
         .rewrite = &spells_out_lists},
        {.name = "a triangle strip in a display list whose first vertices lack attributes",
         .section = "5.4, 2.6.1: a list draws the same as its commands",
         .seen_on = kBothUntilFixed,
         .command_rule = lists_strips_with_late_attributes,
         .rewrite = &spells_out_lists},
        {.name = "glRect as a quadrilateral",
         .section = "2.10: glRect is a GL_POLYGON",
         .seen_on = kBothAndNvidia,
         .command_rule = shows_cut_of_rectangles,
         .rewrite = &spells_out_rectangles},
        {.name = "flat shading of glEvalMesh2",
         .section = "5.1: glEvalMesh2 draws a GL_QUAD_STRIP",
         .seen_on = kBothAndNvidia,
         .command_rule = shades_evaluated_meshes_flat,
         .rewrite = &spells_out_evaluated_meshes},
        {.name = "texture coordinates of other primitives beside point sprites",
         .section = "3.3.1: GL_COORD_REPLACE counts for points",
         .seen_on = kBothAndNvidia,
         .command_rule = draws_others_beside_sprites,
         .rewrite = &limits_sprites_to_points,
         .where = "src/mesa/main/ffvertex_prog.c, build_texture_transform(): skips units with coord_replace, "
                  "whatever the primitive is"},
        {.name = "glShadeModel after glPopAttrib in a display list",
         .section = "5.4: a list keeps every command that can be compiled",
         .seen_on = kBoth,
         .command_rule = shades_after_pop_in_list,
         .rewrite = &spells_out_lists},
        {.name = "lights after glPopAttrib of GL_ENABLE_BIT",
         .section = "6.2, table 6.10",
         .seen_on = kBoth,
         .command_rule = switches_lights_before_pop,
         .rewrite = &sets_lights_after_pop,
         .where = "src/mesa/main/attrib.c, pop_enable_group(): does not restore Light[], which "
                  "_mesa_PushAttrib() saves"},
        {.name = "GL_GENERATE_MIPMAP after glPopAttrib",
         .section = "6.2, table 6.17",
         .seen_on = kBoth,
         .command_rule = generates_mipmaps_after_pop,
         .rewrite = &sets_mipmaps_after_pop,
         .where = "src/mesa/main/texparam.c, set_tex_parameteri(): sets GenerateMipmap without flush(), so that "
                  "PopAttribState lacks GL_TEXTURE_BIT and _mesa_PopAttrib() restores no textures"},
        {.name = "a vertex whose w is not 1 under a positional light",
         .section = "2.14.1: for the direction P1P2, both points are divided by their w",
         .seen_on = kBoth,
         .vertex_rule = has_w_under_positional_light,
         .rewrite = &divides_by_w,
         .where = "src/mesa/main/ffvertex_prog.c, build_lighting(): VPpli is the light's position minus "
                  "get_eye_position(), which is not divided by its w"},
        {.name = "normals under a matrix that projects",
         .section =
             "2.11.3: normals are multiplied by the inverse of the matrix's upper left 3 x 3; the driver takes the "
             "upper left 3 x 3 of the inverse",
         .seen_on = kBoth,
         .draw_rule = has_normals_in_projection,
         .where = "src/mesa/main/ffvertex_prog.c, get_transformed_normal(): takes the upper left of "
                  "STATE_MODELVIEW_MATRIX_INVTRANS, the inverse of all four rows and columns"},
        {.name = "fog of a vertex whose w is not 1",
         .section = "3.10",
         .seen_on = kBoth,
         .draw_rule = has_w_in_fog,
         .rewrite = &divides_by_w,
         .where = "src/mesa/main/ffvertex_prog.c, build_fog(): get_eye_position_z() is not divided by w"},
        {.name = "exponential fog on primitives that reach behind the eye",
         .section = "3.10: c is the fragment's distance; the driver interpolates the distances of the vertices",
         .seen_on = kBoth,
         .draw_rule = has_exponential_fog_behind_the_eye,
         .where = "src/mesa/main/ffvertex_prog.c, build_fog(): nir_fabs() of z at each vertex; the absolute value is "
                  "then interpolated"},
        {.name = "fog coordinates below 0",
         .section = "3.10: c is the interpolated fog coordinate, not its absolute value",
         .seen_on = kBothUntilFixedAndNvidia,
         .draw_rule = has_negative_fog_coords},
        {.name = "stippled line strips in a display list",
         .section = "3.4.2, 5.4: a list draws the same as its commands",
         .seen_on = kBoth,
         .draw_rule = stipples_listed_strips,
         .rewrite = &spells_out_lists},
        {.name = "a direction whose square does not fit a float",
         .section = "2.14.1, 2.1.1: positions and normals up to 2^32 are valid, and unit vectors have length 1",
         .seen_on = kBothAndNvidia,
         .vertex_rule = has_extreme_direction,
         .rewrite = &sends_unit_directions,
         .where = "src/mesa/main/ffvertex_prog.c, build_lighting() and emit_normalize_vec3(): nir_frsq() of a sum of "
                  "squares that is 0 or infinite in floats"},
        {.name = "a vertex whose w is 0 under a directional light",
         .section = "2.14.1: between two points with w = 0, the direction P1P2 is that of their difference",
         .seen_on = kBothAndNvidia,
         .vertex_rule = has_w_0_under_directional_light,
         .where = "src/mesa/main/ffvertex_prog.c, build_lighting(): where light_eyepos3_is_zero, VPpli is the light's "
                  "direction for every vertex"},
        {.name = "an overflowing highlight of a long normal",
         .section = "2.14.1: a black term adds nothing; the driver multiplies 0 by (n.h)^s, which is infinite",
         .seen_on = kBothAndNvidia,
         .vertex_rule = has_overflowing_highlight,
         .where = "src/mesa/main/ffvertex_prog.c, build_lighting(): nir_fmad() of the power, which is infinite, and a "
                  "factor of 0"},
        {.name = "a vertex whose w is 0 under a positional light",
         .section = "2.14.1: VP is the unit vector of -V",
         .seen_on = kNvidia,
         .vertex_rule = has_w_0_under_positional_light},
        {.name = "shininess 0 where n.h is 0",
         .section = "2.14.1, 2.1.1: 0^0 is 1",
         .seen_on = kNvidia,
         .draw_rule = has_shininess_0},
        {.name = "the last digits of highlights",
         .section = "2.14.1, 2.1.1: colours are accurate to about 1 part in 10^5",
         .seen_on = kNvidia,
         .draw_rule = has_shininess},
        {.name = "the scale of GL_DOT3_RGBA",
         .section = "3.8.13: alpha is multiplied by GL_ALPHA_SCALE",
         .seen_on = kNvidia,
         .draw_rule = scales_dot3_rgba},
        {.name = "GL_RESCALE_NORMAL under a large scale",
         .section = "2.11.3",
         .seen_on = kBoth,
         .draw_rule = rescales_much,
         .rewrite = &normalizes_for_rescaling,
         .where = "src/mesa/main/light.c, update_modelview_scale(): a squared scale below 1e-12 is taken as 1"},
        {.name = "fog at a raster position",
         .section = "3.10: fog applies to every fragment, those of bitmaps and pixel rectangles too",
         .seen_on = kBoth,
         .draw_rule = has_fog_at_raster_position},
        {.name = "a lit raster position in eye coordinates",
         .section = "2.13, 2.14.1: positional lights and a local viewer are in eye coordinates",
         .seen_on = kBoth,
         .draw_rule = has_raster_position_in_eye_coordinates},
        {.name = "the secondary colour of a raster position",
         .section = "2.13, 3.9: the secondary colour of the raster position is added",
         .seen_on = kBoth,
         .draw_rule = has_secondary_color_at_raster_position},
        {.name = "the texture coordinates of a raster position",
         .section = "2.13, 3.6.4, 3.7: they are those of the raster position, generated and times the texture matrix",
         .seen_on = kBoth,
         .draw_rule = has_texture_at_raster_position},
        {.name = "a bitmap with a texture",
         .section = "3.7, 3.8: the fragments of a bitmap are textured, too",
         .seen_on = kBothIn25_1,
         .draw_rule = is_textured_bitmap},
        {.name = "the length of a normal at a raster position",
         .section = "2.13, 2.11.3: GL_NORMALIZE and GL_RESCALE_NORMAL apply as to a vertex",
         .seen_on = kBoth,
         .draw_rule = has_long_normal_at_raster_position},
        {.name = "a dim light at a raster position",
         .section = "2.13, 2.14.1: a light counts however small its attenuation is",
         .seen_on = kBoth,
         .draw_rule = has_dim_light_at_raster_position},
        {.name = "glPixelMap in pixel rectangles",
         .section = "3.6.5: each component is looked up in its own table",
         .seen_on = kBoth,
         .command_rule = maps_drawn_pixels},
        {.name = "the stencil test of mirrored pixels",
         .section = "4.1.5: pixel rectangles use the state of the front",
         .seen_on = kBoth,
         .command_rule = mirrors_stenciled_pixels},
        {.name = "glCopyPixels without zoom",
         .section = "4.3.3, 4.1.5, 4.2.2: the stencil test and the colour mask apply",
         .seen_on = kBoth,
         .draw_rule = copies_pixels_without_zoom},
        {.name = "the colour of copied depths",
         .section = "4.3.3, 3.6.4: the fragments have the colour of the raster position",
         .seen_on = kBoth,
         .draw_rule = draws_colors_of_copied_depths},
        {.name = "glPixelTransfer of copied depths",
         .section = "4.3.3, 3.6.5: depths are scaled and biased",
         .seen_on = kBoth,
         .draw_rule = transfers_copied_depths},
        {.name = "glPixelTransfer of stencil values",
         .section = "3.6.4, 3.6.5, 4.3.3: stencil values are shifted, offset and mapped",
         .seen_on = kBoth,
         .command_rule = transfers_stencil_values},
        {.name = "the mode of copied depths",
         .section = "3.8.14: GL_DEPTH_TEXTURE_MODE says in which format the texture environment sees depths",
         .seen_on = kBoth,
         .command_rule = copies_depths_after_mode,
         .rewrite = &sets_mode_after_copy},
        {.name = "an incomplete texture of a higher dimension",
         .section =
             "3.8.15: the enabled target of the highest dimension decides; if it is not complete, there is no texture",
         .seen_on = kBoth,
         .command_rule = enables_incomplete_texture,
         .where = "src/mesa/main/texstate.c, update_ff_texture_state(): goes on to the next texture that is "
                  "complete"},
        {.name = "a base level above the greatest level",
         .section = "3.8.10: such a texture is not complete, so there is no texture",
         .command_rule = sets_base_above_greatest_level,
         .crashes_on = kBoth},
        {.name = "a line loop whose first vertex lacks attributes",
         .section = "2.6.1: attributes may come before any vertex",
         .seen_on = kBoth,
         .command_rule = draws_loops_with_late_attributes},
        {.name = "current values after a line loop in GL_COMPILE_AND_EXECUTE",
         .section = "5.4, 2.6.1: the values given last stay current",
         .seen_on = kBoth,
         .command_rule = executes_listed_loops,
         .rewrite = &spells_out_lists},
        {.name = "attributes after the last vertex in a display list",
         .section = "5.4, 2.6.1: glColor sets the current colour, also between the last glVertex and glEnd",
         .seen_on = kBoth,
         .command_rule = lists_attributes_after_vertices,
         .rewrite = &spells_out_lists},
        {.name = "glGenerateMipmap before a framebuffer object draws",
         .section = "4.4.3 of OpenGL 3.0: what is drawn then becomes the texture's image",
         .seen_on = kBoth,
         .command_rule = makes_mipmaps_before_object_draws},
        {.name = "blending over colour sums in softpipe",
         .section = "3.9: the sum is clamped to [0, 1]; softpipe keeps more, and blends with it",
         .seen_on = kSoftpipe,
         .command_rule = blends_over_color_sums},
        {.name = "copied textures after stipples and smooth lines in softpipe",
         .section = "3.8.2: the texture has the copied image",
         .seen_on = kSoftpipe,
         .command_rule = copies_texels_after_smooth_ones},
        {.name = "polygon stipple after a framebuffer object",
         .section = "3.5.2: the stipple begins in the window's lower left corner",
         .cause = Cause::kDriver,
         .seen_on = kBoth,
         .command_rule = stipples_after_framebuffer},
        {.name = "eye planes of a singular matrix",
         .section = "2.11.4: the plane is multiplied by the inverse of the modelview matrix, which has none",
         .cause = Cause::kUnspecified,
         .draw_rule = has_eye_plane_of_singular_matrix},
        {.name = "depths in one dimension",
         .section = "3.8.14: depths are compared with r in one dimension, too",
         .seen_on = kBoth,
         .draw_rule = compares_depths_in_one_dimension,
         .where = "src/mesa/main/ff_fragment_shader.c, load_texture(): the comparator is channel "
                  "coord_components of the texture coordinates, which is t in one dimension"},
    };
    return list;
}

namespace {

// The departures with a rule for commands, and whether each applies.
class CommandRules {
  public:
    CommandRules() {
        for (const Departure& departure : departures())
            if (departure.command_rule) rules_.push_back({&departure, departure.command_rule(), false});
    }

    void see(const Command& command) {
        for (Rule& rule : rules_) rule.applies = rule.see(command);
    }
    bool apply(const Departure& departure) const {
        return std::ranges::any_of(rules_,
                                   [&](const Rule& rule) { return rule.departure == &departure && rule.applies; });
    }

  private:
    struct Rule {
        const Departure* departure;
        CommandRule see;
        bool applies;
    };
    std::vector<Rule> rules_;
};

bool applies_in(const Departure& departure, const std::vector<const Draw*>& draws) {
    return std::ranges::any_of(draws, [&](const Draw* draw) { return may_show_in(departure, *draw); });
}

}  // namespace

bool may_show_in(const Departure& departure, const Draw& draw) {
    if (departure.command_rule) return true;
    if (departure.draw_rule) return departure.draw_rule(draw);
    return std::ranges::any_of(draw.vertices,
                               [&](const Vertex& vertex) { return departure.vertex_rule(draw, vertex); });
}

namespace {

// A driver is named by its renderer ("llvmpipe"), or by its maker ("NVIDIA"): the driver of a maker is one for all its chips.
bool is_of(const SeenOn& seen, const Driver& driver) {
    return seen.driver == driver.name || driver.version.substr(0, driver.version.find(' ')) == seen.driver;
}

}  // namespace

bool Departure::is_known_on(const Driver& driver) const {
    return std::ranges::any_of(
        seen_on, [&](const SeenOn& seen) { return is_of(seen, driver) && seen.releases.contain(driver); });
}

// What several drivers show, any driver may show, because they share parts of Mesa. Other makers' drivers show what was seen on
// them, if they were measured.
bool Departure::may_show_on(const Driver& driver) const {
    if (!driver.version.starts_with("Mesa") && is_listed(driver))
        return (seen_on.empty() && crashes_on.empty()) || is_known_on(driver) || may_crash_on(driver);
    if (seen_on.empty()) return crashes_on.empty() || may_crash_on(driver);
    const auto has_release = [&](const SeenOn& seen) {
        return driver.maker() != "Mesa" || seen.releases.contain(driver);
    };
    const auto is_other = [&](const SeenOn& seen) {
        return seen.driver != seen_on.front().driver && has_release(seen);
    };
    return std::ranges::any_of(seen_on, is_other) || (is_of(seen_on.front(), driver) && has_release(seen_on.front()));
}

bool Departure::may_crash_on(const Driver& driver) const {
    return std::ranges::any_of(
        crashes_on, [&](const SeenOn& seen) { return is_of(seen, driver) && seen.releases.contain(driver); });
}

const Departure* find_departure(std::string_view name) {
    const auto found = std::ranges::find(departures(), name, &Departure::name);
    return found == departures().end() ? nullptr : &*found;
}

bool is_listed(const Driver& driver) {
    return std::ranges::any_of(departures(), [&](const Departure& departure) { return departure.is_known_on(driver); });
}

bool is_measured(const Driver& driver) { return has_measured_release(driver) && is_listed(driver); }

std::vector<const Departure*> known_departures_in(const Scene& scene, const Driver& driver) {
    CommandRules command_rules;
    scene.recording->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kCommand) command_rules.see(step.command);
        return true;
    });
    const std::vector<const Draw*> draws = draws_of_all_pictures(scene.frame);
    std::vector<const Departure*> found;
    for (const Departure& departure : departures()) {
        if (departure.cause == Cause::kUnspecified || !departure.is_known_on(driver)) continue;
        if (departure.command_rule ? command_rules.apply(departure) : applies_in(departure, draws))
            found.push_back(&departure);
    }
    return found;
}

DeparturesOfScene::DeparturesOfScene(const CommandList& scene, const Driver& driver,
                                     const std::vector<std::string_view>& lifted)
    : driver_(driver) {
    CommandRules command_rules;
    for (const Command& command : scene.commands) command_rules.see(command);
    for (const Departure& departure : departures()) {
        if (!departure.may_show_on(driver) || std::ranges::find(lifted, departure.name) != lifted.end()) continue;
        if (departure.draw_rule || departure.vertex_rule) local_.push_back(&departure);
        if (!command_rules.apply(departure)) continue;
        const bool is_fixed_function = departure.cause == Cause::kFixedFunction;
        if (!in_commands_ || (in_commands_->cause == Cause::kFixedFunction && !is_fixed_function))
            in_commands_ = &departure;
        if (departure.may_crash_on(driver)) crash_in_commands_ = &departure;
    }
}

const Departure* DeparturesOfScene::find(const std::function<bool(const Departure&)>& applies) const {
    const Departure* found = in_commands_;
    for (const Departure* departure : local_) {
        if (found && departure->cause == Cause::kFixedFunction) continue;
        if (applies(*departure)) {
            if (departure->cause != Cause::kFixedFunction) return departure;
            found = departure;
        }
    }
    return found;
}

const Departure* DeparturesOfScene::at(const Draw& draw, const Vertex& vertex) const {
    return find([&](const Departure& departure) {
        return departure.draw_rule ? departure.draw_rule(draw) : departure.vertex_rule(draw, vertex);
    });
}

const Departure* DeparturesOfScene::crash_in(const Frame& frame) const {
    if (crash_in_commands_) return crash_in_commands_;
    const std::vector<const Draw*> draws = draws_of_all_pictures(frame);
    const auto crashes = [&](const Departure* departure) {
        return departure->may_crash_on(driver_) && applies_in(*departure, draws);
    };
    const auto found = std::ranges::find_if(local_, crashes);
    return found == local_.end() ? nullptr : *found;
}

const Departure* DeparturesOfScene::in(const Frame& frame) const {
    const std::vector<const Draw*> draws = draws_of_all_pictures(frame);
    return find([&](const Departure& departure) { return applies_in(departure, draws); });
}

}  // namespace twinlight::compare
