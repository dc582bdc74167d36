// A room from -1 to 1 m round the host's camera: a colour for each face, squares and a round mark
// in each face's middle with a notch towards its first axis. Edges are some texels wide, so that
// golden pictures do not hang on where the texels lie.

uniform mat3 ray_of_place;
uniform vec3 eye; // m

in vec2 place;
out vec4 color;

// 0 below an edge and 1 above it.
float edge(float distance, float width)
{
    return smoothstep(-width, width, distance);
}

vec3 face_color(int axis, bool positive)
{
    vec3 base = vec3(axis == 0, axis == 1, axis == 2);
    return positive ? 0.25 + 0.65 * base : 0.85 - 0.65 * base;
}

void main()
{
    vec3 ray = ray_of_place * vec3(place, 1.0);
    vec3 from = clamp(eye, -0.95, 0.95);
    vec3 ways = (sign(ray) - from) / ray;
    int axis = ways.x < ways.y ? (ways.x < ways.z ? 0 : 2) : (ways.y < ways.z ? 1 : 2);
    vec3 hit = from + ways[axis] * ray;
    vec2 on_face = vec2(hit[(axis + 1) % 3], hit[(axis + 2) % 3]);
    float width = 0.03;

    vec2 wave = sin(on_face * 12.566371); // squares of a quarter
    float squares = edge(wave.x * wave.y, 0.3);
    vec3 shown = face_color(axis, ray[axis] > 0.0) * (0.6 + 0.4 * squares);
    float mark = edge(0.2 - length(on_face), width);
    float notch = edge(on_face.x, width) * edge(0.05 - abs(on_face.y), width);
    shown = mix(shown, vec3(1.0), mark * (1.0 - notch));
    float frame = edge(max(abs(on_face.x), abs(on_face.y)) - 0.94, width);
    color = vec4(mix(shown, vec3(0.05), frame), 1.0);
}
