// Black and white by the unit direction of the ray, in cubes of 1/9, with hard edges.

uniform mat3 ray_of_place;

in vec2 place;
out vec4 color;

void main()
{
    vec3 cube = floor(9.0 * normalize(ray_of_place * vec3(place, 1.0)));
    float sum = cube.x + cube.y + cube.z;
    color = vec4(vec3(sum - 2.0 * floor(0.5 * sum)), 1.0);
}
