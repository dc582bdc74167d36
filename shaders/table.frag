// Makes the table of a stage: per output pixel, what the warp would otherwise compute.
//
//   angles       the ray's two angles, its coverage
//   sines        sine and cosine of the first angle, both times the coverage; those of the second
//   points       the point of the screen, its coverage
//   coordinates  where the ray meets the atlas, its coverage

out vec4 entry;

void main()
{
    vec2 pixel = gl_FragCoord.xy;
    Varying point = screen_point(lens_ray(circle_place(pixel)));
    float coverage = pixel_coverage(pixel, point);
    vec3 ray = eye_ray(point.at);
    float across = length(ray.xy);
#if STAGE == STAGE_ANGLES
    float azimuth = across > 0.0 ? atan(ray.y, ray.x) : 0.0;
    entry = vec4(atan(across, -ray.z), azimuth, coverage, 0.0);
#elif STAGE == STAGE_SINES
    vec2 azimuth = across > 0.0 ? ray.yx / across : vec2(0.0, 1.0);
    entry = vec4(coverage * vec2(across, -ray.z) / length(ray), azimuth);
#elif STAGE == STAGE_COORDINATES
    entry = vec4(atlas_place(ray), coverage, 0.0);
#else
    entry = vec4(point.at, coverage);
#endif
}
