#version 330 core
// The mean of many rays through a pixel, spread evenly over it.

out vec4 color;

uniform samplerCube faces;
uniform sampler2D directions; // w: whether the pixel counts
uniform sampler2D along_x;    // change of the direction per pixel
uniform sampler2D along_y;

const int RAYS = 6; // along a side

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 middle = texelFetch(directions, pixel, 0);
    vec3 dx = texelFetch(along_x, pixel, 0).xyz, dy = texelFetch(along_y, pixel, 0).xyz;
    vec3 sum = vec3(0.0);
    for (int j = 0; j < RAYS; j++)
        for (int i = 0; i < RAYS; i++) {
            vec2 place = (vec2(i, j) + 0.5) / float(RAYS) - 0.5;
            sum += texture(faces, middle.xyz + place.x * dx + place.y * dy).rgb;
        }
    color = vec4(sum / float(RAYS * RAYS), middle.w);
}
