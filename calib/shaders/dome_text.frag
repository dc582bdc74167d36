#version 330 core
// Text on the dome: from an output pixel to the eye's direction, from there to the plane that faces
// the eye and carries the text.

uniform sampler2D points;
uniform sampler2D text;   // coverage by letters, first row at the bottom
uniform mat3 axes;        // dome frame to right, up, forward of the text
uniform vec3 eye_m;
uniform vec4 place;       // of the text's lower left corner and its size, on the plane at 1
uniform vec3 ink;
uniform float ground;     // how much of what is behind is kept away

out vec4 color;

void main()
{
    vec4 point = texelFetch(points, ivec2(gl_FragCoord.xy), 0);
    vec3 ray = axes * (point.xyz - eye_m);
    vec2 at = (ray.xy / ray.z - place.xy) / place.zw;
    vec2 dx = dFdx(at), dy = dFdy(at);
    // Text is never so wide; further off the derivatives of `at` say nothing.
    if (ray.z < 0.3 * length(ray) || point.w <= 0.0)
        discard;
    vec2 per_pixel = max(vec2(length(vec2(dx.x, dy.x)), length(vec2(dx.y, dy.y))), 1e-6);
    vec2 edge = clamp(0.5 + min(at, 1.0 - at) / per_pixel, 0.0, 1.0);
    float inside = edge.x * edge.y;
    if (inside <= 0.0)
        discard;
    // Never blurred by more than the smaller side of the pixel's footprint.
    float shrink = min(1.0, length(dx) < length(dy) ? length(dx) / length(dy)
                                                    : length(dy) / length(dx));
    vec2 gx = length(dx) > length(dy) ? dx * shrink : dx;
    vec2 gy = length(dy) > length(dx) ? dy * shrink : dy;
    float letter = textureGrad(text, at, gx, gy).r * inside;
    color = vec4(ink * letter * point.w, letter + (1.0 - letter) * ground * inside);
}
