// The warp: per output pixel, finds the viewer's ray, the view that it falls to and the texel that
// it meets. STAGE says how much of that stands in a table.

flat in vec2 corner; // of the output's image in the target, px
#if STAGE != STAGE_NONE
uniform sampler2D table;
#endif

out vec4 color;

vec4 ray_light(vec3 ray)
{
#if STORAGE == STORAGE_ATLAS
    return texture_light(atlas, atlas_place(ray));
#else
    int view = view_select(ray);
    return image_light(view, view_place(view, view_hit(view, ray)));
#endif
}

#if RAYS
// Several rays, by a stage that has no table.
vec4 pixel_light(vec2 pixel, Varying point)
{
    Varying inside = point_inside_rim(pixel, point);
    Varying ray = Varying(eye_ray(point.at), tilt * inside.dx, tilt * inside.dy);
    return rays_light(ray, ray, view_jacobian(ray), pixel, circle_place(pixel).xy);
}
#endif

void main()
{
    vec2 pixel = gl_FragCoord.xy - corner;
    vec4 light = border;
#if STAGE == STAGE_NONE
    Varying point = screen_point(lens_ray(circle_place(pixel)));
    float coverage = pixel_coverage(pixel, point);
    vec2 from = pixel;
#if JITTERS
    from = jittered_place(pixel, point);
    point = screen_point(lens_ray(circle_place(from)));
#endif
    vec3 ray = eye_ray(point.at);
#else
    vec4 entry = texelFetch(table, ivec2(pixel), 0);
#if STAGE == STAGE_ANGLES
    float coverage = entry.z;
    vec2 sines = sin(entry.xy), cosines = cos(entry.xy);
    vec3 ray = vec3(sines.x * cosines.y, sines.x * sines.y, -cosines.x);
#elif STAGE == STAGE_SINES
    float coverage = length(entry.xy);
    vec3 ray = vec3(entry.x * entry.w, entry.x * entry.z, -entry.y);
#elif STAGE == STAGE_COORDINATES
    float coverage = entry.z;
#else
    float coverage = entry.w;
    vec3 ray = eye_ray(entry.xyz);
#endif
#endif

    if (coverage > 0.0)
#if RAYS
        light = mix(border, pixel_light(from, point), coverage);
#elif STAGE == STAGE_COORDINATES
        light = mix(border, texture_light(atlas, entry.xy), coverage);
#else
        light = mix(border, ray_light(ray), coverage);
#endif
    color = pixel_color(light, pixel);
}
