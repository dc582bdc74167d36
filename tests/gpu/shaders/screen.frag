// Colour = the point of the screen sphere that the ray meets, in radii, host's camera frame. The
// camera's origin is the sphere's centre.

uniform mat3 ray_of_place;
uniform vec3 eye; // m
uniform float screen_radius;

in vec2 place;
out vec4 color;

void main()
{
    vec3 from = eye / screen_radius;
    vec3 ray = normalize(ray_of_place * vec3(place, 1.0));
    float along = dot(from, ray);
    float way = sqrt(along * along - dot(from, from) + 1.0) - along;
    color = vec4(from + way * ray, 1.0);
}
