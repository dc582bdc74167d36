#version 330 core
// One triangle that covers the viewport, without any vertex data.

void main()
{
    gl_Position = vec4(vec2(4 * (gl_VertexID & 1), 4 * (gl_VertexID >> 1)) - 1.0, 0.0, 1.0);
}
