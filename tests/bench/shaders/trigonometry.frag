#version 330 core
// The lens by its angles, for every pixel and frame; then one sample of a cube map.

in vec2 at;
out vec4 color;

uniform samplerCube faces;
uniform mat3 cube_from_camera;
uniform float half_fov;
uniform bool hemispheric;

void main()
{
    vec2 place = 2.0 * at - 1.0;
    float radius = length(place);
    if (radius > 1.0) {
        color = vec4(0.0);
        return;
    }
    float angle = hemispheric ? asin(radius * sin(half_fov)) : radius * half_fov;
    float turn = atan(place.y, place.x);
    vec3 ray = vec3(sin(angle) * cos(turn), sin(angle) * sin(turn), -cos(angle));
    color = texture(faces, cube_from_camera * ray);
}
