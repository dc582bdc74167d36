// The warp of a picture: per output pixel, finds the point of the screen and its place in the
// picture. SOURCE is one of the SOURCE_... numbers. Needs no table: the derivatives, which the
// filter needs, are in none.

uniform vec2 target_corner; // of the output's image in the target, px
uniform vec4 border;        // of pixels that are not lit
#if SOURCE == SOURCE_CUBE
uniform samplerCube picture;
#else
uniform sampler2D picture;
#endif

out vec4 color;

void main()
{
    vec2 pixel = gl_FragCoord.xy - target_corner;
    Varying point = screen_point(lens_ray(circle_place(pixel)));
    float coverage = pixel_coverage(pixel, point);
    Varying inside = point_inside_rim(pixel, point);
#if JITTERS
    point = screen_point(lens_ray(circle_place(jittered_place(pixel, point))));
#endif
    Varying direction = source_direction(Varying(point.at, inside.dx, inside.dy));
#if SOURCE == SOURCE_CUBE
    vec4 light = textureGrad(picture, direction.at, direction.dx, direction.dy);
#else
    Place place;
#if SOURCE == SOURCE_DOMEMASTER
    coverage = min(coverage, domemaster_place(direction, vec2(textureSize(picture, 0)), place));
#else
    place = equirectangular_place(direction);
#endif
    vec4 light = textureGrad(picture, place.at, place.dx, place.dy);
#endif
    if (coverage > 0.0)
        light = mix(border, light, coverage);
    else
        light = border;
    color = pixel_color(light, pixel);
}
