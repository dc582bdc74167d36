// Stars of 36 wedges each, in the middle and on three circles round it: the lines come closer
// towards a star's middle, and rings say where there are 1, 2, 4 and 8 cycles in a degree.

uniform float spacing_rad; // between the circles on which stars stand

const float CYCLES = 36.0;
const float STAR_DEG = 7.2;

// Rows: right, up and backward of a star's own frame.
mat3 star_frame(Polar p)
{
    float ring = clamp(floor(p.off / spacing_rad + 0.5), 0.0, 3.0);
    float off = ring * spacing_rad;
    float apart = ring > 1.0 ? 0.25 * PI : 0.5 * PI;
    float round = ring > 0.0 ? floor(p.round / apart + 0.5) * apart : 0.0;
    vec3 outwards = vec3(cos(off) * cos(round), cos(off) * sin(round), sin(off));
    vec3 across = vec3(-sin(round), cos(round), 0.0);
    return transpose(mat3(outwards, across, cross(outwards, across)));
}

vec3 light(Direction d, vec2 pixel)
{
    Polar p = polar(turned(star_frame(polar(d)), d));
    float radius = degrees(p.off), per_pixel = degrees(p.off_px);
    float cycle_px = CYCLES * p.round_px / (2.0 * PI * max(p.sine, 1e-6));
    float wave = 2.0 * abs(fract(CYCLES * p.round / (2.0 * PI)) - 0.5);
    float lines = clamp(0.5 + (wave - 0.5) / max(2.0 * cycle_px, 1e-6), 0.0, 1.0);
    lines = mix(lines, 0.5, smoothstep(0.4, 0.8, cycle_px));
    vec3 sum = vec3(lines * between(radius, -1.0, STAR_DEG, per_pixel));
    const float degree = CYCLES / (2.0 * PI); // radius at which there is 1 cycle in a degree
    sum = mix(sum, vec3(1.0, 0.05, 0.03), circle(p, degree, 1.5));
    sum = mix(sum, vec3(0.9, 0.6, 0.02), circle(p, degree / 2.0, 1.5));
    sum = mix(sum, vec3(0.03, 0.7, 0.05), circle(p, degree / 4.0, 1.5));
    return mix(sum, vec3(0.1, 0.3, 1.0), circle(p, degree / 8.0, 1.5));
}
