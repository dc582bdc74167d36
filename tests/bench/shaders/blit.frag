#version 330 core
// One bilinear sample of a picture: the plainest pass there is.

in vec2 at;
out vec4 color;

uniform sampler2D picture;

void main()
{
    color = texture(picture, at);
}
