// The bits of a table of floats as bytes, lowest first: each texel is four pixels side by side.

uniform sampler2D table;
out vec4 bytes;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    uint bits = floatBitsToUint(texelFetch(table, ivec2(at.x / 4, at.y), 0)[at.x % 4]);
    bytes = vec4(uvec4(bits, bits >> 8u, bits >> 16u, bits >> 24u) & 255u) / 255.0;
}
