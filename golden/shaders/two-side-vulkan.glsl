// ==== kind1.vert
#version 450
// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and lights vertices in eye coordinates
// (section 2.14).

layout(location = 0) in vec4 Vertex;
layout(location = 1) in vec3 Normal;

layout(std140, set = 0, binding = 0) uniform Matrices {
    mat4 ModelViewProjectionMatrix;  // glMatrixMode: the product of the projection and the modelview matrix
    mat3 NormalMatrix;  // the transposed inverse of the modelview matrix's upper 3x3 (section 2.11.3)
};

// glMaterial (section 2.14.2)
struct MaterialParameters {
    vec4 emission;  // e_cm
    vec4 ambient;  // a_cm
    vec4 diffuse;  // d_cm
};
layout(std140, set = 0, binding = 1) uniform FrontMaterialBlock {
    MaterialParameters FrontMaterial;
};
layout(std140, set = 0, binding = 2) uniform BackMaterialBlock {
    MaterialParameters BackMaterial;
};

// glLight (section 2.14.2)
struct LightSourceParameters {
    vec4 diffuse;  // d_cli
    vec4 position;  // P_pli, in eye coordinates: glLight multiplied it by the modelview matrix
};
layout(std140, set = 0, binding = 3) uniform LightSourceBlock {
    LightSourceParameters LightSource[1];  // GL_LIGHT0
};

// glLightModel (section 2.14.2)
struct LightModelParameters {
    vec4 ambient;  // a_cs
};
layout(std140, set = 0, binding = 4) uniform LightModelBlock {
    LightModelParameters LightModel;
};

layout(location = 0) out vec4 v_front_primary;
layout(location = 1) out vec4 v_back_primary;

invariant gl_Position;  // another program with the same positions gets the same depths

// v scaled to length 1; the zero vector stays 0.
vec3 unit(vec3 v) {
    return v / max(length(v), 1e-18);
}

// max(a . b, 0): written as a dot in a circle in section 2.14.1.
float positive_dot(vec3 a, vec3 b) {
    return max(dot(a, b), 0.0);
}

// The lighting equation (GL 2.1, section 2.14.1), in eye coordinates:
//
//   c_pri = e_cm + a_cm a_cs + sum_i att_i spot_i [ a_cm a_cli + (n . VP_i) d_cm d_cli
//                                                   + f_i (n . h_i)^s_rm s_cm s_cli ]
//
// Only the lights that are on and the terms that are not 0 are here.
struct Surface {
    vec3 normal_eye;  // n
};

struct Lit {
    vec4 primary;  // c_pri
};

// The colours of the front face (section 2.14.1).
Lit light_front(Surface surface) {
    Lit lit;
    lit.primary.rgb = FrontMaterial.emission.rgb + FrontMaterial.ambient.rgb * LightModel.ambient.rgb;  // e_cm + a_cm a_cs
    lit.primary.a = FrontMaterial.diffuse.a;
    vec3 n = surface.normal_eye;
    {  // GL_LIGHT0
        vec3 vp_dir = unit(LightSource[0].position.xyz);
        float n_dot_vp = positive_dot(n, vp_dir);
        lit.primary.rgb += n_dot_vp * FrontMaterial.diffuse.rgb * LightSource[0].diffuse.rgb;
    }
    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6
    return lit;
}

// The colours of the back face (section 2.14.1).
Lit light_back(Surface surface) {
    Lit lit;
    lit.primary.rgb = BackMaterial.emission.rgb + BackMaterial.ambient.rgb * LightModel.ambient.rgb;  // e_cm + a_cm a_cs
    lit.primary.a = BackMaterial.diffuse.a;
    vec3 n = surface.normal_eye;
    {  // GL_LIGHT0
        vec3 vp_dir = unit(LightSource[0].position.xyz);
        float n_dot_vp = positive_dot(n, vp_dir);
        lit.primary.rgb += n_dot_vp * BackMaterial.diffuse.rgb * LightSource[0].diffuse.rgb;
    }
    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6
    return lit;
}

void main() {
    gl_Position = ModelViewProjectionMatrix * Vertex;
    Surface surface = Surface(NormalMatrix * Normal);
    Lit front = light_front(surface);
    // The back face has its own material and the opposite normal. The fragment shader picks the visible face.
    surface.normal_eye = -surface.normal_eye;
    Lit back = light_back(surface);
    v_front_primary = front.primary;
    v_back_primary = back.primary;
    gl_Position.y = -gl_Position.y;  // Vulkan's y points down
    gl_Position.z = 0.5 * (gl_Position.z + gl_Position.w);  // Vulkan clips z to [0, w], GL to [-w, w]
}

// ==== kind1.frag
#version 450
// Fragment shader: computes the colour from interpolated values (GL 2.1, sections 3.8 to 3.10).

layout(location = 0) in vec4 v_front_primary;
layout(location = 1) in vec4 v_back_primary;

layout(location = 0) out vec4 fragment_color;

void main() {
    fragment_color = gl_FrontFacing ? v_front_primary : v_back_primary;
}
