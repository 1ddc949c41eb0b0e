// ==== kind1.vert
#version 330 core
// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and passes values to the fragment shader.

layout(location = 0) in vec4 Vertex;
layout(location = 1) in vec4 Color;
layout(location = 2) in vec4 MultiTexCoord0;

uniform mat4 ModelViewProjectionMatrix;  // glMatrixMode: the product of the projection and the modelview matrix

out vec4 v_front_primary;
out vec2 v_tex_coord;

invariant gl_Position;  // another program with the same positions gets the same depths

void main() {
    gl_Position = ModelViewProjectionMatrix * Vertex;
    v_front_primary = Color;
    v_tex_coord = MultiTexCoord0.st;
}

// ==== kind1.frag
#version 330 core
// Fragment shader: computes the colour from interpolated values (GL 2.1, sections 3.8 to 3.10).

in vec4 v_front_primary;
in vec2 v_tex_coord;

out vec4 fragment_color;

uniform sampler2D Texture0;  // of texture unit 0

void main() {
    vec4 texel = texture(Texture0, v_tex_coord);
    fragment_color = v_front_primary * texel;  // GL_MODULATE (section 3.8.13)
}
