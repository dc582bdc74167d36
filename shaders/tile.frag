// The warp of a tile by the polynomial of the points: its place in the tile's view (pure) or in one
// of its two views (pair), or the viewer's ray (choosing); or the border (dark).

#if TILE_KIND == TILE_DARK || (GAIN && TILE_KIND != TILE_PAIR)
flat in vec2 corner; // of the output's image in the target, px
#endif
#if TILE_KIND != TILE_DARK
#if STORAGE == STORAGE_ATLAS
uniform sampler2D atlas;
#endif
#if TILE_KIND == TILE_PAIR
flat in mat3x4 across; // and in the fourth row the corner
flat in vec3 lead;
#endif
flat in vec3 terms[10];
flat in vec4 middle;

vec3 tile_vector(vec2 p)
{
    vec3 x = terms[1] + p.x * (terms[3] + p.x * terms[6]);
    vec3 y = terms[2] + p.x * (terms[4] + p.x * terms[7]);
    return terms[0] + p.x * x + p.y * (y + p.y * (terms[5] + p.x * terms[8] + p.y * terms[9]));
}
#endif

out vec4 color;

void main()
{
#if TILE_KIND == TILE_DARK
    vec4 light = border;
#else
    vec3 found = tile_vector(gl_FragCoord.xy - middle.xy);
#if TILE_KIND == TILE_PURE || TILE_KIND == TILE_PAIR
#if TILE_KIND == TILE_PAIR
    bool crossed = dot(lead, found) > 0.0;
    found = crossed ? (across * found).xyz : found;
    int view = int(crossed ? middle.w : middle.z);
#else
    int view = int(middle.z);
#endif
    vec2 place = found.xy * (1.0 / found.z);
#elif STORAGE == STORAGE_ATLAS
    vec2 place = atlas_place(found);
#else
    int view = view_select(found);
    vec2 place = view_place(view, view_hit(view, found));
#endif
#if STORAGE == STORAGE_ATLAS
    vec4 light = textureLod(atlas, place, 0.0);
#else
    vec4 light = image_light(view, place);
#endif
#endif
#if TILE_KIND == TILE_PAIR && GAIN
    color = pixel_color(light, gl_FragCoord.xy - vec2(across[0].w, across[1].w));
#elif TILE_KIND == TILE_DARK || GAIN
    color = pixel_color(light, gl_FragCoord.xy - corner);
#else
    color = pixel_color(light, vec2(0.0));
#endif
}
