// The pixel's ray, in the surface's own space: the axis is z, the origin its middle. A direction, and the moment, which is the cross
// product of any point of the ray with it, are linear in window coordinates: here of one pixel, and how they change from there.
uniform vec2 u_middle_window;  // that pixel's middle
uniform vec3 u_direction;
uniform vec3 u_direction_per_x;
uniform vec3 u_direction_per_y;
uniform vec3 u_moment;
uniform vec3 u_moment_per_x;
uniform vec3 u_moment_per_y;
#if EFFECT_RAY_NEAR_FAR || EFFECT_RAY_DEPTH || EFFECT_RAY_TEX_COORD
uniform vec4 u_clip_w;  // clip coordinates of (position, 1): w
#endif
#if EFFECT_RAY_NEAR_FAR
uniform vec4 u_to_near_plane;  // w + z
#endif
#if EFFECT_RAY_NEAR_FAR || EFFECT_RAY_DEPTH
uniform vec4 u_to_far_plane;  // w - z
#endif
#if EFFECT_RAY_DEPTH
uniform float u_far_depth;  // glDepthRange
uniform float u_half_depth_range;
#endif
#if EFFECT_RAY_STEPS
// How the point that a window position comes from moves with x, y and depth; homogeneous.
uniform vec4 u_step_x;
uniform vec4 u_step_y;
uniform vec4 u_step_depth;
#endif
#if EFFECT_RAY_OFFSET
uniform float u_offset_factor;  // glPolygonOffset
uniform float u_offset;         // its units
#endif
#if EFFECT_TWO_SIDE
uniform float u_front_side;  // of a front face the outward normal goes along the ray (1) or against it (-1)
#endif
#if EFFECT_RAY_CULL
uniform float u_shown_side;  // the same of the face that is not culled
#endif
#if !EFFECT_RAY_NEAREST
uniform float u_point_number;  // which of the points that are seen is drawn, from far to near
#endif
#for_each_clip_plane uniform vec4 u_clip_planeCLIP_PLANE_NUMBER_object;  // glClipPlane's, in the surface's space
#if EFFECT_RAY_SPHERE || EFFECT_RAY_FRUSTUM
uniform float u_radius;  // in the middle
#endif
#if EFFECT_RAY_FRUSTUM
uniform float u_slope;  // the radius's change along the axis
uniform float u_half_height;
#elif EFFECT_RAY_DISK
uniform float u_inner;
uniform float u_outer;
uniform float u_disk_side;  // the normal is (0, 0, 1) or (0, 0, -1)
#elif EFFECT_RAY_TORUS
uniform float u_tube;
uniform float u_ring;
#endif
#if EFFECT_RAY_SECTOR
uniform vec4 u_sector;  // the direction of its middle, and the sine and cosine of half of its angle
#endif
#if EFFECT_PHONG && EFFECT_POSITION_EYE && !EFFECT_OBJECT_SPACE
uniform mat4 u_eye_from_object;  // from the surface's space
#endif
#if EFFECT_PHONG && EFFECT_NORMAL && !EFFECT_OBJECT_SPACE
uniform mat3 u_eye_from_object_normal;  // the transposed inverse of its upper 3x3 (section 2.11.3)
#endif
#if EFFECT_FOG
uniform vec4 u_eye_z_from_object;  // the modelview matrix's third row
#endif
#if EFFECT_FOG_W
uniform vec4 u_eye_w_from_object;  // its fourth
#endif
#if EFFECT_RAY_TEX_COORD && EFFECT_TEXTURE_MATRIX
uniform mat4 u_texture_matrix;
#endif
