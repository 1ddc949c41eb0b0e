// The lighting equation (GL 2.1, section 2.14.1), in SPACE coordinates:
//
//   c_pri = e_cm + a_cm a_cs + sum_i att_i spot_i [ a_cm a_cli + (n . VP_i) d_cm d_cli
//                                                   + f_i (n . h_i)^s_rm s_cm s_cli ]
//
// Only what this Draw calls for stands below. Products of a light's and a material's colour come from the
// processor; where the vertex brings the material's colour, it is multiplied here.
#if EFFECT_SURFACE
struct Surface {
#if EFFECT_POSITION_EYE
    vec3 position_SPACE;  // V
#endif
#if EFFECT_NORMAL
    vec3 normal_SPACE;  // n
#endif
#if EFFECT_COLOR
    vec4 color;  // of the vertex: GL_COLOR_MATERIAL (section 2.14.3)
#endif
#if EFFECT_VERTEX_PROPERTIES
    // Of the vertex's material: glMaterial between glBegin and glEnd (section 2.14.2).
#endif
#for_each_property     PROPERTY_TYPE PROPERTY;
};
#endif

struct Lit {
#if EFFECT_PRIMARY
    vec4 primary;  // c_pri
#endif
#if EFFECT_SEPARATE_SPECULAR
    vec3 secondary;  // c_sec
#endif
};

#if EFFECT_POWER_WHOLE
#include "power.glsl"
#endif
#if EFFECT_VARIES_AMBIENT
uniform PRODUCT_TYPE u_constant_ambient;  // light from everywhere: a_cs, and a_cli that nothing weakens on its way
#endif
#if EFFECT_OBJECT_SPACE && EFFECT_LOCAL_VIEWER
uniform vec3 u_viewer_object;  // where the eye is
#elif EFFECT_OBJECT_SPACE && EFFECT_VPE_DIR
uniform vec3 u_viewer_dir;  // the direction to it
#endif
#if EFFECT_SAMPLED
uniform mat3 u_rgb_from_samples[GROUPS];
#endif
#for_each_light "light_uniforms.glsl"
#for_each_face "face_uniforms.glsl"

#if EFFECT_PRECISE
#for_each_lit_face "precise_face.glsl"
#else
#for_each_lit_face "face.glsl"
#endif
