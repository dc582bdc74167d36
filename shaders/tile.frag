// The warp of a tile: the viewer's ray (choosing) or its place in the tile's view (pure) by the
// polynomial of the points, or the border (dark).

uniform vec2 target_corner; // of the output's image in the target, px
#if TILE_KIND == TILE_DARK
uniform vec4 border; // of pixels that are not lit
#else
#if STORAGE == STORAGE_ATLAS
uniform sampler2D atlas;
#endif
#if TILE_KIND == TILE_PURE
flat in int view;
#endif
flat in vec3 terms[10];
flat in vec2 middle;

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
    vec2 pixel = gl_FragCoord.xy - target_corner;
#if TILE_KIND == TILE_DARK
    vec4 light = border;
#else
    vec3 found = tile_vector(pixel - middle);
#if TILE_KIND == TILE_PURE
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
    color = pixel_color(light, pixel);
}
