#version 330 core
// One lamp under the ceiling of the cube room.

const vec3 lamp_place = vec3(0.4, 0.5, 0.3);

vec3 shaded(vec3 base, vec3 place, vec3 normal, vec3 eye)
{
    vec3 to_lamp = lamp_place - place;
    float squared = dot(to_lamp, to_lamp);
    float facing = dot(normal, to_lamp) * inversesqrt(squared);
    return base * (0.70 + 0.95 * facing / (1.0 + squared));
}
