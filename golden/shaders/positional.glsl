// ==== kind1.vert
#version 330 core
// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and lights vertices in eye coordinates
// (section 2.14).

layout(location = 0) in vec4 Vertex;
layout(location = 1) in vec3 Normal;

uniform mat4 ModelViewProjectionMatrix;  // glMatrixMode: the product of the projection and the modelview matrix
uniform mat4 ModelViewMatrix;  // from object to eye coordinates
uniform mat3 NormalMatrix;  // the transposed inverse of the modelview matrix's upper 3x3 (section 2.11.3)

// glMaterial (section 2.14.2)
struct MaterialParameters {
    vec4 emission;  // e_cm
    vec4 ambient;  // a_cm
    vec4 diffuse;  // d_cm
    vec4 specular;  // s_cm
    float shininess;  // s_rm
};
uniform MaterialParameters FrontMaterial;

// glLight (section 2.14.2)
struct LightSourceParameters {
    vec4 diffuse;  // d_cli
    vec4 specular;  // s_cli
    vec4 position;  // P_pli, in eye coordinates: glLight multiplied it by the modelview matrix
    float constantAttenuation;  // k_0i
    float linearAttenuation;  // k_1i
    float quadraticAttenuation;  // k_2i
};
uniform LightSourceParameters LightSource[1];  // GL_LIGHT0

// glLightModel (section 2.14.2)
struct LightModelParameters {
    vec4 ambient;  // a_cs
};
uniform LightModelParameters LightModel;

out vec4 v_front_primary;

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

// att_i: the attenuation at a distance, for k = (k_0i, k_1i, k_2i) (section 2.14.1). 1 / 0, which the specification
// leaves open, becomes 0.
float attenuation(vec3 k, float light_distance) {
    float divisor = k[0] + light_distance * (k[1] + light_distance * k[2]);
    return divisor > 0.0 ? 1.0 / max(divisor, 1e-37) : 0.0;
}

// n . h, where h is the direction of a + b (section 2.14.1); 0 if it is negative or a + b is 0. Written as the root of
// a square, because the compiler can remove the root if the exponent is even.
float cosine_to_half(vec3 n, vec3 a, vec3 b) {
    vec3 sum = a + b;
    float n_dot_sum = max(dot(n, a) + dot(n, b), 0.0);
    return sqrt(n_dot_sum * n_dot_sum / max(dot(sum, sum), 1e-24));
}

// f_i (n . h_i)^s_rm: the specular highlight (section 2.14.1). n_dot_h must not be negative.
float highlight(float n_dot_vp, float n_dot_h, int shininess) {
    return n_dot_vp > 0.0 ? whole_power(n_dot_h, shininess) : 0.0;
}

// The lighting equation (GL 2.1, section 2.14.1), in eye coordinates:
//
//   c_pri = e_cm + a_cm a_cs + sum_i att_i spot_i [ a_cm a_cli + (n . VP_i) d_cm d_cli
//                                                   + f_i (n . h_i)^s_rm s_cm s_cli ]
//
// Only the lights that are on and the terms that are not 0 are here.
struct Surface {
    vec3 position_eye;  // V
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
    vec3 vpe_dir = vec3(0.0, 0.0, 1.0);  // the infinite viewer
    {  // GL_LIGHT0
        vec3 vp = LightSource[0].position.xyz / LightSource[0].position.w - surface.position_eye;
        vec3 vp_dir = unit(vp);
        float n_dot_vp = positive_dot(n, vp_dir);
        float reach = attenuation(vec3(LightSource[0].constantAttenuation, LightSource[0].linearAttenuation,
                LightSource[0].quadraticAttenuation), length(vp));
        lit.primary.rgb += reach * n_dot_vp * FrontMaterial.diffuse.rgb * LightSource[0].diffuse.rgb;
        lit.primary.rgb += reach * highlight(n_dot_vp, cosine_to_half(n, vp_dir, vpe_dir), int(FrontMaterial.shininess)) *
            FrontMaterial.specular.rgb * LightSource[0].specular.rgb;
    }
    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6
    return lit;
}

void main() {
    gl_Position = ModelViewProjectionMatrix * Vertex;
    Surface surface = Surface((ModelViewMatrix * Vertex).xyz, unit(NormalMatrix * Normal));
    v_front_primary = light_front(surface).primary;
}

// ==== kind1.frag
#version 330 core
// Fragment shader: computes the colour from interpolated values (GL 2.1, sections 3.8 to 3.10).

in vec4 v_front_primary;

out vec4 fragment_color;

void main() {
    fragment_color = v_front_primary;
}
