// The simulated theatre, by casting a ray per pixel: the light of one output on the screen, and
// with `furniture` the screen's outside, the projectors and the viewer. Outputs after the first are
// added.

uniform vec2 target_corner;  // px
uniform vec2 target_size;    // px
uniform vec2 half_opening;   // tangents of half of the opening, across and up
uniform vec3 spectator;      // m, dome frame
uniform mat3 spectator_axes; // columns: right, up, back
uniform vec3 ambient;
uniform bool furniture;
uniform bool first_output;
uniform sampler2D image;
uniform int projector_count;
uniform vec3 projector_positions[OUTPUTS_MAX];
uniform vec3 projector_axes[OUTPUTS_MAX];
uniform vec3 gaze; // the viewer's forward, dome frame

out vec4 color;

const float FAR = 1e9;

bool on_screen(vec3 point)
{
    return -point.z / screen_radius >= cap_cosine;
}

vec3 projected_light(vec3 point)
{
    vec3 place = lens_pixel(point - projector_position);
    if (place.z > 1.0 || any(lessThan(place.xy, vec2(0.0))) ||
        any(greaterThan(place.xy, output_size)))
        return vec3(0.0);
    return textureLod(image, place.xy / output_size, 0.0).rgb;
}

// The first place of a ray on a sphere, as a distance; FAR if there is none.
float meet_sphere(vec3 from, vec3 along, vec3 center, float radius)
{
    vec3 offset = from - center;
    float middle = -dot(offset, along);
    float square = middle * middle - dot(offset, offset) + radius * radius;
    if (square < 0.0 || middle - sqrt(square) < 0.0)
        return FAR;
    return middle - sqrt(square);
}

// The first place of a ray on a straight rod, open at both ends.
float meet_rod(vec3 from, vec3 along, vec3 foot, vec3 axis, float rod_length, float radius)
{
    vec3 offset = from - foot;
    vec3 across = along - axis * dot(along, axis);
    vec3 aside = offset - axis * dot(offset, axis);
    float a = dot(across, across), b = dot(across, aside);
    float square = b * b - a * (dot(aside, aside) - radius * radius);
    if (a < 1e-9 || square < 0.0)
        return FAR;
    float t = (-b - sqrt(square)) / a;
    float height = dot(offset + t * along, axis);
    return t > 0.0 && height >= 0.0 && height <= rod_length ? t : FAR;
}

// Takes what lies nearer: distance in w, shaded colour in xyz.
void place_body(inout vec4 nearest, float t, vec3 normal, vec3 along, vec3 body_color)
{
    if (t < nearest.w)
        nearest = vec4(body_color * (0.12 + 0.88 * abs(dot(normal, along))), t);
}

void place_ball(inout vec4 nearest, vec3 from, vec3 along, vec3 center, float radius,
                vec3 ball_color)
{
    float t = meet_sphere(from, along, center, radius);
    if (t < FAR)
        place_body(nearest, t, (from + t * along - center) / radius, along, ball_color);
}

// Viewer and projectors.
vec4 nearest_body(vec3 from, vec3 along)
{
    float head = 0.06 * screen_radius;
    vec4 nearest = vec4(0.0, 0.0, 0.0, FAR);
    place_ball(nearest, from, along, eye, head, vec3(0.89, 0.38, 0.073));
    place_ball(nearest, from, along, eye + 1.1 * head * gaze, 0.35 * head, vec3(0.69, 0.10, 0.033));
    for (int i = 0; i < projector_count; i++) {
        // The body stands behind the lens, and is seen where lens and viewer are in one place.
        vec3 foot = projector_positions[i], axis = -projector_axes[i];
        float rod = 0.22 * screen_radius, radius = 0.03 * screen_radius;
        vec3 rod_color = vec3(0.10, 0.38, 0.89);
        place_ball(nearest, from, along, foot, 1.4 * radius, rod_color);
        place_ball(nearest, from, along, foot + rod * axis, radius, rod_color);
        float t = meet_rod(from, along, foot, axis, rod, radius);
        if (t < FAR) {
            vec3 aside = from + t * along - foot;
            place_body(nearest, t, (aside - axis * dot(aside, axis)) / radius, along, rod_color);
        }
    }
    return nearest;
}

// Lines of the screen's outside: the rim of the cap and a meridian every 30 degrees.
float shell_opacity(vec3 point)
{
    vec3 unit = point / screen_radius;
    float across = length(unit.xy);
    float meridian = atan(unit.y, unit.x) * (6.0 / 3.14159265);
    float off_meridian = abs(meridian - round(meridian)) * across / 6.0 * 3.14159265;
    float off_rim = abs(-unit.z - cap_cosine) / max(across, 0.05);
    bool line = off_meridian < 0.006 || (cap_cosine >= -1.0 && off_rim < 0.012);
    return line ? 0.5 : 0.05;
}

// What the spectator sees at a place of the picture, px.
vec3 seen_light(vec2 pixel)
{
    vec2 place = 2.0 * pixel / target_size - 1.0;
    vec3 along = normalize(spectator_axes * vec3(place * half_opening, -1.0));
    float middle = -dot(spectator, along);
    float square = middle * middle - dot(spectator, spectator) + screen_radius * screen_radius;
    vec4 body = furniture ? nearest_body(spectator, along) : vec4(0.0, 0.0, 0.0, FAR);
    vec3 light = first_output && furniture ? vec3(0.0035, 0.0039, 0.0049) : vec3(0.0);
    float exit = square >= 0.0 ? middle + sqrt(square) : -1.0;
    float entry = square >= 0.0 ? middle - sqrt(square) : -1.0;

    if (exit > 0.0 && on_screen(spectator + exit * along)) {
        light = projected_light(spectator + exit * along);
        if (first_output)
            light += ambient;
    }
    if (body.w < FAR && (exit <= 0.0 || body.w < exit))
        light = first_output ? body.xyz : vec3(0.0);
    if (furniture && entry > 0.0 && on_screen(spectator + entry * along)) {
        float opacity = shell_opacity(spectator + entry * along);
        light = mix(light, first_output ? vec3(0.147, 0.171, 0.214) : vec3(0.0), opacity);
    }
    return light;
}

void main()
{
    vec2 pixel = gl_FragCoord.xy - target_corner;
    vec3 light = vec3(0.0);
    if (furniture) { // its edges are sharp: four places of each pixel
        for (int i = 0; i < 4; i++)
            light += 0.25 * seen_light(pixel + 0.5 * vec2(i & 1, i >> 1) - 0.25);
    } else {
        light = seen_light(pixel);
    }
    color = pixel_color(vec4(light, 1.0), pixel);
}
