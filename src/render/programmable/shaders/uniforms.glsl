// All uniforms except those of lights and materials. A stage declares only those that it uses (shader_assembly.h).

uniform mat4 u_clip_from_object;  // the product of the projection and the modelview matrix
uniform mat4 u_eye_from_object;  // the modelview matrix
uniform mat3 u_eye_from_object_normal;  // the transposed inverse of the modelview matrix's upper 3x3 (section 2.11.3)
uniform float u_normal_scale;  // GL_RESCALE_NORMAL's factor (section 2.11.3)
uniform mat3 u_eye_from_object_turned;  // the modelview matrix's upper 3x3, for vectors
uniform vec4 u_object_scale;  // powers of two: of scaled positions, w is at most 1, and x, y and z at most 2^40
uniform float u_normal_unit;  // what u_eye_from_object_normal is divided by
uniform vec3 u_viewer_object;  // the eye, in object coordinates
uniform NEAR_VERTEX u_viewer_near_object;  // the vertex that is nearest to the eye, in object coordinates
uniform vec3 u_viewer_way_eye;  // from there to the eye
uniform vec3 u_viewer_dir_object;  // the direction to the eye, for a viewer at infinity
uniform mat4 u_texture_matrix;
// Generated texture coordinates (section 2.11.4): factors of the object coordinates x, y, z and w, for each coordinate.
uniform vec4 u_plane_s_object;
uniform vec4 u_plane_t_object;
uniform vec4 u_plane_r_object;
uniform vec4 u_plane_q_object;
uniform vec4 u_plane_s_eye;  // of programs for any pose: GL_EYE_LINEAR's planes
uniform vec4 u_plane_t_eye;
uniform vec4 u_plane_r_eye;
uniform vec4 u_plane_q_eye;
uniform mat4 u_generated_eye_from_object;  // the modelview matrix; its scale does not matter
uniform mat3 u_generated_normal_from_object;  // for normals, with GL_RESCALE_NORMAL's factor (section 2.11.3)
uniform mat4 u_point_eye_from_object;  // the modelview matrix, in a unit of length that keeps squares in the range of floats
uniform vec3 u_point_attenuation;  // GL_POINT_DISTANCE_ATTENUATION, in that unit
uniform vec3 u_point_sizes;  // glPointSize, GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX
uniform SAMPLER u_texture;
uniform vec4 u_texture_env_color;
uniform float u_point_size;  // glPointSize (section 3.3)
uniform float u_texture_lod_bias;  // GL_TEXTURE_LOD_BIAS (section 3.8.8)
uniform vec3 u_texture_inside;  // the part of s, t and r within a rim of one texel, which has the border's colour (section 3.8.7), or within half a texel of a cube map's face
uniform sampler2D u_framebuffer;  // the picture before these primitives, for glLogicOp (section 4.1.10)
uniform vec4 u_viewport;  // glViewport (section 2.11.1): x, y, width, height
uniform float u_line_width;  // glLineWidth (section 3.4.2.1), in whole pixels unless lines are smooth
uniform int u_line_stipple_factor;  // glLineStipple (section 3.4.2)
uniform int u_line_stipple_pattern;
uniform uint u_polygon_stipple[32];  // glPolygonStipple (section 3.5.2): rows from the bottom, the leftmost pixel in the lowest bit
uniform vec3 u_blend_source;  // glBlendColor (section 4.1.8), where it is the source factor
uniform float u_alpha_ref;  // glAlphaFunc (section 4.1.4)
uniform vec4 u_eye_z_from_object;  // the modelview matrix's third row
uniform vec4 u_eye_w_from_object;  // the modelview matrix's fourth row
uniform vec3 u_fog_color;
uniform float u_fog_end;
uniform float u_fog_scale;  // 1 / (end - start)
uniform float u_fog_density;

// Exact surfaces (surface_values.h).
uniform vec4 u_rectangle_ndc;  // lower left and upper right corner
// The pixel's ray in the surface's own space, where z is the axis and the origin is the middle. The ray has a direction
// and a moment, the cross product of any of its points with the direction. Both are linear in window coordinates: these
// are the values for one pixel, and their change per pixel.
uniform vec2 u_middle_window;  // the middle of that pixel
uniform vec3 u_direction;
uniform vec3 u_direction_per_x;
uniform vec3 u_direction_per_y;
uniform vec3 u_moment;
uniform vec3 u_moment_per_x;
uniform vec3 u_moment_per_y;
uniform vec4 u_clip_w;  // dot(u_clip_w, (position, 1)) is the clip coordinate w
uniform vec4 u_to_near_plane;  // dot(u_to_near_plane, (position, 1)) is w + z
uniform vec4 u_to_far_plane;  // dot(u_to_far_plane, (position, 1)) is w - z
uniform float u_far_depth;  // from glDepthRange (section 2.11.1)
uniform float u_half_depth_range;
// How the point that projects to a window position moves with x, y and depth; homogeneous.
uniform vec4 u_step_x;
uniform vec4 u_step_y;
uniform vec4 u_step_depth;
uniform float u_offset_factor;  // from glPolygonOffset (section 3.5.5)
uniform float u_offset;  // glPolygonOffset's units, as a depth
uniform float u_front_side;  // 1 if the outward normal of a front face points along the ray, -1 if against it
uniform float u_shown_side;  // 1 if the outward normal of an unculled face points along the ray, -1 if against it
uniform float u_point_number;  // the number of the visible point to draw, counted from the farthest
uniform float u_radius;  // of the sphere, or at the middle of the frustum
uniform float u_slope;  // the change of the radius along the axis
uniform float u_half_height;
uniform float u_inner;
uniform float u_outer;
uniform float u_disk_side;  // the normal is (0, 0, 1) or (0, 0, -1)
uniform float u_tube;
uniform float u_ring;
uniform vec4 u_sector;  // the direction of the sector's middle, and the sine and cosine of half of its angle
