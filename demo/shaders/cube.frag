// The walls of the cube room: their pictures in its light.

in vec3 wall_place;
in vec3 wall_texcoord;
flat in vec3 wall_inward;
out vec4 color;

uniform sampler2DArray pictures;
uniform vec3 eye;

void main()
{
    vec3 picture = texture(pictures, wall_texcoord).rgb;
    color = vec4(shaded(picture, wall_place, wall_inward, eye), 1.0);
}
