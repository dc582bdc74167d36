// Trees: one mesh, many instances, each in one view. The ground is an instance in each view, too.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 base;
layout(location = 3) in vec4 place_size; // world
layout(location = 4) in vec3 turn_tint;  // cosine and sine of a turn round the trunk; 0 to 1
layout(location = 5) in int in_view;

out vec3 surface_place;
out vec3 surface_normal;
out vec3 surface_base;

vec3 turned(vec3 v)
{
    return vec3(turn_tint.x * v.x + turn_tint.y * v.z, v.y,
                turn_tint.x * v.z - turn_tint.y * v.x);
}

void main()
{
    surface_place = place_size.xyz + place_size.w * turned(position);
    surface_normal = turned(normal);
    surface_base = base * mix(vec3(0.75, 0.85, 0.95), vec3(1.35, 1.15, 0.75), turn_tint.z);
    place_vertex(vec4(surface_place, 1.0), in_view);
}
