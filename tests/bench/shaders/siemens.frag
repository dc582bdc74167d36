#version 330 core
// Siemens stars of 36 pairs of black and white on grey: one in the middle, four near the rim.

in vec3 ray; // world
out vec4 color;

uniform float half_fov;

const float PAIRS = 36.0;

// The star round the unit direction `axis`, whose right-hand side is `right`; below 0 beyond it.
float star(vec3 direction, vec3 axis, vec3 right, float radius)
{
    float forward = dot(direction, axis);
    vec2 place = vec2(dot(direction, right), dot(direction, cross(right, axis)));
    if (atan(length(place), forward) > radius)
        return -1.0;
    return step(0.0, sin(PAIRS * atan(place.y, place.x)));
}

void main()
{
    vec3 direction = normalize(ray);
    float tone = star(direction, vec3(0.0, 0.0, -1.0), vec3(1.0, 0.0, 0.0), 0.35 * half_fov);
    float off = 0.84 * half_fov, s = sin(off), c = cos(off);
    tone = max(tone, star(direction, vec3(s, 0.0, -c), vec3(c, 0.0, s), 0.14 * half_fov));
    tone = max(tone, star(direction, vec3(-s, 0.0, -c), vec3(c, 0.0, -s), 0.14 * half_fov));
    tone = max(tone, star(direction, vec3(0.0, s, -c), vec3(1.0, 0.0, 0.0), 0.14 * half_fov));
    tone = max(tone, star(direction, vec3(0.0, -s, -c), vec3(1.0, 0.0, 0.0), 0.14 * half_fov));
    color = vec4(vec3(tone < 0.0 ? 0.735 : tone), 1.0); // the grey is half of white's light
}
