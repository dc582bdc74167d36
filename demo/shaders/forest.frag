// Trees and ground in the scene's light.

in vec3 surface_place;
in vec3 surface_normal;
in vec3 surface_base;
out vec4 color;

uniform vec3 eye;

void main()
{
    vec3 normal = gl_FrontFacing ? surface_normal : -surface_normal;
    color = vec4(shaded(surface_base, surface_place, normal, eye), 1.0);
}
