#version 330 core
// What lies behind a lit model: a sky, and a ground under the model's lowest point with its shadow.

in vec3 ray; // world
out vec4 color;

uniform vec3 eye;
uniform vec3 sun;
uniform vec3 center;      // of the model
uniform vec3 half_size;   // of the box round it
uniform float grid_step;  // of the lines on the ground, world units

const vec3 horizon = vec3(0.93, 0.90, 0.85);
const vec3 zenith = vec3(0.22, 0.43, 0.68);
const vec3 ground = vec3(0.50, 0.47, 0.42);

vec3 sky(vec3 direction)
{
    vec3 tone = mix(horizon, zenith, pow(clamp(direction.y, 0.0, 1.0), 0.6));
    float glow = max(dot(direction, sun), 0.0);
    return tone + vec3(0.30, 0.24, 0.12) * pow(glow, 24.0);
}

// Lines of constant width on the ground, which fade before they get finer than two pixels.
float grid(vec2 place, vec2 footprint)
{
    vec2 cell = place / grid_step;
    vec2 blur = max(footprint / grid_step, vec2(1e-4));
    vec2 line = abs(fract(cell - 0.5) - 0.5);
    vec2 cover = 1.0 - smoothstep(vec2(0.0), blur + 0.02, line);
    cover *= clamp(0.5 / blur - 1.0, 0.0, 1.0);
    return max(cover.x, cover.y);
}

void main()
{
    vec3 direction = normalize(ray);
    float height = eye.y - (center.y - half_size.y);
    float down = max(-direction.y, 1e-4);
    vec2 place = eye.xz + direction.xz * (max(height, 0.0) / down);
    vec2 footprint = fwidth(place);
    if (direction.y >= 0.0) {
        color = vec4(sky(direction), 1.0);
        return;
    }
    float scale = length(half_size);
    float far_off = length(place - center.xz) / scale;
    vec3 tone = ground;
    if (height > 0.0) {
        vec2 shadow = (place - center.xz + sun.xz / sun.y * half_size.y * 0.3) /
                      (half_size.xz + 0.2 * half_size.y + 1e-6 * scale);
        tone *= 1.0 - 0.45 * exp(-1.5 * dot(shadow, shadow));
        tone = mix(tone, vec3(0.66, 0.63, 0.57), 0.55 * grid(place, footprint));
        tone = mix(horizon, tone, exp(-0.045 * far_off));
    } else {
        tone = mix(horizon, ground, pow(down, 0.4));
    }
    color = vec4(tone, 1.0);
}
