// One triangle that covers the viewport, without any vertex data.

uniform vec2 target_corner; // of the output's image in the target, px
flat out vec2 corner;

void main()
{
    corner = target_corner;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);
}
