// Rays beside the middles of pixels, for pictures that are the mean of many frames. Coverage stays
// that of the whole pixel.

#if JITTERS
uniform vec2 ray_jitter; // px; 0: none

// Draws rays together into the part of their pixel that an edge leaves: first upwards, to where
// something is left, then to the right. The normal points out of that part.
vec2 within_edge(vec2 jitter, float distance_px, vec2 normal)
{
    float steepness = length(normal);
    if (!(steepness > 0.0))
        return jitter;
    vec2 outwards = vec2(normal.x < 0.0 ? -1.0 : 1.0, normal.y < 0.0 ? -1.0 : 1.0);
    vec2 slope = max(abs(normal) / steepness, 1e-6), place = outwards * jitter + 0.5;
    place.y *= clamp((distance_px + 0.5 * slope.x) / slope.y + 0.5, 0.0, 1.0);
    place.x *= clamp((distance_px - slope.y * (place.y - 0.5)) / slope.x + 0.5, 0.0, 1.0);
    return outwards * (place - 0.5);
}

// The place of a pixel's ray, px.
vec2 jittered_place(vec2 pixel, Varying point)
{
    vec2 from_center = pixel - circle_center, jitter = ray_jitter;
    if (jitter == vec2(0.0))
        return pixel;
#if CAPPED
    Varying inside = point_inside_rim(pixel, point);
    vec2 gradient = vec2(inside.dx.z, inside.dy.z) / screen_radius;
    float excess = -point.at.z / screen_radius - cap_cosine;
    jitter = within_edge(jitter, excess / max(length(gradient), 1e-12), gradient);
#endif
    return pixel + within_edge(jitter, circle_radius - length(from_center), from_center);
}
#endif
