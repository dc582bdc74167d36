// A model's surface: the material's colour as the file has it, in light from both sides.

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

void main()
{
    vec3 surface = surface_base;
    if (vertex_colored)
        surface *= surface_color;
    if (pictured)
        surface *= texture(picture, surface_texcoord).rgb;
    // The side on which the triangle is seen decides, not the normal: near the outline a smooth
    // normal already turns away, and on it the light must not jump.
    vec3 normal = gl_FrontFacing ? surface_normal : -surface_normal;
    color = vec4(shaded(surface, surface_place, normal, eye), 1.0);
}
