#version 330 core
// A sun, an open sky and a weak lamp at the eye. All of it is in world coordinates, so it is the
// same in every view.

uniform vec3 sun; // towards it, unit length

vec3 shaded(vec3 base, vec3 place, vec3 normal, vec3 eye)
{
    vec3 to_eye = normalize(eye - place);
    normal = normalize(normal);
    vec3 light = mix(vec3(0.25, 0.21, 0.18), vec3(0.40, 0.47, 0.56), 0.5 + 0.5 * normal.y);
    light += vec3(0.98, 0.88, 0.72) * max(dot(normal, sun), 0.0);
    light += vec3(0.14) * max(dot(normal, to_eye), 0.0);
    // Light adds up in linear space; with a gamma of 2 that is a root here.
    return base * sqrt(light);
}
