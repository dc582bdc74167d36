// One triangle that covers the view, and the ray of every place in it: linear in x and y, so it
// may be interpolated. In the midst of all depths: masks are nearer and cleared views farther.

uniform mat3 ray_basis[VIEWS];

out vec3 ray;

void main()
{
    vec2 place = vec2(float((gl_VertexID & 1) * 4 - 1), float((gl_VertexID >> 1) * 4 - 1));
    ray = ray_basis[view_index()] * vec3(place, 1.0);
    cover_view(vec4(place, 0.5, 1.0), view_index());
}
