#version 330 core
// The surface under a sun, an open sky and a weak lamp at the eye; lit from both sides. All of it
// is in world coordinates, so it is the same in every view.

in vec3 surface_place;
in vec3 surface_normal;
flat in vec3 surface_base;
in vec3 surface_color;
in vec2 surface_texcoord;
out vec4 color;

uniform bool vertex_colored;
uniform bool pictured;
uniform sampler2D picture;
uniform vec3 eye;
uniform vec3 sun; // towards it, unit length

void main()
{
    vec3 surface = surface_base;
    if (vertex_colored)
        surface *= surface_color;
    if (pictured)
        surface *= texture(picture, surface_texcoord).rgb;

    vec3 to_eye = normalize(eye - surface_place);
    vec3 normal = normalize(surface_normal);
    // The side on which the triangle is seen decides, not the normal: near the outline a smooth
    // normal already turns away, and on it the light must not jump.
    if (!gl_FrontFacing)
        normal = -normal;
    vec3 light = mix(vec3(0.25, 0.21, 0.18), vec3(0.40, 0.47, 0.56), 0.5 + 0.5 * normal.y);
    light += vec3(0.98, 0.88, 0.72) * max(dot(normal, sun), 0.0);
    light += vec3(0.14) * max(dot(normal, to_eye), 0.0);
    // Light adds up in linear space; with a gamma of 2 that is a root here.
    color = vec4(surface * sqrt(light), 1.0);
}
