#version 330 core
// The walls of the cube room: their pictures, and a lamp under the ceiling unless drawn flat.

in vec3 wall_place;
in vec3 wall_texcoord;
flat in vec3 wall_inward;
out vec4 color;

uniform sampler2DArray pictures;
uniform bool lamp;

const vec3 lamp_place = vec3(0.4, 0.5, 0.3);

void main()
{
    vec3 picture = texture(pictures, wall_texcoord).rgb;
    float light = 1.0;
    if (lamp) {
        vec3 to_lamp = lamp_place - wall_place;
        float squared = dot(to_lamp, to_lamp);
        float facing = dot(wall_inward, to_lamp) * inversesqrt(squared);
        light = 0.70 + 0.95 * facing / (1.0 + squared);
    }
    color = vec4(picture * light, 1.0);
}
