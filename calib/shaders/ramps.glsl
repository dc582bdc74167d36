// Greys and colours as numbers of an 8-bit sRGB picture, from left to right in bands: 240 to 255,
// 0 to 255 in steps of 17, all greys, all reds, greens and blues, and 0 to 15.

const float HALF_DEG = 64.0;
const float STEPS = 16.0;

// Decoded steps with smooth edges between them.
vec3 stepped(float across, float per_pixel, float first, float step_code)
{
    float at = across * STEPS;
    float edge = clamp(floor(at + 0.5), 1.0, STEPS - 1.0);
    float above = clamp((at - edge) / (STEPS * per_pixel) + 0.5, 0.0, 1.0);
    float low = edge - 1.0;
    vec3 below_code = vec3((first + step_code * low) / 255.0);
    vec3 above_code = vec3((first + step_code * edge) / 255.0);
    return mix(srgb_decode(below_code), srgb_decode(above_code), above);
}

vec3 light(Direction d, vec2 pixel)
{
    Polar p = polar(upright(d));
    float high = 90.0 - degrees(p.off), high_px = degrees(p.off_px);
    float right = -degrees(p.round), right_px = degrees(p.round_px) / max(p.sine, 1e-6);
    float across = clamp((right + HALF_DEG) / (2.0 * HALF_DEG), 0.0, 1.0);
    float across_px = right_px / (2.0 * HALF_DEG);
    vec3 ramp = srgb_decode(vec3(across));
    vec3 sum = between(high, 34.0, 44.0, high_px) * stepped(across, across_px, 240.0, 1.0);
    sum += between(high, 18.0, 28.0, high_px) * stepped(across, across_px, 0.0, 17.0);
    sum += between(high, 6.0, 13.0, high_px) * ramp;
    sum += between(high, 0.0, 5.0, high_px) * ramp * vec3(1.0, 0.0, 0.0);
    sum += between(high, -6.0, -1.0, high_px) * ramp * vec3(0.0, 1.0, 0.0);
    sum += between(high, -12.0, -7.0, high_px) * ramp * vec3(0.0, 0.0, 1.0);
    sum += between(high, -28.0, -18.0, high_px) * stepped(across, across_px, 0.0, 1.0);
    return sum * between(right, -HALF_DEG, HALF_DEG, right_px);
}
