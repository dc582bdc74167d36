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
    float alpha = light.a > 0.0 ? light.a : 1.0;
    color.rgb = alpha * pixel_color(vec4(light.rgb / alpha, 1.0), pixel).rgb;
    color = coverage * vec4(color.rgb, light.a);
}
