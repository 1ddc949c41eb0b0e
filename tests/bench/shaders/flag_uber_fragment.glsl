// One program for all scenes, as such programs are mostly written: a flag for each of GL's switches, and a branch for each
// flag. All eight lights are gone through.
in vec3 v_position_eye;
in vec3 v_normal_eye;
in vec2 v_tex_coord;

struct Light {
    bool enabled;
    vec4 position_eye;
    vec3 ambient, diffuse, specular;
    vec3 attenuation;
    vec3 spot_direction_eye;
    float spot_cutoff_cosine;  // -1: none
    float spot_exponent;
};
struct Material {
    vec3 emission, ambient, diffuse, specular;
    float shininess;
};
uniform Light u_light[8];
uniform Material u_front, u_back;
uniform vec3 u_scene_ambient;
uniform bool u_local_viewer, u_two_side, u_normalize;
uniform sampler2D u_texture;

out vec4 fragment_color;

void main() {
    vec3 normal = u_normalize ? normalize(v_normal_eye) : v_normal_eye;
    Material material = u_front;
    if (u_two_side && !gl_FrontFacing) {
        material = u_back;
        normal = -normal;
    }
    vec3 color = material.emission + material.ambient * u_scene_ambient;
    for (int i = 0; i < 8; ++i) {
        if (!u_light[i].enabled) continue;
        vec3 vp_dir;
        float reach = 1.0;
        if (u_light[i].position_eye.w == 0.0) {
            vp_dir = normalize(u_light[i].position_eye.xyz);
        } else {
            vec3 vp = u_light[i].position_eye.xyz / u_light[i].position_eye.w - v_position_eye;
            float d = length(vp);
            vp_dir = vp / d;
            reach = 1.0 / (u_light[i].attenuation.x + u_light[i].attenuation.y * d + u_light[i].attenuation.z * d * d);
        }
        if (u_light[i].spot_cutoff_cosine >= 0.0) {
            float cosine = dot(-vp_dir, normalize(u_light[i].spot_direction_eye));
            reach *= cosine >= u_light[i].spot_cutoff_cosine ? pow(max(cosine, 0.0), u_light[i].spot_exponent) : 0.0;
        }
        float n_dot_vp = max(dot(normal, vp_dir), 0.0);
        vec3 term = material.ambient * u_light[i].ambient + n_dot_vp * material.diffuse * u_light[i].diffuse;
        if (n_dot_vp > 0.0) {
            vec3 vpe_dir = u_local_viewer ? normalize(-v_position_eye) : vec3(0.0, 0.0, 1.0);
            float n_dot_h = max(dot(normal, normalize(vp_dir + vpe_dir)), 0.0);
            term += pow(n_dot_h, material.shininess) * material.specular * u_light[i].specular;
        }
        color += reach * term;
    }
    color = clamp(color, 0.0, 1.0);
#ifdef TEXTURED
    color *= texture(u_texture, v_tex_coord).rgb;
#endif
    fragment_color = vec4(color, 1.0);
}
