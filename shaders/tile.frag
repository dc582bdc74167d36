// The warp of a tile by the polynomial of the points: its place in the tile's view (pure) or in one
// of its two views (pair), or the viewer's ray (choosing); or the border (dark).

#if TILE_KIND == TILE_DARK || (CORNER && TILE_KIND != TILE_PAIR)
flat in vec2 corner; // of the output's image in the target, px
#endif
#if TILE_KIND != TILE_DARK
#if TILE_KIND == TILE_PAIR
flat in mat3x4 across; // and in the fourth row the corner
flat in vec3 lead;
#endif
#if METRIC && (TILE_KIND == TILE_PURE || TILE_KIND == TILE_PAIR)
#define TERM vec4
#else
#define TERM vec3
#endif
flat in TERM terms[10];
flat in vec4 middle;

vec3 tile_vector(vec2 p)
{
    TERM x = terms[1] + p.x * (terms[3] + p.x * terms[6]);
    TERM y = terms[2] + p.x * (terms[4] + p.x * terms[7]);
    TERM yy = terms[5] + p.x * terms[8] + p.y * terms[9];
    return (terms[0] + p.x * x + p.y * (y + p.y * yy)).xyz;
}

// What a ray shows, which in a tile of one view or two is a place in the first, homogeneous.
vec4 ray_light(vec3 ray)
{
#if TILE_KIND == TILE_PURE || TILE_KIND == TILE_PAIR
#if TILE_KIND == TILE_PAIR
    bool crossed = dot(lead, ray) > 0.0;
    ray = crossed ? (across * ray).xyz : ray;
    int view = int(crossed ? middle.w : middle.z);
#else
    int view = int(middle.z);
#endif
    vec2 place = ray.xy * (1.0 / ray.z);
#elif STORAGE == STORAGE_ATLAS
    vec2 place = atlas_place(ray);
#else
    int view = view_select(ray);
    vec2 place = view_place(view, view_hit(view, ray));
#endif
#if STORAGE == STORAGE_ATLAS
    return texture_light(atlas, place);
#else
    return image_light(view, place);
#endif
}

#if RAYS
// The same, and its changes.
Varying tile_varying(vec2 p)
{
    vec3 xxx = p.x * terms[6].xyz, xx = terms[3].xyz + xxx, xy = terms[4].xyz + p.x * terms[7].xyz;
    vec3 yyy = p.y * terms[9].xyz, yy = terms[5].xyz + p.x * terms[8].xyz + yyy;
    vec3 x = terms[1].xyz + p.x * xx, y = terms[2].xyz + p.x * xy;
    return Varying(terms[0].xyz + p.x * x + p.y * (y + p.y * yy),
                   x + p.x * (xx + xxx) + p.y * (xy + p.x * terms[7].xyz + p.y * terms[8].xyz),
                   y + p.y * (yy + yy + yyy));
}

#if TILE_KIND == TILE_CHOOSING
Jacobian tile_jacobian(Varying ray)
{
    return view_jacobian(ray);
}

Varying tile_same(Varying ray)
{
    return ray;
}
#else
Jacobian tile_jacobian(Varying ray)
{
    int view = int(middle.z);
#if TILE_KIND == TILE_PAIR
    if (dot(lead, ray.at) > 0.0) {
        ray = Varying((across * ray.at).xyz, (across * ray.dx).xyz, (across * ray.dy).xyz);
        view = int(middle.w);
    }
#endif
#if STORAGE == STORAGE_ATLAS
    return hit_jacobian(ray, atlas_size);
#else
    return hit_jacobian(ray, atlas_size * view_rect[view].zw);
#endif
}

#if METRIC
Varying tile_same(Varying ray)
{
    mat3 same = mat3(terms[0].w, terms[1].w, terms[2].w, terms[1].w, terms[3].w, terms[4].w,
                     terms[2].w, terms[4].w, terms[5].w);
    return Varying(same * ray.at, same * ray.dx, same * ray.dy);
}
#else
Varying tile_same(Varying ray)
{
    return ray; // nobody asks
}
#endif
#endif
#endif
#endif

out vec4 color;

void main()
{
#if TILE_KIND == TILE_PAIR && CORNER
    vec2 pixel = gl_FragCoord.xy - vec2(across[0].w, across[1].w);
#elif TILE_KIND == TILE_DARK || CORNER
    vec2 pixel = gl_FragCoord.xy - corner;
#else
    vec2 pixel = vec2(0.0); // nobody asks
#endif
#if TILE_KIND == TILE_DARK
    vec4 light = border;
#elif RAYS
    Varying ray = tile_varying(gl_FragCoord.xy - middle.xy);
    vec4 light = rays_light(ray, tile_same(ray), tile_jacobian(ray), pixel, vec2(0.0));
#else
    vec4 light = ray_light(tile_vector(gl_FragCoord.xy - middle.xy));
#endif
    color = pixel_color(light, pixel);
}
