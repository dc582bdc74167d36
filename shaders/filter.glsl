// What a pixel shows by several rays: the weighted mean of what they meet. lib/geometry/filter.c
// says the same under the same names. FILTER is FILTER_CONE, FILTER_ADAPTIVE or FILTER_FOOTPRINT,
// SAMPLES the number of rays, or the most of them. RIM: rays are kept within the image circle.
//
// Before this stand the places of rays as literals: EACH_PLACE(RAY) is RAY(x, y, weight) for each
// of them. Where UNROLLED is 0 they are too many for that, or their number varies: pattern_place
// has them, of FILTER_ADAPTIVE one pattern after the other from that of three on; and PAIR_PLACE is
// the first place of that of two.

#if RAYS
// What a ray shows: of the program that includes this. Rays are those of its own space: any in
// which a ray is linear in the viewer's.
vec4 ray_light(vec3 ray);

// Products of the changes of a ray across it, by the square of its length: for x and x, x and y, y
// and y. `same` is the ray in a frame where products are those of directions, as far as `ray`
// itself is not in one.
vec3 cone_metric(Varying ray, Varying same)
{
    float square = 1.0 / dot(ray.at, same.at);
    vec2 along = square * vec2(dot(ray.at, same.dx), dot(ray.at, same.dy));
    vec3 products = vec3(dot(ray.dx, same.dx), dot(ray.dx, same.dy), dot(ray.dy, same.dy));
    return square * products - vec3(along.x * along.x, along.x * along.y, along.y * along.y);
}

// From places of the unit disc to places round a pixel, px.
mat2 filter_cone(vec3 metric)
{
    float root = sqrt(max(metric.x * metric.z - metric.y * metric.y, 0.0));
    float scale = root > 0.0 ? inversesqrt(3.14159265 * root * metric.x) : 0.0;
    return mat2(scale * root, 0.0, -scale * metric.y, scale * metric.x);
}

int filter_adaptive_count(Jacobian jacobian)
{
    mat2 change = jacobian.change;
    float covered = abs(change[0].x * change[1].y - change[1].x * change[0].y);
    float one = jacobian.unit * jacobian.unit, slack = 1e-3 * one;
#if SAMPLES <= 8
    int count = 1;
    for (int i = 1; i < SAMPLES; i++)
        count += covered > float(i) * one + slack ? 1 : 0;
    return count;
#else
    return int(clamp(ceil((covered - slack) / one), 1.0, float(SAMPLES)));
#endif
}

// In xy the direction of the larger singular value, of no unit's length; the square of the length;
// and the square of that value, times the unit's.
vec4 filter_long_axis(Jacobian jacobian)
{
    vec2 dx = jacobian.change[0], dy = jacobian.change[1];
    float xx = dot(dx, dx), xy = dot(dx, dy), yy = dot(dy, dy);
    float apart = 0.5 * (xx - yy), root = sqrt(apart * apart + xy * xy);
    // Where no direction is the longest, x.
    float least = 1e-15 * (xx + yy), outer = root + abs(apart) + least;
    vec2 axis = apart < 0.0 ? vec2(xy, outer) : vec2(outer, xy);
    return vec4(axis, outer * outer + xy * xy, 0.5 * (xx + yy) + root);
}

#if FILTER == FILTER_FOOTPRINT
int filter_footprint_count(vec4 axis, float unit)
{
    float one = unit * unit;
    int count = 1;
    for (int i = 1; i < FOOTPRINT_RAYS; i++)
        count += axis.w > (float(i) - FOOTPRINT_MORE) * (float(i) - FOOTPRINT_MORE) * one ? 1 : 0;
    return count;
}

// From a ray to the next, px.
vec2 filter_footprint_pitch(vec4 axis, float unit, int count)
{
    float most = float(count * count - 1) * axis.w * axis.z;
    float square = max(axis.w - FOOTPRINT_BLUR * unit * unit, 0.0) / most;
    return count > 1 ? axis.xy * sqrt(square) : vec2(0.0);
}
#endif

// What part of a pixel each ray stands for.
mat2 ray_part(Jacobian jacobian)
{
#if FILTER == FILTER_FOOTPRINT
    vec4 axis = filter_long_axis(jacobian);
    float part = 1.0 / float(filter_footprint_count(axis, jacobian.unit));
    return mat2(1.0) - (1.0 - part) / axis.z * outerProduct(axis.xy, axis.xy);
#elif FILTER == FILTER_ADAPTIVE
    return mat2(inversesqrt(float(filter_adaptive_count(jacobian))));
#else
    return mat2(inversesqrt(float(SAMPLES)));
#endif
}

#if RIM
bool within_rim(vec2 place, vec2 apart)
{
    vec2 at = place + circle_sign * apart / circle_radius;
    return dot(at, at) <= 1.0;
}

vec2 filter_reflect(vec2 place, vec2 apart)
{
    return within_rim(place, apart) ? apart : within_rim(place, -apart) ? -apart : vec2(0.0);
}
#endif

// All that sends out rays: the centre's ray, from places of a pattern to places round the centre,
// and the centre's place in the image circle.
struct Rays {
    Varying ray;
    mat2 shape;
    vec2 place;
};

vec4 place_light(Rays rays, vec2 place)
{
    vec2 apart = rays.shape * place;
#if RIM
    apart = filter_reflect(rays.place, apart);
#endif
    return ray_light(rays.ray.at + apart.x * rays.ray.dx + apart.y * rays.ray.dy);
}

#define ADD_RAY(x, y, weight) light += weight * place_light(rays, vec2(x, y));
#define ADD_PLACE(index)                                                                           \
    {                                                                                              \
        vec3 found = pattern_place(index);                                                         \
        ADD_RAY(found.x, found.y, found.z)                                                         \
    }

// Where views are as fine as they have to be and no finer, nearly all pixels have one ray or two,
// which lie across the middle from each other. A software rasteriser goes through whatever an `if`
// excludes, but not through loops that no pixel of a group enters.
#if FILTER == FILTER_FOOTPRINT
vec4 rays_sum(Rays rays, int count)
{
    float part = 1.0 / float(max(count, 2)), end = 0.5 * float(count - 1);
    vec4 light = part * (place_light(rays, vec2(end, 0.0)) + place_light(rays, vec2(-end, 0.0)));
    for (int i = 1; i < count - 1; i++)
        ADD_RAY(float(i) - end, 0.0, part)
    return light;
}
#elif FILTER == FILTER_ADAPTIVE
vec4 rays_sum(Rays rays, int count)
{
    vec2 end = count > 1 ? PAIR_PLACE : vec2(0.0);
    vec4 light = 0.5 * (place_light(rays, end) + place_light(rays, -end));
    int first = count * (count - 1) / 2 - 3, most = count > 2 ? count : 0;
    light = most > 0 ? vec4(0.0) : light;
    for (int i = 0; i < most; i++)
        ADD_PLACE(first + i)
    return light;
}
#else
vec4 rays_sum(Rays rays, int count)
{
    vec4 light = vec4(0.0);
#if UNROLLED
    EACH_PLACE(ADD_RAY)
#else
    for (int i = 0; i < count; i++)
        ADD_PLACE(i)
#endif
    return light;
}
#endif

#if TURNED
mat2 pattern_turn(vec2 pixel)
{
    uvec2 place = uvec2(ivec2(floor(pixel)));
    float turn = 6.28318531 / 16777216.0 * float(pattern_hash(place, FILTER_SEED) >> 8);
    return mat2(cos(turn), sin(turn), -sin(turn), cos(turn));
}
#endif

// `same` as above; texels per pixel; the pixel, px in the output's image; and its place in the
// image circle.
vec4 rays_light(Varying ray, Varying same, Jacobian jacobian, vec2 pixel, vec2 place)
{
#if FILTER == FILTER_FOOTPRINT
    vec4 axis = filter_long_axis(jacobian);
    int count = filter_footprint_count(axis, jacobian.unit);
    vec2 pitch = filter_footprint_pitch(axis, jacobian.unit, count);
    return rays_sum(Rays(ray, mat2(pitch, 0.0, 0.0), place), count);
#else
#if FILTER == FILTER_ADAPTIVE
    int count = filter_adaptive_count(jacobian);
    vec4 longest = filter_long_axis(jacobian);
    vec2 axis = longest.xy * inversesqrt(3.14159265 * longest.z);
    mat2 shape = mat2(axis, -axis.y, axis.x);
#else
    const int count = SAMPLES;
    mat2 shape = filter_cone(cone_metric(ray, same));
#endif
#if TURNED
    shape = shape * pattern_turn(pixel);
#endif
    return rays_sum(Rays(ray, shape, place), count);
#endif
}
#endif
