// One dot.

uniform vec3 dot_axis;     // its middle
uniform float dot_rad;     // its radius

vec3 light(Direction d, vec2 pixel)
{
    vec3 off = cross(dot_axis, d.at);
    float angle = atan(length(off), dot(dot_axis, d.at));
    float per_pixel = max(length(vec2(length(d.dx), length(d.dy))) * 0.70710678, 1e-9);
    return vec3(between(angle, -PI, dot_rad, per_pixel));
}
