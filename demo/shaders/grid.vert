// A triangle over all of a view, and the ray of every place in it.

uniform mat3 rays[VIEWS]; // from places, (0, 0) to (1, 1) over the base rectangle; dome frame

out vec3 dome_ray;

void main()
{
    vec2 place = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1);
    dome_ray = rays[view_index()] * vec3(place, 1.0);
    cover_view(vec4(2.0 * place - 1.0, 0.0, 1.0), view_index());
}
