// The lens models; lib/geometry/lens.c says the same under the same names. LENS_MODEL is one of the
// LENS_... numbers, set by the program that includes this. asin and acos are avoided: some
// implementations err by 4e-4 rad in them.

#ifndef RIG_BAKED            // then they are constants
uniform float lens_half_fov; // h, rad
uniform float lens_scale;    // hemispheric sin h, equisolid sin(h/2), stereographic tan(h/2)
uniform vec4 lens_k;         // polynomial, scaled to r = 1 at h
#endif

#if LENS_MODEL == LENS_TABLE
uniform int lens_knot_count;
uniform vec3 lens_knots[LENS_KNOTS_MAX]; // angle, r, dr/dangle

// r and dr/dangle on the cubic of interval i, t from 0 to 1.
vec2 lens_table_cubic(int i, float t)
{
    vec3 a = lens_knots[i], b = lens_knots[i + 1];
    float width = b.x - a.x, rise = b.y - a.y;
    float c1 = width * a.z, c2 = 3.0 * rise - width * (2.0 * a.z + b.z);
    float c3 = width * (a.z + b.z) - 2.0 * rise;
    return vec2(a.y + t * (c1 + t * (c2 + t * c3)), (c1 + t * (2.0 * c2 + t * 3.0 * c3)) / width);
}

// r and dr/dangle at an angle.
vec2 lens_table_at(float angle)
{
    int i = 0;
    while (i + 2 < lens_knot_count && lens_knots[i + 1].x <= angle)
        i++;
    return lens_table_cubic(i, (angle - lens_knots[i].x) / (lens_knots[i + 1].x - lens_knots[i].x));
}

float lens_table_radius(float angle)
{
    return lens_table_at(angle).x;
}

float lens_table_slope(float angle)
{
    return lens_table_at(angle).y;
}

float lens_table_angle(float r)
{
    int i = 0;
    while (i + 2 < lens_knot_count && lens_knots[i + 1].y <= r)
        i++;
    float width = lens_knots[i + 1].x - lens_knots[i].x;
    float low = 0.0, high = 1.0;
    float t = clamp((r - lens_knots[i].y) / (lens_knots[i + 1].y - lens_knots[i].y), 0.0, 1.0);
    for (int iteration = 0; iteration < 12; iteration++) {
        vec2 value = lens_table_cubic(i, t);
        if (value.x > r)
            high = t;
        else
            low = t;
        float next = t - (value.x - r) / (value.y * width);
        t = next >= low && next <= high ? next : 0.5 * (low + high);
    }
    return lens_knots[i].x + t * width;
}
#endif

#if LENS_MODEL == LENS_POLYNOMIAL
float lens_polynomial_radius(float angle)
{
    float u = angle * angle;
    return angle * (lens_k.x + u * (lens_k.y + u * (lens_k.z + u * lens_k.w)));
}

float lens_polynomial_slope(float angle)
{
    float u = angle * angle;
    return lens_k.x + u * (3.0 * lens_k.y + u * (5.0 * lens_k.z + u * 7.0 * lens_k.w));
}

float lens_polynomial_angle(float r)
{
    float low = 0.0, high = lens_half_fov, angle = r * lens_half_fov;
    for (int iteration = 0; iteration < 12; iteration++) {
        float excess = lens_polynomial_radius(angle) - r;
        if (excess > 0.0)
            high = angle;
        else
            low = angle;
        float next = angle - excess / lens_polynomial_slope(angle);
        angle = next >= low && next <= high ? next : 0.5 * (low + high);
    }
    return angle;
}
#endif

// sin(angle) / r, cos(angle) and dangle/dr at an image radius of 0 to 1.
vec3 lens_sines(float r)
{
    const float least_cosine = 1e-6;
#if LENS_MODEL == LENS_HEMISPHERIC
    float s = r * lens_scale;
    float cosine = sqrt(max(1.0 - s * s, 0.0));
    return vec3(lens_scale, cosine, lens_scale / max(cosine, least_cosine));
#elif LENS_MODEL == LENS_EQUISOLID
    float half_sine = r * lens_scale;
    float half_cosine = sqrt(max(1.0 - half_sine * half_sine, 0.0));
    return vec3(2.0 * lens_scale * half_cosine, 1.0 - 2.0 * half_sine * half_sine,
                2.0 * lens_scale / max(half_cosine, least_cosine));
#elif LENS_MODEL == LENS_STEREOGRAPHIC
    float half_tangent = r * lens_scale;
    float square = half_tangent * half_tangent;
    return vec3(2.0 * lens_scale, 1.0 - square, 2.0 * lens_scale) / (1.0 + square);
#else
#if LENS_MODEL == LENS_POLYNOMIAL
    float angle = lens_polynomial_angle(r);
    float slope = 1.0 / lens_polynomial_slope(angle);
#elif LENS_MODEL == LENS_TABLE
    float angle = lens_table_angle(r);
    float slope = 1.0 / max(lens_table_slope(angle), least_cosine);
#else
    float angle = lens_half_fov * r;
    float slope = lens_half_fov;
#endif
    return vec3(r > 1e-6 ? sin(angle) / r : slope, cos(angle), slope);
#endif
}

// The image radius of a direction by the sine and cosine of its angle (any common factor); above 1
// outside of the lens.
float lens_radius(float sine, float cosine)
{
#if LENS_MODEL == LENS_ANGULAR
    return atan(sine, cosine) / lens_half_fov;
#else
    float angle = atan(sine, cosine);
    if (angle > lens_half_fov)
        return 2.0;
    float length_both = length(vec2(sine, cosine));
    sine /= length_both;
    cosine /= length_both;
#if LENS_MODEL == LENS_HEMISPHERIC
    return sine / lens_scale;
#elif LENS_MODEL == LENS_EQUISOLID
    return sine / (lens_scale * sqrt(max(2.0 + 2.0 * cosine, 1e-12)));
#elif LENS_MODEL == LENS_STEREOGRAPHIC
    return sine / (lens_scale * max(1.0 + cosine, 1e-12));
#elif LENS_MODEL == LENS_POLYNOMIAL
    return lens_polynomial_radius(angle);
#else
    return lens_table_radius(angle);
#endif
#endif
}
