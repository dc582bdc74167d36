// Where things end: the screen's rim red, the image circle green, the frame of the image blue. The
// middle of the image circle is a cross, its ticks are 15 degrees apart, the dome's axis is a small
// ring.

uniform vec3 circle_px;   // the image circle's centre and radius
uniform vec2 size_px;     // of the image
uniform float cap_rad;    // of the screen; pi: it has no rim

vec3 light(Direction d, vec2 pixel)
{
    vec2 from_center = pixel - circle_px.xy;
    float r = length(from_center), wide = max(2.0, circle_px.z / 256.0);
    float round = atan(from_center.y, from_center.x);
    float big = abs(beside(round, 0.5 * PI)) < 0.1 ? 3.0 : 1.0;
    float tick = line(sin(beside(round, PI / 12.0)) * r, 1.5) *
                 between(r, circle_px.z * (1.0 - 0.02 * big), circle_px.z, 1.0);
    vec2 inside = min(pixel, size_px - pixel);
    float arm = min(abs(from_center.x), abs(from_center.y));
    Polar p = polar(d);
    vec3 sum = vec3(0.8) * (r < 0.08 * circle_px.z ? line(arm, 1.5) : 0.0);
    sum = mix(sum, vec3(0.1, 0.3, 1.0), clamp(wide + 0.5 - min(inside.x, inside.y), 0.0, 1.0));
    sum = mix(sum, vec3(0.9, 0.6, 0.02), circle(p, 2.0, 2.0));
    float rim = between(p.off / p.off_px, cap_rad / p.off_px - 2.0 * wide, cap_rad / p.off_px, 1.0);
    sum = mix(sum, vec3(1.0, 0.05, 0.03), cap_rad < 3.14 ? rim : 0.0);
    // Over the rim, which is twice as wide: where both coincide both are seen.
    sum = mix(sum, vec3(0.03, 0.7, 0.05), between(r, circle_px.z - wide, circle_px.z + 1.0, 1.0));
    return mix(sum, vec3(1.0), tick);
}
