// A vector that depends on a place in the image, and its derivatives per pixel.
struct Varying {
    vec3 at;
    vec3 dx;
    vec3 dy;
};

// Texels per pixel: columns for x and y. `hit` is homogeneous: the first two by the third are a
// place, in units of so many texels.
mat2 hit_jacobian(Varying hit, vec2 texels)
{
    float nearness = 1.0 / hit.at.z;
    vec2 place = nearness * hit.at.xy, scale = nearness * texels;
    return mat2(scale * (hit.dx.xy - place * hit.dx.z), scale * (hit.dy.xy - place * hit.dy.z));
}
