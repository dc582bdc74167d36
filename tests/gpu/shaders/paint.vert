// A triangle over all of the view; `place` is in normalised device coordinates.

out vec2 place;

void main()
{
    place = 4.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
    gl_Position = vec4(place, 0.0, 1.0);
}
