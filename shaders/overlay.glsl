// Overlays: from rays to places in a flat picture that faces the eye, and what it covers of a
// pixel. lib/geometry/overlay.c says the same under the same names. KIND_... are the kinds.

uniform int overlay_kind;
uniform mat3 overlay_axes;  // rows of the C: right, up, forward, in the host's camera frame
uniform vec2 overlay_half;  // of its width and height on the plane z = 1
uniform float ring_inner;   // of a cursor, in parts of its half width
uniform float dot_radius;

// A place in a picture, 0 to 1, and its derivatives per pixel.
struct Place {
    vec2 at;
    vec2 dx;
    vec2 dy;
};

// x and y in parts of the halves: it ends where the larger of |x| and |y| is z.
Varying overlay_direction(Varying ray, vec2 half_size)
{
    vec3 scale = vec3(1.0 / half_size, 1.0);
    return Varying(scale * (overlay_axes * ray.at), scale * (overlay_axes * ray.dx),
                   scale * (overlay_axes * ray.dy));
}

Place overlay_place(Varying direction)
{
    vec3 at = direction.at;
    vec2 tangent = at.xy / at.z;
    return Place(0.5 + 0.5 * tangent, 0.5 * (direction.dx.xy - tangent * direction.dx.z) / at.z,
                 0.5 * (direction.dy.xy - tangent * direction.dy.z) / at.z);
}

float plane_coverage(Varying direction, vec3 normal)
{
    vec2 gradient = vec2(dot(normal, direction.dx), dot(normal, direction.dy));
    return edge_coverage(dot(normal, direction.at) / max(length(gradient), 1e-12), gradient);
}

float slab_coverage(Varying direction, vec2 axis)
{
    return max(plane_coverage(direction, vec3(axis, 1.0)) +
                   plane_coverage(direction, vec3(-axis, 1.0)) - 1.0, 0.0);
}

float ellipse_coverage(Varying direction, float radius)
{
    float r = length(direction.at.xy);
    vec2 outwards = r > 0.0 ? direction.at.xy / r : vec2(1.0, 0.0);
    return plane_coverage(direction, vec3(-outwards, radius));
}

float round_coverage(Varying direction)
{
    float disc = ellipse_coverage(direction, 1.0);
    if (overlay_kind == KIND_DISC)
        return disc;
    float hole = ellipse_coverage(direction, ring_inner);
    return min(max(disc - hole, 0.0) + ellipse_coverage(direction, dot_radius), 1.0);
}

float overlay_coverage(Varying direction)
{
    if (!(direction.at.z > 0.0))
        return 0.0;
    if (overlay_kind == KIND_PICTURE)
        return slab_coverage(direction, vec2(1.0, 0.0)) * slab_coverage(direction, vec2(0.0, 1.0));
    const float parts = float(PARTS);
    float sum = 0.0;
    for (int part = 0; part < PARTS * PARTS; part++) {
        vec2 offset = (vec2(part % PARTS, part / PARTS) + 0.5) / parts - 0.5;
        vec3 at = direction.at + offset.x * direction.dx + offset.y * direction.dy;
        sum += round_coverage(Varying(at, direction.dx / parts, direction.dy / parts));
    }
    return sum / (parts * parts);
}
