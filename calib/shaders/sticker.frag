#version 330 core
// A sticker on the simulated screen: a ring round a place, in pixels of the frame.

uniform vec2 place_px;
uniform float radius_px;
uniform vec3 ink;

out vec4 color;

void main()
{
    float off = length(gl_FragCoord.xy - place_px);
    float ring = clamp(1.5 - abs(off - radius_px), 0.0, 1.0);
    float dot = clamp(1.5 - off, 0.0, 1.0);
    float alpha = max(ring, dot);
    color = vec4(alpha * ink, alpha);
}
