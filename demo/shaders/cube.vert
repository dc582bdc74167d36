// The walls of the cube room.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 texcoord; // the third is the face
layout(location = 2) in vec3 inward;

out vec3 wall_place;
out vec3 wall_texcoord;
flat out vec3 wall_inward;

void main()
{
    wall_place = position;
    wall_texcoord = texcoord;
    wall_inward = inward;
    place_vertex(vec4(position, 1.0), view_index());
}
