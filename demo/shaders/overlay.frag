#version 330 core
// Text over the picture.

in vec4 letter_color;
out vec4 color;

void main()
{
    color = letter_color;
}
