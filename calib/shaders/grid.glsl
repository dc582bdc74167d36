// Latitude and longitude every 10 degrees, stronger every 30. About the dome its axis is the pole;
// about the viewer the zenith is, and straight ahead is where 0 meets 0.

uniform bool about_viewer;

vec3 light(Direction d, vec2 pixel)
{
    Polar p;
    if (about_viewer)
        p = polar(upright(d));
    else
        p = polar(d);
    // Towards a pole meridians run together, so most end before.
    float pole = degrees(min(p.off, PI - p.off));
    float thin = max(circles(p, 10.0, 1.2), pole > 20.0 ? meridians(p, 10.0, 1.2) : 0.0);
    float strong = max(circles(p, 30.0, 2.0), pole > 5.0 ? meridians(p, 30.0, 2.0) : 0.0);
    vec3 sum = max(0.16 * thin * vec3(1.0), strong * vec3(0.65, 0.60, 0.30));
    sum = max(sum, meridians(p, 90.0, 2.0) * vec3(0.65, 0.60, 0.30));
    sum = mix(sum, vec3(1.0, 0.06, 0.03), circle(p, 90.0, 2.6));
    return mix(sum, vec3(0.25, 0.75, 1.0), meridian(p, 0.0, 2.6));
}
