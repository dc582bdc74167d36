#version 330 core
// Colour = the point of the screen sphere that the ray meets: dome frame, metres.

in vec3 ray; // dome frame
out vec4 color;

uniform vec3 eye_m;
uniform float power_m2; // R^2 - |E|^2, above 0 for an eye inside

void main()
{
    vec3 direction = normalize(ray);
    float along = dot(eye_m, direction);
    float distance_m = sqrt(along * along + power_m2) - along;
    color = vec4(eye_m + distance_m * direction, 1.0);
}
