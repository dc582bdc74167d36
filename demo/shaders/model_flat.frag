#version 330 core
// The material's colour as the file has it, on both sides, without any light.

flat in vec3 surface_base;
in vec3 surface_color;
in vec2 surface_texcoord;
out vec4 color;

uniform bool vertex_colored;
uniform bool pictured;
uniform sampler2D picture;

void main()
{
    vec3 surface = surface_base;
    if (vertex_colored)
        surface *= surface_color;
    if (pictured)
        surface *= texture(picture, surface_texcoord).rgb;
    color = vec4(surface, 1.0);
}
