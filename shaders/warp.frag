// The warp: per output pixel, finds the viewer's ray, the view that it falls to and the texel that
// it meets. STAGE says how much of that stands in a table.

uniform vec2 target_corner; // of the output's image in the target, px
uniform vec4 border;        // of pixels that are not lit
uniform sampler2D atlas;
#if STAGE != STAGE_NONE
uniform sampler2D table;
#endif

out vec4 color;

void main()
{
    vec2 pixel = gl_FragCoord.xy - target_corner;
#if STAGE == STAGE_NONE
    Varying point = screen_point(lens_ray(circle_place(pixel)));
    float coverage = pixel_coverage(pixel, point);
    vec2 place = atlas_place(eye_ray(point.at));
#else
    vec4 entry = texelFetch(table, ivec2(pixel), 0);
#if STAGE == STAGE_ANGLES
    float coverage = entry.z;
    vec2 sines = sin(entry.xy), cosines = cos(entry.xy);
    vec2 place = atlas_place(vec3(sines.x * cosines.y, sines.x * sines.y, -cosines.x));
#elif STAGE == STAGE_SINES
    float coverage = length(entry.xy);
    vec2 place = atlas_place(vec3(entry.x * entry.w, entry.x * entry.z, -entry.y));
#elif STAGE == STAGE_COORDINATES
    float coverage = entry.z;
    vec2 place = entry.xy;
#else
    float coverage = entry.w;
    vec2 place = atlas_place(eye_ray(entry.xyz));
#endif
#endif
    color = border;
    if (coverage > 0.0)
        color = mix(border, textureLod(atlas, place, 0.0), coverage);
}
