// ==== kind1.vert
#version 330 core
// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and passes values to the fragment shader.

layout(location = 0) in vec4 Vertex;
layout(location = 1) in vec4 Color;

uniform mat4 ModelViewProjectionMatrix;  // glMatrixMode: the product of the projection and the modelview matrix

out vec4 v_front_primary;

invariant gl_Position;  // another program with the same positions gets the same depths

void main() {
    gl_Position = ModelViewProjectionMatrix * Vertex;
    v_front_primary = Color;
}

// ==== kind1.frag
#version 330 core
// Fragment shader: computes the colour from interpolated values (GL 2.1, sections 3.8 to 3.10).

in vec4 v_front_primary;

out vec4 fragment_color;

void main() {
    fragment_color = v_front_primary;
}
