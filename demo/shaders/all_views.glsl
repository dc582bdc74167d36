// Where vertices go when all views are drawn in one pass; behind the text of cupola_pass_glsl.

#define VIEWS 8

int view_index()
{
    return cupola_view();
}

void place_vertex(vec4 place, int view)
{
    cupola_place(place, view);
}

void cover_view(vec4 clip, int view)
{
    cupola_send(clip, view);
}
