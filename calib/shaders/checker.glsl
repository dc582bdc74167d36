// Fields of equal solid angle: 12 x 12 on half of the sphere. The equal-area disc of the directions
// (Lambert) becomes a square in which areas are what they were: P. Shirley and K. Chiu, A low
// distortion map between disk and square, 1997.

const float FIELDS = 6.0; // from the middle to 90 degrees off it

vec2 square(vec3 v)
{
    float sine2 = dot(v.xy, v.xy);
    float radius = sqrt(v.z < 0.0 ? sine2 / (1.0 - v.z) : 1.0 + v.z);
    vec2 side = abs(v.xy);
    if (!(max(side.x, side.y) > 0.0))
        return vec2(0.0);
    if (side.x >= side.y)
        return radius * sign(v.x) * vec2(1.0, atan(v.y / v.x) * 4.0 / PI);
    return radius * sign(v.y) * vec2(atan(v.x / v.y) * 4.0 / PI, 1.0);
}

// -1 or 1 by the field, between them along its edge.
float wave(float at, float per_pixel)
{
    float edge = floor(at + 0.5);
    float side = mod(edge, 2.0) < 0.5 ? 1.0 : -1.0;
    return side * clamp(2.0 * (at - edge) / max(per_pixel, 1e-6), -1.0, 1.0);
}

vec3 light(Direction d, vec2 pixel)
{
    vec2 at = FIELDS * square(d.at);
    vec2 dx = FIELDS * (square(d.at + d.dx) - square(d.at - d.dx)) / 2.0;
    vec2 dy = FIELDS * (square(d.at + d.dy) - square(d.at - d.dy)) / 2.0;
    float both = wave(at.x, length(vec2(dx.x, dy.x))) * wave(at.y, length(vec2(dx.y, dy.y)));
    return vec3(0.02 + 0.73 * (0.5 + 0.5 * both));
}
