// Colour = unit direction of the ray, host's camera frame.

uniform mat3 ray_of_place;

in vec2 place;
out vec4 color;

void main()
{
    color = vec4(normalize(ray_of_place * vec3(place, 1.0)), 1.0);
}
