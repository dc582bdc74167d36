#version 330 core
// One triangle over the whole target, whose places in a picture are turned by 45 degrees. The
// picture repeats itself: `repeats` of them stand side by side.

out vec2 at;

uniform float repeats;

void main()
{
    const float half_root = 0.70710678;
    vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    at = repeats * half_root * vec2(corner.x - corner.y, corner.x + corner.y);
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
