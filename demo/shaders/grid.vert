#version 330 core
// A triangle over all of the view; its place in the base rectangle runs from (0, 0) to (1, 1).

out vec2 place;

void main()
{
    place = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);
}
