#version 330 core
// A mesh over the target, with a place in a view for each corner.

layout(location = 0) in vec2 place;
layout(location = 1) in vec2 texcoord;

out vec2 at;

void main()
{
    at = texcoord;
    gl_Position = vec4(place, 0.0, 1.0);
}
