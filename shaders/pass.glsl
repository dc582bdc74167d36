// All views in one pass, for a host's vertex shader: cupola/one_pass.h has what is for the host.
// CUPOLA_BY_GEOMETRY: a geometry shader sends each primitive to its viewport.

layout(std140) uniform cupola_pass
{
    mat4 cupola_clip[8]; // from the host's places to each view's clip space
    int cupola_view_count;
};

#ifdef CUPOLA_BY_GEOMETRY
flat out int cupola_vertex_view;
#endif

int cupola_view()
{
    return gl_InstanceID % cupola_view_count;
}

int cupola_instance()
{
    return gl_InstanceID / cupola_view_count;
}

void cupola_send(vec4 clip, int view)
{
    gl_Position = clip;
#ifdef CUPOLA_BY_GEOMETRY
    cupola_vertex_view = view;
#else
    gl_ViewportIndex = view;
#endif
}

void cupola_place(vec4 place, int view)
{
    cupola_send(cupola_clip[view] * place, view);
}
