// One overlay over an output's image. What is drawn is premultiplied, in the numbers of the target.

uniform vec2 target_corner; // of the output's image in the target, px
uniform vec4 overlay_color; // premultiplied, in linear light
uniform sampler2D picture;  // of a picture, premultiplied
uniform float half_max;     // of any overlay

out vec4 color;

// Where the height was left to a texture whose size only the shader can ask for.
vec2 half_size()
{
    if (overlay_half.y > 0.0)
        return overlay_half;
    vec2 size = vec2(max(textureSize(picture, 0), 1));
    return vec2(overlay_half.x, min(overlay_half.x * size.y / size.x, half_max));
}

// What lies over an encoded picture is mixed as numbers: encoded where alpha is 1, times alpha.
// Light above alpha shines beside what it covers and is encoded as over black; in between, the more
// of it the alpha covers the more it is the former.
vec3 over_color(vec4 light, vec2 pixel)
{
    vec3 whole = clamp(max(light.rgb, light.a), 1e-6, 1.0);
    vec3 mixed = whole * pixel_color(vec4(light.rgb / whole, 1.0), pixel).rgb;
    vec3 added = pixel_color(vec4(light.rgb, 1.0), pixel).rgb;
    return mix(added, mixed, light.a / whole);
}

void main()
{
    vec2 pixel = gl_FragCoord.xy - target_corner;
    Varying point = screen_point(lens_ray(circle_place(pixel)));
    Varying inside = point_inside_rim(pixel, point);
    Varying ray = Varying(eye_ray(point.at), tilt * inside.dx, tilt * inside.dy);
    Varying direction = overlay_direction(ray, half_size());
    float coverage = pixel_coverage(pixel, point) * overlay_coverage(direction);
    if (!(coverage > 0.0))
        discard;

    vec4 light = overlay_color;
    if (overlay_kind == KIND_PICTURE) {
        Place place = overlay_place(direction);
        light *= textureGrad(picture, place.at, place.dx, place.dy);
    }
    color = coverage * vec4(over_color(light, pixel), light.a);
}
