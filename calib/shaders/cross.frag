#version 330 core
// The cross-hair, in image pixels: arms with a gap in the middle, dark on both sides.

uniform sampler2D points; // its fourth number is the coverage
uniform vec2 cross_px;
uniform float arm_px;

out vec4 color;

float bar(vec2 off, float wide)
{
    off = abs(off);
    float across = clamp(0.5 + 0.5 * wide - off.y, 0.0, 1.0);
    return across * clamp(arm_px + 0.5 - off.x, 0.0, 1.0) *
           clamp(off.x - 0.12 * arm_px + 0.5, 0.0, 1.0);
}

void main()
{
    vec2 off = gl_FragCoord.xy - cross_px;
    float coverage = texelFetch(points, ivec2(gl_FragCoord.xy), 0).w;
    float white = max(bar(off, 1.4), bar(off.yx, 1.4));
    float dark = max(bar(off, 4.0), bar(off.yx, 4.0));
    float point = clamp(1.2 - length(off), 0.0, 1.0);
    float alpha = max(dark, point);
    color = vec4(coverage * max(white, point) * vec3(1.0, 0.75, 0.1), alpha);
}
