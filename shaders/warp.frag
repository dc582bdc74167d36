// The warp: per output pixel, finds the viewer's ray, the view that it falls to and the texel that
// it meets. STAGE says how much of that stands in a table.

flat in vec2 corner; // of the output's image in the target, px
#if STORAGE == STORAGE_ATLAS
uniform sampler2D atlas;
#endif
#if STAGE != STAGE_NONE
uniform sampler2D table;
#endif

out vec4 color;

void main()
{
    vec2 pixel = gl_FragCoord.xy - corner;
#if STAGE == STAGE_NONE
    Varying point = screen_point(lens_ray(circle_place(pixel)));
    float coverage = pixel_coverage(pixel, point);
#if JITTERS
    point = screen_point(lens_ray(circle_place(jittered_place(pixel, point))));
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

    vec4 light = border;
#if STORAGE == STORAGE_ATLAS
#if STAGE == STAGE_COORDINATES
    vec2 place = entry.xy;
#else
    vec2 place = atlas_place(ray);
#endif
    if (coverage > 0.0)
        light = mix(border, textureLod(atlas, place, 0.0), coverage);
#else
    int view = view_select(ray);
    vec2 place = view_place(view, view_hit(view, ray));
    if (coverage > 0.0)
        light = mix(border, image_light(view, place), coverage);
#endif
    color = pixel_color(light, pixel);
}
