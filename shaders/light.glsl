// From linear light to the numbers that an output's pixel gets: gain, then encoding. Set by the
// program that includes this: GAIN is 0 or 1; ENCODING one of the ENCODING_... numbers, of which
// ENCODING_ASKED is for contexts where the GL may do it by itself.
//
// With DITHERED noise of the last of 8 bits is added at the very end; its mean is 0.

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

uint scramble(uint x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

// lib/geometry/pattern.c says the same.
uint pattern_hash(uvec2 place, uint seed)
{
    return scramble(place.x + scramble(place.y + scramble(seed)));
}

#if DITHERED
// Steps of noise, -1 to 1, the ends excluded: of triangular density, and even where a step would
// lead beyond black or white, so that nothing is cut off there and they stay as they are.
vec4 dither(vec4 steps, vec2 pixel)
{
    uint hash = pattern_hash(uvec2(ivec2(floor(pixel))), scramble(FILTER_SEED));
    vec2 noise = vec2(uvec2(hash & 0xffffu, hash >> 16)) / 65536.0 + (0.5 / 65536.0 - 0.5);
    bvec4 inside = lessThan(abs(steps - 127.5), vec4(127.0));
    // A little less than half a step: some GLs round a hair below it up.
    return mix(vec4(0.98 * noise.x), vec4(noise.x + noise.y), vec4(inside));
}

// What the GL itself encodes is dithered as what will stand in the target.
vec3 srgb_decode(vec3 codes)
{
    codes = max(codes, 0.0);
    vec3 curve = pow((codes + 0.055) / 1.055, vec3(2.4));
    return mix(curve, codes / 12.92, lessThanEqual(codes, vec3(0.04045)));
}
#endif

vec4 pixel_color(vec4 light, vec2 pixel)
{
#if GAIN
    light.rgb *= texelFetch(gain, ivec2(pixel), 0).rgb;
#endif
#if ENCODING == ENCODING_SRGB || (DITHERED && ENCODING == ENCODING_ASKED)
    light.rgb = srgb_encode(light.rgb);
#elif ENCODING == ENCODING_ASKED
    if (encoded)
        light.rgb = srgb_encode(light.rgb);
#endif
#if DITHERED
    light += dither(255.0 * light, pixel) / 255.0;
#if ENCODING == ENCODING_ASKED
    if (!encoded)
        light.rgb = srgb_decode(light.rgb);
#endif
#endif
    return light;
}
