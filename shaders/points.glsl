// Points and rays of one output; lib/geometry/points.c says the same under the same names.

uniform vec2 output_size;        // px
uniform vec2 circle_center;      // px
uniform float circle_radius;     // px
uniform vec2 circle_sign;        // -1 where the picture is flipped
uniform mat3 aim;                // Q, lens frame to dome frame
uniform vec3 projector_position; // L, m, dome frame
uniform float screen_radius;     // R, m
uniform float cap_cosine;        // below -1: no cap
uniform mat3 tilt;               // dome frame to the host's camera frame
uniform vec3 eye;                // E, m, dome frame

// x and y in the image circle with r = 1 at the rim, and r; places beyond it come out on it. There
// r is 1 to the last bit: at the rim of a hemispheric lens of 180 degrees 1e-7 of it are 0.03
// degrees.
vec3 circle_place(vec2 pixel)
{
    vec2 place = circle_sign * (pixel - circle_center) / circle_radius;
    float r = length(place);
    return r > 1.0 ? vec3(place / r, 1.0) : vec3(place, r);
}

vec3 lens_ray(vec3 place)
{
    vec2 sines = lens_sines(place.z);
    return aim * vec3(place.xy * sines.x, -sines.y);
}

vec3 screen_point(vec3 ray)
{
    float along = dot(projector_position, ray);
    float root = sqrt(along * along - dot(projector_position, projector_position) +
                      screen_radius * screen_radius);
    return projector_position + (root - along) * ray;
}

vec3 eye_ray(vec3 point)
{
    return tilt * (point - eye);
}

float edge_coverage(float distance_px, vec2 normal)
{
    float steepness = length(normal);
    if (!(steepness > 0.0))
        return distance_px > 0.0 ? 1.0 : 0.0;
    vec2 widths = abs(normal) / steepness;
    float a = max(widths.x, widths.y), b = max(min(widths.x, widths.y), 0.01);
    vec4 ends = 0.5 * vec4(a + b, a - b, b - a, -a - b);
    vec4 ramps = max(vec4(distance_px) + ends, 0.0);
    if (ramps.w > 0.0)
        return 1.0;
    ramps *= ramps;
    return clamp((ramps.x - ramps.y - ramps.z) / (2.0 * a * b), 0.0, 1.0);
}

// How far inside of the cap's edge a place is lit; the cosines' difference.
float cap_excess(vec2 place)
{
    vec3 point = screen_point(lens_ray(vec3(place, min(length(place), 1.0))));
    return -point.z / screen_radius - cap_cosine;
}

// The gradient of the cap's edge by differences of an eighth of a pixel, towards the middle of the
// image circle: beyond the rim, where places come out on it, there is nothing to take them from.
float pixel_coverage(vec2 pixel, vec3 point)
{
    vec2 from_center = pixel - circle_center;
    float rim = edge_coverage(circle_radius - length(from_center), from_center);
    if (cap_cosine < -1.0)
        return rim;
    float excess = -point.z / screen_radius - cap_cosine;
    vec2 place = circle_place(pixel).xy;
    vec2 inwards = (0.125 / circle_radius) * (1.0 - 2.0 * step(0.0, place));
    vec2 ahead = vec2(cap_excess(place + vec2(inwards.x, 0.0)),
                      cap_excess(place + vec2(0.0, inwards.y)));
    vec2 gradient = (ahead - excess) * 8.0;
    return min(rim, edge_coverage(excess / max(length(gradient), 1e-12), gradient));
}

// From a direction at the lens (dome frame, any length) to image coordinates; z is the image
// radius, above 1 outside of the lens.
vec3 lens_pixel(vec3 direction)
{
    vec3 v = transpose(aim) * direction;
    float across = length(v.xy);
    float r = lens_radius(across, -v.z);
    vec2 place = across > 0.0 ? v.xy * (r / across) : vec2(0.0);
    return vec3(circle_center + circle_sign * circle_radius * place, r);
}
