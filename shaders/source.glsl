// From points of the screen to places in pictures; lib/geometry/source.c says the same under the
// same names. Here places have derivatives too, for the filter.

uniform mat3 source_rotation;
uniform vec3 source_center;    // m, dome frame
uniform float source_half_fov; // of a domemaster
uniform bool source_mipmaps;   // the filter uses them

// A place in a picture, 0 to 1, and its derivatives per pixel.
struct Place {
    vec2 at;
    vec2 dx;
    vec2 dy;
};

Varying source_direction(Varying point)
{
    return Varying(source_rotation * (point.at - source_center), source_rotation * point.dx,
                   source_rotation * point.dy);
}

// Change of the angle off the picture's axis for a change of the direction.
float angle_change(vec3 at, float across, vec3 change)
{
    float outwards = across > 0.0 ? dot(at.xy, change.xy) / across : length(change.xy);
    return (across * change.z - at.z * outwards) / dot(at, at);
}

vec2 domemaster_change(vec3 at, float across, float angle, vec3 change)
{
    if (across < 1e-4 * length(at))
        return 0.5 / source_half_fov * change.xy / length(at);
    vec2 outwards = at.xy / across, round = vec2(-outwards.y, outwards.x);
    return 0.5 / source_half_fov * (outwards * angle_change(at, across, change) +
                                    round * angle * dot(round, change.xy) / across);
}

// How far inside of the rim, in radii, the filter meets nothing of what lies beyond: 1.5 texels
// of the level that it takes.
float domemaster_inset(Place place, vec2 size)
{
    float footprint = max(length(size * place.dx), length(size * place.dy));
    float texels = source_mipmaps ? 1.5 * max(footprint, 1.0) : 1.5;
    return 2.0 * texels / min(size.x, size.y);
}

// size: of the picture, px. Returns the part of the pixel inside of its rim.
float domemaster_place(Varying direction, vec2 size, out Place place)
{
    vec3 at = direction.at;
    float across = length(at.xy);
    float angle = atan(across, -at.z);
    place.dx = domemaster_change(at, across, angle, direction.dx);
    place.dy = domemaster_change(at, across, angle, direction.dy);
    float r = min(angle / source_half_fov, max(1.0 - domemaster_inset(place, size), 0.0));
    place.at = 0.5 + (across > 0.0 ? 0.5 * r / across : 0.0) * at.xy;
    if (source_half_fov > 3.14159)
        return 1.0;
    vec2 change = vec2(angle_change(at, across, direction.dx),
                       angle_change(at, across, direction.dy));
    return edge_coverage((source_half_fov - angle) / max(length(change), 1e-12), change);
}

// The derivative across is that of the footprint, not of the longitude: a picture of the sphere has
// no finer detail near its poles than elsewhere, and the longitude jumps behind.
Place equirectangular_place(Varying direction)
{
    const vec2 per_rad = vec2(0.159154943, 0.318309886);
    vec3 at = direction.at;
    float level = length(at.xz), far = length(at);
    bool pole = level < 1e-6 * far;
    vec3 east = pole ? vec3(1.0, 0.0, 0.0) : vec3(-at.z, 0.0, at.x) / level;
    vec3 north = cross(east, at) / far;
    vec2 angles = vec2(pole ? 0.0 : atan(at.x, -at.z), atan(at.y, level));
    return Place(0.5 + per_rad * angles,
                 per_rad * vec2(dot(east, direction.dx), dot(north, direction.dx)) / far,
                 per_rad * vec2(dot(east, direction.dy), dot(north, direction.dy)) / far);
}
