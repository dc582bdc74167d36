#version 330 core
// Colour = the unit direction of the ray, in the host's camera frame.

in vec3 ray;
out vec4 color;

void main()
{
    color = vec4(normalize(ray), 1.0);
}
