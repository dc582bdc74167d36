#version 330 core
// Lines on the screen sphere: every 15 degrees off the dome's axis and round it; stronger at every
// 45 degrees, and red at 90 degrees off the axis.

in vec3 dome_ray;
out vec4 color;

uniform vec3 eye_m;
uniform float radius_m;

const float STEP_DEG = 15.0;

// How much of a line at every multiple of `step_deg` falls on this pixel.
float line(float angle_deg, float step_deg, float width_px)
{
    float lines = angle_deg / step_deg;
    float off = abs(fract(lines - 0.5) - 0.5) * step_deg;
    float per_pixel = max(fwidth(angle_deg), 1e-6);
    // Behind the seam of atan the angle jumps by 360 degrees.
    per_pixel = min(per_pixel, step_deg);
    return clamp(0.5 + 0.5 * width_px - off / per_pixel, 0.0, 1.0);
}

void main()
{
    vec3 ray = normalize(dome_ray);
    float along = dot(eye_m, ray);
    float t = sqrt(max(along * along - dot(eye_m, eye_m) + radius_m * radius_m, 0.0)) - along;
    vec3 point = eye_m + t * ray;
    float off_axis = degrees(atan(length(point.xy), -point.z));
    float round_axis = degrees(atan(point.y, point.x));

    float thin = max(line(off_axis, STEP_DEG, 1.0), line(round_axis, STEP_DEG, 1.0));
    float thick = max(line(off_axis, 3.0 * STEP_DEG, 2.5), line(round_axis, 3.0 * STEP_DEG, 2.5));
    float horizon = abs(off_axis - 90.0) < 0.5 * STEP_DEG ? line(off_axis, 90.0, 3.0) : 0.0;
    // The lines round the axis would run together at the pole.
    float fade = smoothstep(2.0, 6.0, min(off_axis, 180.0 - off_axis));
    thin *= fade;
    thick *= fade;
    color = vec4(mix(vec3(1.0, 0.9, 0.3), vec3(1.0, 0.2, 0.1), horizon),
                 max(max(0.45 * thin, 0.8 * thick), horizon));
}
