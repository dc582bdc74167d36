// Circles round the middle every 10 degrees, every third stronger, the one at 90 degrees red, and a
// cross through the middle.

vec3 light(Direction d, vec2 pixel)
{
    Polar p = polar(d);
    vec3 sum = max(0.25 * circles(p, 10.0, 1.4), 0.8 * circles(p, 30.0, 2.2)) * vec3(1.0);
    sum = mix(sum, vec3(1.0, 0.06, 0.03), circle(p, 90.0, 2.6));
    float ends = p.off < radians(2.0) ? 1.0 : 0.12;
    return max(sum, ends * meridians(p, 90.0, 1.4) * vec3(1.0));
}
