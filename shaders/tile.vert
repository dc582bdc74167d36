// A square tile of an output, drawn as a point; what there is of them is said in
// lib/geometry/tiles.h. Whatever a fragment needs is the same all over the tile, and comes from
// here: a software rasteriser reads a uniform anew for every pixel.

layout(location = 0) in vec4 tile; // lower left corner and side, px; the view that it falls to

uniform vec2 viewport_size; // px: whole tiles
uniform vec2 target_corner; // of the output's image in the target, px
#if JITTERS
uniform vec2 ray_jitter; // px
#endif

#if TILE_KIND == TILE_DARK || TILE_KIND == TILE_EXACT || (CORNER && TILE_KIND != TILE_PAIR)
flat out vec2 corner;
#endif
#if TILE_KIND == TILE_PURE || TILE_KIND == TILE_PAIR || TILE_KIND == TILE_CHOOSING
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

#ifndef EYE_BAKED
uniform vec3 eye; // E, m, dome frame
#endif
#if TILE_KIND == TILE_PURE || TILE_KIND == TILE_PAIR
uniform mat3 tile_view[VIEW_COUNT]; // from dome frame to places in a view, homogeneous
#elif !defined(RIG_BAKED)
uniform mat3 tilt; // dome frame to the host's camera frame
#endif

#if TILE_KIND == TILE_PAIR
layout(location = 11) in vec3 across_x; // columns: from places in the view to those in the other
layout(location = 12) in vec3 across_y;
layout(location = 13) in vec3 across_z;
layout(location = 14) in vec4 other; // what is above 0 where the other view has it; that view

// 15 vectors are what every OpenGL ES 3.0 has, and a pair needs them all: 3, 1, 10 and 1. So the
// corner stands in the fourth row.
flat out mat3x4 across;
flat out vec3 lead;
#endif

#if METRIC && (TILE_KIND == TILE_PURE || TILE_KIND == TILE_PAIR)
#define TERM vec4
#define TERM_OF(term, other) vec4(term, other)
#else
#define TERM vec3
#define TERM_OF(term, other) term
#endif
// With a filter that needs it the fourth row of the first six terms is what makes products of
// places in a view those of directions: xx, xy, xz, yy, yz, zz.
flat out TERM terms[10];
flat out vec4 middle; // in the target, px; its views
#endif

void main()
{
    gl_Position = vec4(2.0 * (tile.xy + 0.5 * tile.z) / viewport_size - 1.0, 0.0, 1.0);
    gl_PointSize = tile.z;
#if TILE_KIND == TILE_DARK || TILE_KIND == TILE_EXACT || (CORNER && TILE_KIND != TILE_PAIR)
    corner = target_corner;
#endif
#if TILE_KIND == TILE_PURE || TILE_KIND == TILE_PAIR || TILE_KIND == TILE_CHOOSING
    middle = vec4(target_corner + tile.xy + 0.5 * tile.z, tile.w, tile.w);
#if JITTERS
    middle.xy -= ray_jitter;
#endif
#if TILE_KIND == TILE_CHOOSING
    mat3 turn = tilt;
#else
    mat3 turn = tile_view[int(tile.w)];
#endif
#if TILE_KIND == TILE_PAIR
    across = mat3x4(vec4(across_x, target_corner.x), vec4(across_y, target_corner.y),
                    vec4(across_z, 0.0));
    lead = other.xyz;
    middle.w = other.w;
#endif
#if METRIC && TILE_KIND != TILE_CHOOSING
    mat3 back = inverse(turn);
    mat3 same = transpose(back) * back;
#endif
    terms[0] = TERM_OF(turn * (term_1 - eye), same[0].x);
    terms[1] = TERM_OF(turn * term_x, same[0].y);
    terms[2] = TERM_OF(turn * term_y, same[0].z);
    terms[3] = TERM_OF(turn * term_xx, same[1].y);
    terms[4] = TERM_OF(turn * term_xy, same[1].z);
    terms[5] = TERM_OF(turn * term_yy, same[2].z);
    terms[6] = TERM_OF(turn * term_xxx, 0.0);
    terms[7] = TERM_OF(turn * term_xxy, 0.0);
    terms[8] = TERM_OF(turn * term_xyy, 0.0);
    terms[9] = TERM_OF(turn * term_yyy, 0.0);
#endif
}
