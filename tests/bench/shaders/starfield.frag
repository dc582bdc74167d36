#version 330 core
// Stars and nothing else.

flat in float star_light;
out vec4 color;

void main()
{
    color = vec4(vec3(star_light), 1.0);
}
