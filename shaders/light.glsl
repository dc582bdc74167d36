// From linear light to the numbers that an output's pixel gets: gain, then encoding. Set by the
// program that includes this: GAIN is 0 or 1; ENCODING one of the ENCODING_... numbers, of which
// ENCODING_ASKED is for contexts where the GL may do it by itself.

#if GAIN
uniform sampler2D gain; // of the output's size
#endif
#if ENCODING == ENCODING_ASKED
uniform bool encoded;
#endif

// IEC 61966-2-1; above 1 the curve goes on, for targets that hold more.
vec3 srgb_encode(vec3 light)
{
    light = max(light, 0.0);
    vec3 curve = 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

vec4 pixel_color(vec4 light, vec2 pixel)
{
#if GAIN
    light.rgb *= texelFetch(gain, ivec2(pixel), 0).rgb;
#endif
#if ENCODING == ENCODING_SRGB
    light.rgb = srgb_encode(light.rgb);
#elif ENCODING == ENCODING_ASKED
    if (encoded)
        light.rgb = srgb_encode(light.rgb);
#endif
    return light;
}
