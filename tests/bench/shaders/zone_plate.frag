#version 330 core
// Rings round the first line of sight whose frequency grows with the angle: one turn in two pixels,
// the finest that pixels can show, at three quarters of the way to the rim.

in vec3 ray; // world
out vec4 color;

uniform float half_fov;
uniform float pixel; // angle, in the middle

vec3 encoded(vec3 light)
{
    vec3 curve = 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(12.92 * light, curve, greaterThan(light, vec3(0.0031308)));
}

void main()
{
    float angle = atan(length(ray.xy), -ray.z);
    float phase = 3.14159265 * angle * angle / (1.5 * half_fov * pixel);
    color = vec4(encoded(vec3(0.5 + 0.5 * cos(phase))), 1.0);
}
