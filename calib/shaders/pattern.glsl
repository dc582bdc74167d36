#version 330 core
// What all patterns share: from an output pixel to its place on the dome, and lines that are a
// given number of pixels wide wherever they run.
//
// A pattern is a function of a unit vector whose middle is -Z, right +X and up +Y: the direction
// from the dome's centre in the dome frame, or from the viewer's eye in the camera's.

uniform sampler2D points; // D in metres, dome frame, and coverage
uniform mat3 to_pattern;  // dome frame to the pattern's
uniform vec3 origin_m;    // the dome's centre or the eye

out vec4 color;

const float PI = 3.14159265358979323846;

// A unit vector and its change per pixel.
struct Direction {
    vec3 at;
    vec3 dx;
    vec3 dy;
};

// Off the axis -Z and round it, radians; what changes per pixel is an arc in both, so that it has
// no seam behind the axis and is finite at the poles.
struct Polar {
    float off;
    float round;     // counter-clockwise from +X
    float sine;      // of `off`
    float off_px;    // radians of arc per pixel across lines of equal `off`
    float round_px;  // likewise of equal `round`
};

vec3 light(Direction d, vec2 pixel);

Polar polar(Direction d)
{
    float sine = length(d.at.xy);
    vec2 outwards = sine > 0.0 ? d.at.xy / sine : vec2(1.0, 0.0);
    vec3 along = vec3(-d.at.z * outwards, sine), across = vec3(-outwards.y, outwards.x, 0.0);
    return Polar(atan(sine, -d.at.z), sine > 0.0 ? atan(d.at.y, d.at.x) : 0.0, sine,
                 max(length(vec2(dot(along, d.dx), dot(along, d.dy))), 1e-9),
                 max(length(vec2(dot(across, d.dx), dot(across, d.dy))), 1e-9));
}

Direction turned(mat3 m, Direction d)
{
    return Direction(m * d.at, m * d.dx, m * d.dy);
}

// The same with the zenith as the axis and `round` counted from the middle to the left.
Direction upright(Direction d)
{
    return turned(mat3(0.0, -1.0, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0), d);
}

// How much of a pixel a line covers.
float line(float off_px, float width_px)
{
    return clamp(0.5 + 0.5 * width_px - abs(off_px), 0.0, 1.0);
}

// Signed distance from the nearest multiple.
float beside(float angle, float spacing)
{
    return angle - spacing * floor(angle / spacing + 0.5);
}

// Lines at all multiples of `step_deg` off the axis and round it.
float circles(Polar p, float step_deg, float width_px)
{
    return line(beside(p.off, radians(step_deg)) / p.off_px, width_px);
}

float meridians(Polar p, float step_deg, float width_px)
{
    float off = sin(clamp(beside(p.round, radians(step_deg)), -0.5 * PI, 0.5 * PI));
    return line(off * p.sine / p.round_px, width_px);
}

// One of them alone.
float circle(Polar p, float off_deg, float width_px)
{
    return line((p.off - radians(off_deg)) / p.off_px, width_px);
}

float meridian(Polar p, float round_deg, float width_px)
{
    float off = p.round - radians(round_deg);
    if (cos(off) < 0.0)
        return 0.0;
    return line(sin(off) * p.sine / p.round_px, width_px);
}

// How much of a pixel lies between two values.
float between(float value, float low, float high, float per_pixel)
{
    return clamp((value - low) / per_pixel + 0.5, 0.0, 1.0) *
           clamp((high - value) / per_pixel + 0.5, 0.0, 1.0);
}

// IEC 61966-2-1.
vec3 srgb_encode(vec3 linear)
{
    linear = clamp(linear, 0.0, 1.0);
    vec3 curve = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

vec3 srgb_decode(vec3 codes)
{
    vec3 curve = pow((codes + 0.055) / 1.055, vec3(2.4));
    return mix(curve, codes / 12.92, lessThanEqual(codes, vec3(0.04045)));
}

void main()
{
    vec2 pixel = gl_FragCoord.xy;
    vec4 point = texelFetch(points, ivec2(pixel), 0);
    vec3 at = normalize(to_pattern * (point.xyz - origin_m));
    vec3 seen = light(Direction(at, dFdx(at), dFdy(at)), pixel);
    color = vec4(srgb_encode(seen * point.w), point.w);
}
