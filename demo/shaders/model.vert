// A model's surface, in world coordinates.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 base;
layout(location = 3) in vec3 vertex_color;
layout(location = 4) in vec2 texcoord;

out vec3 surface_place;
out vec3 surface_normal;
flat out vec3 surface_base; // not interpolated: exactly the material's colour
out vec3 surface_color;
out vec2 surface_texcoord;

void main()
{
    surface_place = position;
    surface_normal = normal;
    surface_base = base;
    surface_color = vertex_color;
    surface_texcoord = texcoord;
    place_vertex(vec4(position, 1.0), view_index());
}
