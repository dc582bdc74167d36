#version 330 core
// The material's colour as it is, without any light.

vec3 shaded(vec3 base, vec3 place, vec3 normal, vec3 eye)
{
    return base;
}
