// Which view a ray falls to and where it meets it; lib/geometry/views.c says the same under the
// same names. VIEW_COUNT is set by the program that includes this.

#ifndef RIG_BAKED // then they are constants
uniform vec3 view_selector[VIEW_COUNT];
uniform mat3 view_rotation[VIEW_COUNT]; // host's camera frame to view frame
uniform vec4 view_rect[VIEW_COUNT];     // place in the atlas: left, bottom, width, height, 0 to 1
uniform vec2 atlas_size;                // texels
#endif
#ifndef EYE_BAKED                   // then so are these, and view_fit:
uniform vec4 view_base[VIEW_COUNT]; // left, bottom, width, height of the base rectangle
#endif

int view_select(vec3 ray)
{
    int selected = 0;
    float most = dot(view_selector[0], ray);
    for (int i = 1; i < VIEW_COUNT; i++) {
        float product = dot(view_selector[i], ray);
        if (product > most) {
            most = product;
            selected = i;
        }
    }
    return selected;
}

vec2 view_hit(int view, vec3 ray)
{
    vec3 q = view_rotation[view] * ray;
    return q.xy / -q.z;
}

// From the base plane to a place in the view's base rectangle, 0 to 1.
vec2 view_place(int view, vec2 base)
{
    return (base - view_base[view].xy) / view_base[view].zw;
}

// From the base plane to coordinates in the atlas, 0 to 1.
vec2 view_texel(int view, vec2 base)
{
    return view_rect[view].xy + view_place(view, base) * view_rect[view].zw;
}

#ifdef EYE_BAKED
// view_fit scales and shifts a place on the base plane to the atlas. To turn the ray for each view
// costs less than to look up numbers by one that varies.
vec2 atlas_place(vec3 ray)
{
    vec3 q = view_rotation[0] * ray;
    vec4 fit = view_fit[0];
    float most = dot(view_selector[0], ray);
    for (int i = 1; i < VIEW_COUNT; i++) {
        float product = dot(view_selector[i], ray);
        bool more = product > most;
        q = more ? view_rotation[i] * ray : q;
        fit = more ? view_fit[i] : fit;
        most = max(most, product);
    }
    return fit.xy + q.xy / -q.z * fit.zw;
}
#else
vec2 atlas_place(vec3 ray)
{
    int view = view_select(ray);
    return view_texel(view, view_hit(view, ray));
}
#endif

// Texels per pixel where a ray meets its view: filter_jacobian in lib/geometry/filter.c.
Jacobian view_jacobian(Varying ray)
{
    int view = view_select(ray.at);
    mat3 turn = view_rotation[view];
    vec2 texels = view_rect[view].zw * atlas_size / view_base[view].zw;
    const vec3 ahead = vec3(1.0, 1.0, -1.0);
    return hit_jacobian(
        Varying(ahead * (turn * ray.at), ahead * (turn * ray.dx), ahead * (turn * ray.dy)), texels);
}
