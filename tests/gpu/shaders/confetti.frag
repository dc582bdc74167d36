in vec3 shade;
flat in int kind;
out vec4 color;

void main()
{
    color = vec4(shade * (0.4 + 0.15 * float(kind)), 1.0);
}
