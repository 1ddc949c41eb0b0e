// One program for all lights and materials, as fast as we can make it for llvmpipe, which has no branches: of an `if` both
// sides run, and a loop that tests its bound first runs once more than it should. So there is one formula for every kind of
// light and one loop, bounded by the uniform number of lights and tested at its end. What is the same at every fragment
// comes from the processor; the material's colours are multiplied once, after the sum.
in vec3 v_position_eye;
in vec3 v_normal_eye;
in vec2 v_tex_coord;

const int kMaxLights = 8;
uniform int u_light_count;                      // 1 or more
uniform vec4 u_light_position_eye[kMaxLights];  // w is 1, or 0 with the unit direction to it
uniform vec3 u_light_diffuse[kMaxLights];
uniform vec3 u_light_specular[kMaxLights];
uniform vec3 u_attenuation[kMaxLights];         // 1, 0, 0 where there is none
uniform vec3 u_spot_direction_eye[kMaxLights];
uniform vec2 u_spot[kMaxLights];                // cosine of the cutoff, exponent; -2, 0 where there is no cone
uniform vec3 u_base[2];                         // e_cm + a_cm a_cs, of the front and the back
uniform vec3 u_material_diffuse[2];
uniform vec3 u_material_specular[2];
uniform float u_shininess[2];
uniform bool u_two_side;
uniform vec4 u_viewer;  // (0, 0, 1, 0) for the infinite viewer, (0, 0, 0, 1) for the local one
uniform sampler2D u_texture;

out vec4 fragment_color;

void main() {
    bool back = u_two_side && !gl_FrontFacing;
    vec3 normal = normalize(v_normal_eye);
    normal = back ? -normal : normal;
    float shininess = back ? u_shininess[1] : u_shininess[0];
    vec3 vpe_dir = normalize(u_viewer.xyz - u_viewer.w * v_position_eye);
    vec3 diffuse = vec3(0.0), specular = vec3(0.0);
    int i = 0;
    do {
        vec3 vp = u_light_position_eye[i].xyz - u_light_position_eye[i].w * v_position_eye;
        float d = length(vp);
        vec3 vp_dir = vp / d;
        float cosine = dot(-vp_dir, u_spot_direction_eye[i]);
        float reach = cosine >= u_spot[i].x ? pow(max(cosine, 0.0), u_spot[i].y) : 0.0;
        reach /= u_attenuation[i].x + d * (u_attenuation[i].y + d * u_attenuation[i].z);
        float n_dot_vp = max(dot(normal, vp_dir), 0.0);
        float n_dot_h = max(dot(normal, normalize(vp_dir + vpe_dir)), 0.0);
        diffuse += reach * n_dot_vp * u_light_diffuse[i];
        specular += (n_dot_vp > 0.0 ? reach * pow(n_dot_h, shininess) : 0.0) * u_light_specular[i];
    } while (++i < u_light_count);
    vec3 color = (back ? u_base[1] : u_base[0]) + diffuse * (back ? u_material_diffuse[1] : u_material_diffuse[0]) +
        specular * (back ? u_material_specular[1] : u_material_specular[0]);
    color = clamp(color, 0.0, 1.0);
#ifdef TEXTURED
    color *= texture(u_texture, v_tex_coord).rgb;
#endif
    fragment_color = vec4(color, 1.0);
}
