#version VERSION
#if EFFECT_RAY
// The vertex shader: the rectangle of the window around an exact surface.
#else
// The vertex shader: object coordinates to clip coordinates (GL 2.1, section 2.11)
#endif
#if EFFECT_RAY && EFFECT_LIGHTING && !EFFECT_PHONG
// All of the surface is lit alike: here (section 2.14).
#elif EFFECT_RAY
#elif EFFECT_PHONG
// and to eye coordinates, in which the fragment shader lights.
#elif EFFECT_LIGHTING && EFFECT_OBJECT_SPACE
// and the vertex's light (section 2.14): the modelview matrix keeps angles, so the lights are given in object coordinates.
#elif EFFECT_LIGHTING
// and to eye coordinates, in which the vertex is lit (section 2.14).
#else
// and the vertex's colour, if it is called for.
#endif

#if EFFECT_RAY
in vec4 a_position;  // the corners of a square
#else
in vec4 a_position;  // in object coordinates
#endif
#if EFFECT_NORMAL
in vec3 a_normal;
#endif
#if EFFECT_COLOR
in vec4 a_color;
#endif
#if EFFECT_TEXTURE
in vec4 a_tex_coord;
#endif
#for_each_property in PROPERTY_TYPE a_PROPERTY;

#if EFFECT_RAY
uniform vec4 u_rectangle_ndc;  // its lower left and upper right corner
#else
uniform mat4 u_clip_from_object;  // the product of the projection and the modelview matrix
#endif
#if EFFECT_POSITION_EYE && !EFFECT_OBJECT_SPACE
uniform mat4 u_eye_from_object;  // the modelview matrix
#endif
#if EFFECT_NORMAL && !EFFECT_OBJECT_SPACE
uniform mat3 u_eye_from_object_normal;  // the transposed inverse of its upper 3x3 (section 2.11.3)
#endif
#if EFFECT_RESCALE
uniform float u_normal_scale;  // GL_RESCALE_NORMAL's factor (section 2.11.3)
#endif
#if EFFECT_TEXTURE_MATRIX
uniform mat4 u_texture_matrix;
#endif
#if EFFECT_FOG
uniform vec4 u_eye_z_from_object;  // the modelview matrix's third row
#endif
#if EFFECT_FOG_W
uniform vec4 u_eye_w_from_object;  // its fourth
#endif
#if EFFECT_CLIP_PLANES
#for_each_clip_plane uniform vec4 u_clip_planeCLIP_PLANE_NUMBER_object;  // glClipPlane's, in object coordinates
#endif

#if EFFECT_PHONG
#if EFFECT_VERTEX_W
out vec4 v_position_eye;
#elif EFFECT_POSITION_EYE
out vec3 v_position_eye;
#endif
#if EFFECT_NORMAL
out vec3 v_normal_eye;
#endif
#if EFFECT_COLOR
out vec4 v_color;
#endif
#for_each_property out PROPERTY_TYPE v_PROPERTY;
#else
#if EFFECT_FLAT
// "flat" takes the provoking vertex's value (section 2.14.7, table 2.12).
#endif
#if EFFECT_PRIMARY
INTERPOLATION out vec4 v_front_primary;
#endif
#if EFFECT_SEPARATE_SPECULAR
INTERPOLATION out vec3 v_front_secondary;
#endif
#if EFFECT_TWO_SIDE && EFFECT_PRIMARY
INTERPOLATION out vec4 v_back_primary;
#endif
#if EFFECT_TWO_SIDE && EFFECT_SEPARATE_SPECULAR
INTERPOLATION out vec3 v_back_secondary;
#endif
#endif
#if EFFECT_TEXTURE
out TEX_COORD_TYPE v_tex_coord;
#endif
#if EFFECT_FOG_W
out vec2 v_eye_z;  // z and w, in eye coordinates
#elif EFFECT_FOG
out float v_eye_z;
#endif
#if EFFECT_CLIP_PLANES
out float gl_ClipDistance[CLIP_PLANE_COUNT];
#endif

invariant gl_Position;  // what is drawn again, by another program, lies at the same depth

#if EFFECT_UNIT
#include "unit.glsl"
#endif
#if EFFECT_VERTEX_W && !EFFECT_PHONG
#include "divided_by_w.glsl"
#endif
#if EFFECT_PRECISE
#include "precise.glsl"
#endif
#if EFFECT_LIGHTING && !EFFECT_PHONG
#include "lighting.glsl"
#endif

void main() {
#if EFFECT_RAY
    gl_Position = vec4(mix(u_rectangle_ndc.xy, u_rectangle_ndc.zw, a_position.xy), 0.0, 1.0);
#else
    vec4 position = POSITION;
#endif
#if EFFECT_PRECISE
    gl_Position = transformed(u_clip_from_object, position);
#elif !EFFECT_RAY
    gl_Position = u_clip_from_object[0] * position.x + u_clip_from_object[1] * position.y +
        u_clip_from_object[2] * position.z + u_clip_from_object[3] * position.w;
#endif
#if EFFECT_PHONG
#include "surface.glsl"
#if EFFECT_VERTEX_W
    v_position_eye = position_eye;
#elif EFFECT_POSITION_EYE
    v_position_eye = position_eye.xyz;
#endif
#if EFFECT_NORMAL
    v_normal_eye = normal_eye;
#endif
#if EFFECT_COLOR
    v_color = a_color;
#endif
#for_each_property     v_PROPERTY = a_PROPERTY;
#elif EFFECT_LIGHTING
#if EFFECT_PRECISE
#include "precise_surface.glsl"
#else
#include "surface.glsl"
#endif
#if EFFECT_SURFACE
    Surface surface;
#endif
#if EFFECT_VERTEX_W
    surface.position_eye = divided_by_w(position_eye);
#elif EFFECT_POSITION_EYE
    surface.position_SPACE = position_SPACE.xyz;
#endif
#if EFFECT_NORMAL
    surface.normal_SPACE = normal_SPACE;
#endif
#if EFFECT_COLOR
    surface.color = a_color;
#endif
#for_each_property     surface.PROPERTY = a_PROPERTY;
    Lit front = light_front(SURFACE);
#if EFFECT_PRIMARY
    v_front_primary = front.primary;
#endif
#if EFFECT_SEPARATE_SPECULAR
    v_front_secondary = front.secondary;
#endif
#if EFFECT_TWO_SIDE
    // The back face has its own material and the opposite normal; which one shows is known per fragment.
#if EFFECT_NORMAL
    surface.normal_SPACE = -normal_SPACE;
#endif
    Lit back = light_back(SURFACE);
#endif
#if EFFECT_TWO_SIDE && EFFECT_PRIMARY
    v_back_primary = back.primary;
#endif
#if EFFECT_TWO_SIDE && EFFECT_SEPARATE_SPECULAR
    v_back_secondary = back.secondary;
#endif
#elif EFFECT_PRIMARY && EFFECT_CLAMP
    v_front_primary = clamp(a_color, 0.0, 1.0);  // section 2.14.6
#elif EFFECT_PRIMARY
    v_front_primary = a_color;
#endif
#if EFFECT_TEXTURE && EFFECT_TEXTURE_MATRIX
    v_tex_coord = (u_texture_matrix * a_tex_coord).TEX_COORD_PARTS;
#elif EFFECT_TEXTURE
    v_tex_coord = a_tex_coord.TEX_COORD_PARTS;
#endif
#if EFFECT_FOG_W
    v_eye_z = vec2(dot(u_eye_z_from_object, POSITION), dot(u_eye_w_from_object, POSITION));
#elif EFFECT_FOG
    v_eye_z = dot(u_eye_z_from_object, POSITION);
#endif
#if EFFECT_CLIP_PLANES
    // What lies behind a plane is clipped (section 2.12).
#for_each_clip_plane     gl_ClipDistance[CLIP_PLANE_NUMBER] = dot(u_clip_planeCLIP_PLANE_NUMBER_object, POSITION);
#endif
}
