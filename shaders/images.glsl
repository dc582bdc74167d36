// What views show at a place. STORAGE is STORAGE_ATLAS, rectangles of one texture; or views are
// textures of the host's: STORAGE_TEXTURES, a texture for each view, or STORAGE_LAYERS, layers of
// one. TEXELS is the number of texels that a ray means: 1, 4 or 9.

#if STORAGE == STORAGE_ATLAS
uniform sampler2D atlas;
#endif

// The mean of four bilinear taps, half a texel away each way, is one of nine texels.
#define NINE_TEXELS(image, place, half_texel)                                                      \
    (0.25 * (LIGHT_TAP(image, place, half_texel * vec2(-1.0, -1.0)) +                              \
             LIGHT_TAP(image, place, half_texel * vec2(1.0, -1.0)) +                               \
             LIGHT_TAP(image, place, half_texel * vec2(-1.0, 1.0)) +                               \
             LIGHT_TAP(image, place, half_texel * vec2(1.0, 1.0))))

// At a place in a texture, 0 to 1.
vec4 texture_light(sampler2D image, vec2 place)
{
#if TEXELS == 1
    ivec2 size = textureSize(image, 0);
    return texelFetch(image, clamp(ivec2(place * vec2(size)), ivec2(0), size - 1), 0);
#elif TEXELS == 9
#define LIGHT_TAP(image, place, apart) textureLod(image, place + apart, 0.0)
    return NINE_TEXELS(image, place, 0.5 / vec2(textureSize(image, 0)));
#undef LIGHT_TAP
#else
    return textureLod(image, place, 0.0);
#endif
}

#if STORAGE != STORAGE_ATLAS
uniform vec4 image_rect[VIEW_COUNT]; // left, bottom, width, height, texels; width 0: all of it
#if STORAGE == STORAGE_LAYERS
uniform sampler2DArray images;
uniform float image_layer[VIEW_COUNT];
#else
uniform sampler2D images[VIEW_COUNT];
#endif

vec2 image_place(int view, vec2 place, vec2 size)
{
    vec4 rect = image_rect[view];
    return rect.z > 0.0 ? (rect.xy + place * rect.zw) / size : place;
}

#if STORAGE == STORAGE_LAYERS
vec4 image_light(int view, vec2 place)
{
    ivec2 size = textureSize(images, 0).xy;
    vec2 texel = image_place(view, place, vec2(size));
#if TEXELS == 1
    ivec2 nearest = clamp(ivec2(texel * vec2(size)), ivec2(0), size - 1);
    return texelFetch(images, ivec3(nearest, int(image_layer[view] + 0.5)), 0);
#elif TEXELS == 9
#define LIGHT_TAP(image, place, apart)                                                             \
    textureLod(image, vec3(place + apart, image_layer[view]), 0.0)
    return NINE_TEXELS(images, texel, 0.5 / vec2(size));
#undef LIGHT_TAP
#else
    return textureLod(images, vec3(texel, image_layer[view]), 0.0);
#endif
}
#else
#define IMAGE_LIGHT(i) \
    texture_light(images[i], image_place(i, place, vec2(textureSize(images[i], 0))))

// Samplers of an array take no number that varies, in GLSL 3.30 and ES 3.00.
vec4 image_light(int view, vec2 place)
{
#if VIEW_COUNT > 1
    if (view == 1)
        return IMAGE_LIGHT(1);
#endif
#if VIEW_COUNT > 2
    if (view == 2)
        return IMAGE_LIGHT(2);
#endif
#if VIEW_COUNT > 3
    if (view == 3)
        return IMAGE_LIGHT(3);
#endif
#if VIEW_COUNT > 4
    if (view == 4)
        return IMAGE_LIGHT(4);
#endif
#if VIEW_COUNT > 5
    if (view == 5)
        return IMAGE_LIGHT(5);
#endif
#if VIEW_COUNT > 6
    if (view == 6)
        return IMAGE_LIGHT(6);
#endif
#if VIEW_COUNT > 7
    if (view == 7)
        return IMAGE_LIGHT(7);
#endif
    return IMAGE_LIGHT(0);
}
#endif
#endif
