// A corner of what no pixel samples, at the nearest depth.

layout(location = 0) in vec2 texel; // of the atlas

uniform vec4 area;     // that the viewport shows: corner and size, texels of the atlas
uniform float nearest; // clip depth: -1 or, reversed, 1

void main()
{
    gl_Position = vec4(2.0 * (texel - area.xy) / area.zw - 1.0, nearest, 1.0);
}
