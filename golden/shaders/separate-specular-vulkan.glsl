// ==== kind1.vert
#version 450
// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and lights vertices in eye coordinates
// (section 2.14).

layout(location = 0) in vec4 Vertex;
layout(location = 1) in vec3 Normal;
layout(location = 2) in vec4 MultiTexCoord0;

layout(std140, set = 0, binding = 0) uniform Matrices {
    mat4 ModelViewProjectionMatrix;  // glMatrixMode: the product of the projection and the modelview matrix
    mat3 NormalMatrix;  // the transposed inverse of the modelview matrix's upper 3x3 (section 2.11.3)
};

// glMaterial (section 2.14.2)
struct MaterialParameters {
    vec4 emission;  // e_cm
    vec4 ambient;  // a_cm
    vec4 diffuse;  // d_cm
    vec4 specular;  // s_cm
    float shininess;  // s_rm
};
layout(std140, set = 0, binding = 1) uniform FrontMaterialBlock {
    MaterialParameters FrontMaterial;
};

// glLight (section 2.14.2)
struct LightSourceParameters {
    vec4 diffuse;  // d_cli
    vec4 specular;  // s_cli
    vec4 position;  // P_pli, in eye coordinates: glLight multiplied it by the modelview matrix
    vec4 halfVector;  // of a directional light: the direction of VP_i + (0, 0, 1), of length 1
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
layout(location = 1) out vec3 v_front_secondary;
layout(location = 2) out vec2 v_tex_coord;

invariant gl_Position;  // another program with the same positions gets the same depths

// v scaled to length 1; the zero vector stays 0.
vec3 unit(vec3 v) {
    return v / max(length(v), 1e-18);
}

// x^n for an integer n in [0, 128], by repeated squaring: faster and more exact than pow. 0^0 is 1 (section 2.1.1).
float whole_power(float x, int n) {
    float result = 1.0;
    for (int bit = 0; bit < 8; ++bit) {
        result *= (n >> bit & 1) != 0 ? x : 1.0;
        x *= x;
    }
    return result;
}

// max(a . b, 0): written as a dot in a circle in section 2.14.1.
float positive_dot(vec3 a, vec3 b) {
    return max(dot(a, b), 0.0);
}

// f_i (n . h_i)^s_rm: the specular highlight (section 2.14.1). n_dot_h must not be negative.
float highlight(float n_dot_vp, float n_dot_h, int shininess) {
    return n_dot_vp > 0.0 ? whole_power(n_dot_h, shininess) : 0.0;
}

// x, but never infinite: the power of a long normal may overflow, and infinity times 0 is not a number.
float bounded(float x) {
    return min(x, 1e30);
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
    vec3 secondary;  // c_sec
};

// The colours of the front face (section 2.14.1).
Lit light_front(Surface surface) {
    Lit lit;
    lit.primary.rgb = FrontMaterial.emission.rgb + FrontMaterial.ambient.rgb * LightModel.ambient.rgb;  // e_cm + a_cm a_cs
    lit.primary.a = FrontMaterial.diffuse.a;
    lit.secondary = vec3(0.0);
    vec3 n = surface.normal_eye;
    {  // GL_LIGHT0
        vec3 vp_dir = unit(LightSource[0].position.xyz);
        float n_dot_vp = positive_dot(n, vp_dir);
        lit.primary.rgb += n_dot_vp * FrontMaterial.diffuse.rgb * LightSource[0].diffuse.rgb;
        lit.secondary += bounded(highlight(n_dot_vp, positive_dot(n, LightSource[0].halfVector.xyz), int(FrontMaterial.shininess))) *
            FrontMaterial.specular.rgb * LightSource[0].specular.rgb;
    }
    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6
    lit.secondary = clamp(lit.secondary, 0.0, 1.0);
    return lit;
}

void main() {
    gl_Position = ModelViewProjectionMatrix * Vertex;
    Surface surface = Surface(NormalMatrix * Normal);
    Lit front = light_front(surface);
    v_front_primary = front.primary;
    v_front_secondary = front.secondary;
    v_tex_coord = MultiTexCoord0.st;
    gl_Position.y = -gl_Position.y;  // Vulkan's y points down
    gl_Position.z = 0.5 * (gl_Position.z + gl_Position.w);  // Vulkan clips z to [0, w], GL to [-w, w]
}

// ==== kind1.frag
#version 450
// Fragment shader: computes the colour from interpolated values (GL 2.1, sections 3.8 to 3.10).

layout(location = 0) in vec4 v_front_primary;
layout(location = 1) in vec3 v_front_secondary;
layout(location = 2) in vec2 v_tex_coord;

layout(location = 0) out vec4 fragment_color;

layout(set = 0, binding = 7) uniform sampler2D Texture0;  // of texture unit 0

void main() {
    vec4 texel = texture(Texture0, v_tex_coord);
    vec4 color = v_front_primary;  // then GL_MODULATE (section 3.8.13)
    color.rgb *= texel.rgb;
    color.rgb = min(color.rgb + v_front_secondary, 1.0);  // the colour sum (section 3.9)
    fragment_color = color;
}
