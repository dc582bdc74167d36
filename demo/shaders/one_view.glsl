// Where vertices go in the one view that is drawn.

#define VIEWS 1

uniform mat4 clip_from_world;

int view_index()
{
    return 0;
}

void place_vertex(vec4 place, int view)
{
    gl_Position = clip_from_world * place;
}

void cover_view(vec4 clip, int view)
{
    gl_Position = clip;
}
