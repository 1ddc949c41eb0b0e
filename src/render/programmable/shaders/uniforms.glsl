// The uniforms beside the lights' and the materials'. A stage declares those that it names and no others (shader_assembly.h).

uniform mat4 u_clip_from_object;  // the product of the projection and the modelview matrix
uniform mat4 u_eye_from_object;  // the modelview matrix
uniform mat3 u_eye_from_object_normal;  // the transposed inverse of its upper 3x3 (section 2.11.3)
uniform float u_normal_scale;  // the factor of GL_RESCALE_NORMAL (section 2.11.3)
uniform vec3 u_viewer_object;  // the eye, in object coordinates
uniform vec3 u_viewer_dir_object;  // the direction to it
uniform mat4 u_texture_matrix;
uniform SAMPLER u_texture;
uniform vec4 u_texture_env_color;
uniform vec4 u_eye_z_from_object;  // the modelview matrix's third row
uniform vec4 u_eye_w_from_object;  // its fourth
uniform vec3 u_fog_color;
uniform float u_fog_end;
uniform float u_fog_scale;  // 1 / (end - start)
uniform float u_fog_density;

// Exact surfaces (surface_values.h).
uniform vec4 u_rectangle_ndc;  // its lower left and upper right corner
// The pixel's ray, in the surface's own space: the axis is z, the origin its middle. A direction, and the moment, which is the cross
// product of any point of the ray with it, are linear in window coordinates: here for one pixel, and how they change from there.
uniform vec2 u_middle_window;  // that pixel's middle
uniform vec3 u_direction;
uniform vec3 u_direction_per_x;
uniform vec3 u_direction_per_y;
uniform vec3 u_moment;
uniform vec3 u_moment_per_x;
uniform vec3 u_moment_per_y;
uniform vec4 u_clip_w;  // clip coordinates of (position, 1): w
uniform vec4 u_to_near_plane;  // w + z
uniform vec4 u_to_far_plane;  // w - z
uniform float u_far_depth;  // glDepthRange
uniform float u_half_depth_range;
// How the point that a window position comes from moves with x, y and depth; homogeneous.
uniform vec4 u_step_x;
uniform vec4 u_step_y;
uniform vec4 u_step_depth;
uniform float u_offset_factor;  // glPolygonOffset
uniform float u_offset;  // its units
uniform float u_front_side;  // whether the outward normal of a front face goes along the ray (1) or against it (-1)
uniform float u_shown_side;  // the same of the face that is not culled
uniform float u_point_number;  // which of the points that are seen is drawn, from far to near
uniform float u_radius;  // in the middle
uniform float u_slope;  // the radius's change along the axis
uniform float u_half_height;
uniform float u_inner;
uniform float u_outer;
uniform float u_disk_side;  // the normal is (0, 0, 1) or (0, 0, -1)
uniform float u_tube;
uniform float u_ring;
uniform vec4 u_sector;  // the direction of its middle, and the sine and cosine of half of its angle
