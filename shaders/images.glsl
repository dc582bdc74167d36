// The views where they are textures of the host's; STORAGE is STORAGE_TEXTURES, a texture for each
// view, or STORAGE_LAYERS, layers of one.

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
    vec2 texel = image_place(view, place, vec2(textureSize(images, 0).xy));
    return textureLod(images, vec3(texel, image_layer[view]), 0.0);
}
#else
#define IMAGE_LIGHT(i) \
    textureLod(images[i], image_place(i, place, vec2(textureSize(images[i], 0))), 0.0)

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
