// Light that was added up in a texture of its own, into a target: one texel for each pixel.

uniform vec2 target_corner; // px
uniform sampler2D sum;

out vec4 color;

void main()
{
    vec2 pixel = gl_FragCoord.xy - target_corner;
    color = pixel_color(texelFetch(sum, ivec2(pixel), 0), pixel);
}
