// Points of the host's camera frame, by the two matrices that a view comes with.

layout(location = 0) in vec3 point;
uniform mat4 projection, view;

void main()
{
    gl_Position = projection * (view * vec4(point, 1.0));
}
