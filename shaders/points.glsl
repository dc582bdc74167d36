// Points and rays of one output; lib/geometry/points.c says the same under the same names.

#ifndef RIG_BAKED                // then they are constants
uniform vec2 output_size;        // px
uniform vec2 circle_center;      // px
uniform vec2 circle_sign;        // -1 where the picture is flipped
uniform mat3 aim;                // Q, lens frame to dome frame
uniform vec3 projector_position; // L, m, dome frame
uniform float screen_radius;     // R, m
uniform float screen_room;       // R^2 - L^2, m^2
uniform float cap_cosine;        // below -1: no cap, and then CAPPED is 0
uniform mat3 tilt;               // dome frame to the host's camera frame
#endif
#ifndef EYE_BAKED
uniform vec3 eye; // E, m, dome frame
#endif
// Not a constant: compilers do not divide by one but multiply by its inverse, rounded, which steep
// lenses show.
uniform float circle_radius; // px

// x and y in the image circle with r = 1 at the rim, and r; places beyond it come out on it. There
// r is 1 to the last bit: at the rim of a hemispheric lens of 180 degrees 1e-7 of it are 0.03
// degrees.
vec3 circle_place(vec2 pixel)
{
    vec2 place = circle_sign * (pixel - circle_center) / circle_radius;
    float r = length(place);
    return r > 1.0 ? vec3(place / r, 1.0) : vec3(place, r);
}

Varying lens_ray(vec3 place)
{
    float x = place.x, y = place.y, r = place.z;
    vec3 sines = lens_sines(r);
    float s = sines.x, slope = sines.z;
    // What rounding makes of it is large for small r, but not times x or y, squared.
    float bend = r > 1e-4 ? (sines.y * slope - s) / (r * r) : 0.0;
    vec3 dx = vec3(s + x * x * bend, x * y * bend, x * s * slope);
    vec3 dy = vec3(x * y * bend, s + y * y * bend, y * s * slope);
    vec2 per_pixel = circle_sign / circle_radius;
    return Varying(aim * vec3(place.xy * s, -sines.y), aim * (dx * per_pixel.x),
                   aim * (dy * per_pixel.y));
}

Varying screen_point(Varying ray)
{
    float along = dot(projector_position, ray.at);
    float root = sqrt(along * along + screen_room);
    float t = root - along;
    float dt_dx = dot(projector_position, ray.dx) * (along / root - 1.0);
    float dt_dy = dot(projector_position, ray.dy) * (along / root - 1.0);
    return Varying(projector_position + t * ray.at, dt_dx * ray.at + t * ray.dx,
                   dt_dy * ray.at + t * ray.dy);
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

// The pixel's point, near the rim one half a pixel inside of it: at the rim itself the derivatives
// may be infinite.
Varying point_inside_rim(vec2 pixel, Varying point)
{
    vec3 place = circle_place(pixel);
    float most = max(1.0 - 0.5 / circle_radius, 0.0);
    if (place.z > most)
        point = screen_point(lens_ray(vec3(place.xy * (most / place.z), most)));
    return point;
}

float pixel_coverage(vec2 pixel, Varying point)
{
    vec2 from_center = pixel - circle_center;
    float rim = edge_coverage(circle_radius - length(from_center), from_center);
#if CAPPED
    Varying inside = point_inside_rim(pixel, point);
    vec2 gradient = vec2(inside.dx.z, inside.dy.z) / -screen_radius;
    float excess = -point.at.z / screen_radius - cap_cosine;
    return min(rim, edge_coverage(excess / max(length(gradient), 1e-12), gradient));
#else
    return rim;
#endif
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
