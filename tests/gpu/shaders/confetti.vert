// Triangles, lines or points anywhere round the eye, the same for the same instance. Text before it
// says where a vertex goes: place_vertex, host_instance.

uniform float point_size;

out vec3 shade;
flat out int kind;

float random(int n)
{
    uint h = uint(n) * 0x9e3779b1u + 0x7f4a7c15u;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    return float((h ^ (h >> 15u)) >> 8u) / 16777216.0;
}

vec3 random_place(int n)
{
    return vec3(random(3 * n), random(3 * n + 1), random(3 * n + 2)) - 0.5;
}

void main()
{
    int corner = gl_VertexID + 3000 * host_instance();
    vec3 middle = 9.0 * random_place(corner / 3 + 100000);
    shade = vec3(random(5 * corner), random(5 * corner + 1), random(5 * corner + 2));
    kind = corner / 3 % 5;
    gl_PointSize = point_size;
    place_vertex(vec4(middle + 3.0 * random_place(corner), 1.0));
}
