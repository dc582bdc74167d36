// The density map: per output pixel, the solid angle that it covers, seen by the eye, sr; 0 where
// it is not lit. lib/geometry/density.c says the same under the same names.

out float entry;

// Of a ray of any length and its changes per pixel.
float density_solid_angle(Varying seen)
{
    float square = dot(seen.at, seen.at);
    return abs(dot(seen.at, cross(seen.dx, seen.dy))) / (square * sqrt(square));
}

void main()
{
    vec2 pixel = gl_FragCoord.xy;
    Varying point = screen_point(lens_ray(circle_place(pixel)));
    Varying inside = point_inside_rim(pixel, point);
    // In the dome frame: turned into the camera's, it is the same.
    Varying seen = Varying(inside.at - eye, inside.dx, inside.dy);
    entry = pixel_coverage(pixel, point) > 0.0 ? density_solid_angle(seen) : 0.0;
}
