// Meridians through the middle every 15 degrees: the horizon's left half red and its right half
// green, as on ships; upwards, about the dome its +Y, blue.

vec3 light(Direction d, vec2 pixel)
{
    Polar p = polar(d);
    float middle = degrees(min(p.off, PI - p.off));
    float thin = middle > 6.0 ? meridians(p, 15.0, 1.2) : 0.0;
    float strong = middle > 2.0 ? meridians(p, 45.0, 1.8) : 0.0;
    vec3 sum = max(0.18 * thin, 0.5 * strong) * vec3(1.0);
    sum = max(sum, 0.10 * circles(p, 30.0, 1.2) * vec3(1.0));
    sum = mix(sum, vec3(0.85), meridian(p, 270.0, 2.0));
    sum = mix(sum, vec3(0.12, 0.35, 1.0), meridian(p, 90.0, 4.0));
    sum = mix(sum, vec3(1.0, 0.04, 0.03), meridian(p, 180.0, 4.0));
    sum = mix(sum, vec3(0.03, 0.75, 0.06), meridian(p, 0.0, 4.0));
    return mix(sum, vec3(1.0), circle(p, 1.5, 1.5));
}
