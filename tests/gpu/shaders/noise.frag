// Four random numbers per texel of the atlas (integer hash by Wellons' lowbias32 scheme of
// multiplications and shifts): neighbours have nothing in common, so a wrong place shows at once.

out vec4 color;

uint mixed(uint x)
{
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    return x ^ (x >> 16u);
}

void main()
{
    uvec2 texel = uvec2(gl_FragCoord.xy);
    uint number = mixed(texel.x + mixed(texel.y));
    vec4 bytes = vec4(number & 255u, (number >> 8u) & 255u, (number >> 16u) & 255u, number >> 24u);
    color = bytes / 255.0;
}
