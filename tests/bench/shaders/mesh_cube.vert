#version 330 core
// A mesh over the target, with a direction for each corner.

layout(location = 0) in vec2 place;
layout(location = 1) in vec3 direction;

out vec3 ray;

void main()
{
    ray = direction;
    gl_Position = vec4(place, 0.0, 1.0);
}
