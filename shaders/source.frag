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

#if SOURCE == SOURCE_CUBE
// The direction's coordinates along the face that it meets, and towards it.
vec3 face_turn(vec3 along, vec3 direction)
{
    vec3 reach = abs(along);
    return reach.x >= max(reach.y, reach.z)   ? direction.yzx
           : reach.y >= max(reach.x, reach.z) ? direction.xzy
                                              : direction.xyz;
}

Jacobian picture_jacobian(Varying direction)
{
    vec3 at = direction.at;
    return hit_jacobian(
        Varying(face_turn(at, at), face_turn(at, direction.dx), face_turn(at, direction.dy)),
        0.5 * vec2(textureSize(picture, 0)));
}

vec4 direction_light(Varying direction)
{
#if TEXELS == 9
    vec3 reach = abs(direction.at);
    float across = max(max(reach.x, reach.y), reach.z) / float(textureSize(picture, 0).x);
    vec3 ahead = step(vec3(max(max(reach.x, reach.y), reach.z)), reach);
    vec3 right = ahead.x > 0.0 ? vec3(0.0, across, 0.0) : vec3(across, 0.0, 0.0);
    vec3 up = ahead.z > 0.0 && ahead.x == 0.0 && ahead.y == 0.0 ? vec3(0.0, across, 0.0)
                                                                : vec3(0.0, 0.0, across);
    vec4 light = vec4(0.0);
    for (int i = 0; i < 4; i++) {
        vec2 apart = 2.0 * vec2(i & 1, i >> 1) - 1.0;
        light += 0.25 * textureGrad(picture, direction.at + apart.x * right + apart.y * up,
                                    direction.dx, direction.dy);
    }
    return light;
#else
    return textureGrad(picture, direction.at, direction.dx, direction.dy);
#endif
}
#else
// Its coverage is the part of the pixel inside of the picture's rim.
float picture_place(Varying direction, out Place place)
{
#if SOURCE == SOURCE_DOMEMASTER
    return domemaster_place(direction, vec2(textureSize(picture, 0)), place);
#else
    place = equirectangular_place(direction);
    return 1.0;
#endif
}

Jacobian picture_jacobian(Varying direction)
{
    Place place;
    picture_place(direction, place);
    vec2 size = vec2(textureSize(picture, 0));
    return Jacobian(mat2(size * place.dx, size * place.dy), 1.0);
}

vec4 direction_light(Varying direction)
{
    Place place;
    picture_place(direction, place);
#if TEXELS == 9
    vec2 half_texel = 0.5 / vec2(textureSize(picture, 0));
    vec4 light = vec4(0.0);
    for (int i = 0; i < 4; i++) {
        vec2 apart = half_texel * (2.0 * vec2(i & 1, i >> 1) - 1.0);
        light += 0.25 * textureGrad(picture, place.at + apart, place.dx, place.dy);
    }
    return light;
#else
    return textureGrad(picture, place.at, place.dx, place.dy);
#endif
}
#endif

#if RAYS
vec3 part_dx, part_dy; // changes of the direction over what a ray stands for

// Of a ray of the viewer's, dome frame.
vec4 ray_light(vec3 ray)
{
    return direction_light(
        Varying(source_rotation * (ray + eye - source_center), part_dx, part_dy));
}

vec4 pixel_light(vec2 pixel, Varying point, Varying direction)
{
    Jacobian jacobian = picture_jacobian(direction);
    mat2 part = ray_part(jacobian);
    Varying ray = Varying(point.at - eye, point.dx, point.dy);
    part_dx = part[0].x * direction.dx + part[0].y * direction.dy;
    part_dy = part[1].x * direction.dx + part[1].y * direction.dy;
    return rays_light(ray, ray, jacobian, pixel, circle_place(pixel).xy);
}
#endif

void main()
{
    vec2 pixel = gl_FragCoord.xy - target_corner;
    Varying point = screen_point(lens_ray(circle_place(pixel)));
    float coverage = pixel_coverage(pixel, point);
    Varying inside = point_inside_rim(pixel, point);
    vec2 from = pixel;
#if JITTERS
    from = jittered_place(pixel, point);
    point = screen_point(lens_ray(circle_place(from)));
#endif
    point = Varying(point.at, inside.dx, inside.dy);
    Varying direction = source_direction(point);
#if SOURCE == SOURCE_DOMEMASTER
    Place place;
    coverage = min(coverage, picture_place(direction, place));
#endif
#if RAYS
    vec4 light = pixel_light(from, point, direction);
#else
    vec4 light = direction_light(direction);
#endif
    if (coverage > 0.0)
        light = mix(border, light, coverage);
    else
        light = border;
    color = pixel_color(light, pixel);
}
