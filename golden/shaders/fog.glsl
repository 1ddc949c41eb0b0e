// ==== kind1.vert
#version 330 core
// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and passes values to the fragment shader.

layout(location = 0) in vec4 Vertex;
layout(location = 1) in vec4 Color;

uniform mat4 ModelViewProjectionMatrix;  // glMatrixMode: the product of the projection and the modelview matrix
uniform mat4 ModelViewMatrix;  // from object to eye coordinates
uniform vec4 ClipPlane[8];  // glClipPlane, in eye coordinates (section 2.12)

out vec4 v_front_primary;
out float v_eye_z;
out float gl_ClipDistance[1];

invariant gl_Position;  // another program with the same positions gets the same depths

void main() {
    gl_Position = ModelViewProjectionMatrix * Vertex;
    v_front_primary = Color;
    v_eye_z = (ModelViewMatrix * Vertex).z;
    gl_ClipDistance[0] = dot(ClipPlane[1], ModelViewMatrix * Vertex);  // clipped where negative (section 2.12)
}

// ==== kind1.frag
#version 330 core
// Fragment shader: computes the colour from interpolated values (GL 2.1, sections 3.8 to 3.10).

in vec4 v_front_primary;
in float v_eye_z;

out vec4 fragment_color;

uniform float AlphaRef;  // glAlphaFunc (section 4.1.4)

// glFog (section 3.10)
struct FogParameters {
    vec4 color;
    float end;
    float scale;  // 1 / (end - start)
};
uniform FogParameters Fog;

// The fog factor f for GL_LINEAR (section 3.10). fog_scale is 1 / (end - start).
float fog_linear(float fog_distance, float fog_end, float fog_scale) {
    return clamp((fog_end - fog_distance) * fog_scale, 0.0, 1.0);
}

void main() {
    vec4 color = v_front_primary;
    color.rgb = mix(Fog.color.rgb, color.rgb, fog_linear(abs(v_eye_z), Fog.end, Fog.scale));  // section 3.10
    if (!(color.a > AlphaRef)) discard;  // the alpha test (section 4.1.4)
    fragment_color = color;
}
