// A vector that depends on a place in the image, and its derivatives per pixel.
struct Varying {
    vec3 at;
    vec3 dx;
    vec3 dy;
};

// Texels per pixel, times a unit: columns for x and y. To divide costs more than to carry the unit
// along.
struct Jacobian {
    mat2 change;
    float unit;
};

// `hit` is homogeneous: the first two by the third are a place, in units of so many texels.
Jacobian hit_jacobian(Varying hit, vec2 texels)
{
    vec2 scale = hit.at.z * texels, place = texels * hit.at.xy;
    mat2 change =
        mat2(scale * hit.dx.xy - place * hit.dx.z, scale * hit.dy.xy - place * hit.dy.z);
    return Jacobian(change, hit.at.z * hit.at.z);
}
