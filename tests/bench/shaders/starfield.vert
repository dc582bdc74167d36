// A square that faces the origin, for every star.

layout(location = 0) in vec3 corner; // world
layout(location = 1) in float light;

flat out float star_light;

void main()
{
    star_light = light;
    place_vertex(vec4(corner, 1.0), view_index());
}
