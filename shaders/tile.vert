// A square tile of an output, drawn as a point; what there is of them is said in
// lib/geometry/tiles.h.

layout(location = 0) in vec4 tile; // lower left corner and side, px; the view that it falls to

uniform vec2 viewport_size; // px: whole tiles

#if TILE_KIND == TILE_PURE || TILE_KIND == TILE_CHOOSING
layout(location = 1) in vec3 term_1; // of D, in px from the tile's middle
layout(location = 2) in vec3 term_x;
layout(location = 3) in vec3 term_y;
layout(location = 4) in vec3 term_xx;
layout(location = 5) in vec3 term_xy;
layout(location = 6) in vec3 term_yy;
layout(location = 7) in vec3 term_xxx;
layout(location = 8) in vec3 term_xxy;
layout(location = 9) in vec3 term_xyy;
layout(location = 10) in vec3 term_yyy;

uniform vec3 eye; // E, m, dome frame
#if TILE_KIND == TILE_PURE
uniform mat3 tile_view[VIEW_COUNT]; // from dome frame to places in a view, homogeneous
flat out int view;
#else
uniform mat3 tilt; // dome frame to the host's camera frame
#endif

flat out vec3 terms[10];
flat out vec2 middle;
#endif

void main()
{
    gl_Position = vec4(2.0 * (tile.xy + 0.5 * tile.z) / viewport_size - 1.0, 0.0, 1.0);
    gl_PointSize = tile.z;
#if TILE_KIND == TILE_PURE || TILE_KIND == TILE_CHOOSING
    middle = tile.xy + 0.5 * tile.z;
#if TILE_KIND == TILE_PURE
    view = int(tile.w);
    mat3 turn = tile_view[view];
#else
    mat3 turn = tilt;
#endif
    terms[0] = turn * (term_1 - eye);
    terms[1] = turn * term_x;
    terms[2] = turn * term_y;
    terms[3] = turn * term_xx;
    terms[4] = turn * term_xy;
    terms[5] = turn * term_yy;
    terms[6] = turn * term_xxx;
    terms[7] = turn * term_xxy;
    terms[8] = turn * term_xyy;
    terms[9] = turn * term_yyy;
#endif
}
