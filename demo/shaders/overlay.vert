#version 330 core
// Text over the picture: places in pixels from the window's top left.

layout(location = 0) in vec2 place;
layout(location = 1) in vec4 place_color;

out vec4 letter_color;

uniform vec2 window_px;
uniform vec3 origin_scale;

void main()
{
    vec2 at = (origin_scale.xy + origin_scale.z * place) / window_px;
    letter_color = place_color;
    gl_Position = vec4(2.0 * at.x - 1.0, 1.0 - 2.0 * at.y, 0.0, 1.0);
}
