#version 330 core
// The image in a window: pixel by pixel where the sizes agree, else in linear light.

uniform sampler2D image; // sRGB
uniform vec4 place_px;   // corner and size in the framebuffer

out vec4 color;

vec3 srgb_encode(vec3 linear)
{
    vec3 curve = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

void main()
{
    vec2 at = (gl_FragCoord.xy - place_px.xy) / place_px.zw;
    color = vec4(srgb_encode(texture(image, at).rgb), 1.0);
}
