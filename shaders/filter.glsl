// What a pixel shows by several rays: the weighted mean of what they meet. lib/geometry/filter.c
// says the same under the same names. FILTER is FILTER_CONE, FILTER_ADAPTIVE or FILTER_FOOTPRINT,
// SAMPLES the number of rays, or the most of them. RIM: rays are kept within the image circle.
//
// Before this stand the places of rays as literals: a software rasteriser reads arrays that are
// indexed by what varies anew for every pixel. RAYS_n(RAY) is RAY(x, y, weight) for each ray of a
// pattern of n, and EACH_RAYS(ONE) is ONE(n, RAYS_n) for each n; where UNROLLED is 0 they are too
// many for that, and stand in an array.

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
    if (!(root > 0.0))
        return mat2(0.0);
    float radius = inversesqrt(3.14159265 * root), length = inversesqrt(metric.x);
    return mat2(radius * root * length, 0.0, -radius * metric.y * length,
                radius * metric.x * length);
}

int filter_adaptive_count(mat2 jacobian)
{
    float covered = abs(jacobian[0].x * jacobian[1].y - jacobian[1].x * jacobian[0].y);
    return int(clamp(ceil(covered - 1e-3), 1.0, float(SAMPLES)));
}

// In xy the direction of the larger singular value, which is z.
vec3 filter_long_axis(mat2 jacobian)
{
    float xx = dot(jacobian[0], jacobian[0]), xy = dot(jacobian[0], jacobian[1]);
    float yy = dot(jacobian[1], jacobian[1]);
    float apart = 0.5 * (xx - yy), root = sqrt(apart * apart + xy * xy);
    vec2 axis = apart < 0.0 ? vec2(xy, root - apart) : vec2(apart + root, xy);
    float square = dot(axis, axis);
    axis = square > 0.0 ? axis * inversesqrt(square) : vec2(1.0, 0.0);
    return vec3(axis, sqrt(0.5 * (xx + yy) + root));
}

#if FILTER == FILTER_FOOTPRINT
int filter_footprint_count(vec3 axis)
{
    return int(clamp(ceil(axis.z + FOOTPRINT_MORE), 1.0, float(FOOTPRINT_RAYS)));
}

// From a ray to the next, px.
vec2 filter_footprint_pitch(vec3 axis, int count)
{
    float square = float(count * count - 1);
    return count > 1 ? axis.xy * (sqrt(max(axis.z * axis.z - FOOTPRINT_BLUR, 0.0) / square) / axis.z)
                     : vec2(0.0);
}
#endif

// What part of a pixel each ray stands for.
mat2 ray_part(mat2 jacobian)
{
#if FILTER == FILTER_FOOTPRINT
    vec3 axis = filter_long_axis(jacobian);
    float part = 1.0 / float(filter_footprint_count(axis));
    return mat2(1.0) - (1.0 - part) * outerProduct(axis.xy, axis.xy);
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
#define ADD_RAYS(number, rays_of)                                                                  \
    if (count == number) {                                                                         \
        rays_of(ADD_RAY)                                                                           \
    }

#if FILTER == FILTER_FOOTPRINT
vec4 rays_sum(Rays rays, int count)
{
    vec4 light = vec4(0.0);
    float part = 1.0 / float(count), middle = 0.5 * float(count - 1);
    for (int i = 0; i < count; i++)
        ADD_RAY(float(i) - middle, 0.0, part)
    return light;
}
#elif UNROLLED
vec4 rays_sum(Rays rays, int count)
{
    vec4 light = vec4(0.0);
    EACH_RAYS(ADD_RAYS)
    return light;
}
#else
vec4 rays_sum(Rays rays, int count)
{
    vec4 light = vec4(0.0);
    int first = FILTER == FILTER_ADAPTIVE ? count * (count - 1) / 2 : 0;
    for (int i = 0; i < count; i++)
        ADD_RAY(pattern_places[first + i].x, pattern_places[first + i].y,
                pattern_places[first + i].z)
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
vec4 rays_light(Varying ray, Varying same, mat2 jacobian, vec2 pixel, vec2 place)
{
#if FILTER == FILTER_FOOTPRINT
    vec3 axis = filter_long_axis(jacobian);
    int count = filter_footprint_count(axis);
    return rays_sum(Rays(ray, mat2(filter_footprint_pitch(axis, count), 0.0, 0.0), place), count);
#else
#if FILTER == FILTER_ADAPTIVE
    int count = filter_adaptive_count(jacobian);
    vec2 axis = 0.564189584 * filter_long_axis(jacobian).xy;
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
