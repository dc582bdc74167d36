#version 330 core
// A cube room from -2 to 2, checkered all over, seen from wherever the eye is.

in vec3 ray; // world
out vec4 color;

uniform vec3 eye;
uniform float wide; // of a check

void main()
{
    vec3 along = ray + step(abs(ray), vec3(1e-9)) * 1e-9; // none is 0
    vec3 to_wall = (2.0 * sign(along) - eye) / along;
    float away = min(to_wall.x, min(to_wall.y, to_wall.z));
    vec3 place = eye + away * along;
    vec3 inside = vec3(greaterThan(to_wall, vec3(away)));
    vec3 check = floor((place + 8.0) / wide) * inside;
    bool odd = mod(check.x + check.y + check.z, 2.0) > 0.5;
    vec3 tint = inside.z < 0.5   ? vec3(1.0)
                : inside.y < 0.5 ? vec3(1.0, 0.9, 0.6)
                                 : vec3(0.6, 0.85, 1.0);
    color = vec4(tint * (odd ? 0.95 : 0.05), 1.0);
}
