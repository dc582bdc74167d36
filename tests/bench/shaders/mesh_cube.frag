#version 330 core
// One sample of a cube map, along a direction between those of the corners.

in vec3 ray;
out vec4 color;

uniform samplerCube faces;

void main()
{
    color = texture(faces, ray);
}
