// For both opponents: what a fragment needs to be lit.
in vec4 a_position;
in vec3 a_normal;
in vec4 a_tex_coord;

uniform mat4 u_clip_from_object;
uniform mat4 u_eye_from_object;
uniform mat3 u_eye_from_object_normal;

out vec3 v_position_eye;
out vec3 v_normal_eye;
out vec2 v_tex_coord;

void main() {
    gl_Position = u_clip_from_object * a_position;
    v_position_eye = (u_eye_from_object * a_position).xyz;
    v_normal_eye = u_eye_from_object_normal * a_normal;
    v_tex_coord = a_tex_coord.st;
}
