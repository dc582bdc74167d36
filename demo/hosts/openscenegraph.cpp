/*
 * A host with an engine that owns the frame: OpenSceneGraph's viewer draws its scene once per view
 * of Cupola's. Nothing in the scene knows of it; the master camera stays the one that the program
 * moves, and every view is a slave of it.
 *
 * Which OpenGL: Debian's OSG 3.6 is built for OpenGL 2 with the fixed pipeline (glMatrixMode,
 * glLight, glBegin), and a core profile has none of it. Cupola needs 3.3. A compatibility profile
 * of 3.3 or newer has both: asked for in the traits below, and what Mesa and NVIDIA give to a
 * program that asks for nothing. Where a driver's compatibility profile ends at 2.1 (macOS),
 * cupola_gl_create says so, and OSG has to be built with OPENGL_PROFILE=GL3.
 *
 *     cupola-host-openscenegraph [FRAMES]
 */
#include <cstdlib>
#include <iostream>

#include <osg/Geode>
#include <osg/Material>
#include <osg/ShapeDrawable>
#include <osgViewer/Viewer>

#include <cupola/cupola.h>

namespace
{

/* What the callbacks share. OSG calls them on the thread that draws, its context current. */
struct dome_host : osg::Referenced {
    cupola_rig rig = {};
    cupola_plan *plan = nullptr;
    cupola_gl *gl = nullptr;
    cupola_error error = {};
    bool right = false; /* the last image showed the scene */
};

/* The background is in linear light. */
const cupola_frame frame = {{0.1, 100.0, false, false, false}, {0.004f, 0.004f, 0.01f, 1.0f}};

/* The scene's colours are those of the screen: mixed in linear light, and encoded again. */
cupola_gl_params screen_colors()
{
    cupola_gl_params params = {};
    params.format = CUPOLA_FORMAT_SRGB8;
    params.encoding = CUPOLA_ENCODING_SRGB;
    return params;
}

const cupola_gl_params gl_params = screen_colors();

/* Before OSG draws a view: binds the view's framebuffer and clears it. */
struct view_begin : osg::Camera::DrawCallback {
    view_begin(dome_host *host, int index) : host(host), index(index)
    {
    }
    void operator()(osg::RenderInfo &) const override
    {
        if (!host->gl && cupola_gl_create(host->plan, &gl_params, &host->gl, &host->error) < 0)
            return;
        if (index == 0)
            cupola_gl_frame_begin(host->gl, &frame, &host->error);
        cupola_gl_view_begin(host->gl, index, nullptr, &host->error);
    }
    osg::ref_ptr<dome_host> host;
    int index;
};

/*
 * After it. OSG remembers the state that it set and view_end puts back what was there before the
 * view (framebuffer, viewport, scissor test): OSG is told to set its own again.
 */
struct view_end : osg::Camera::DrawCallback {
    explicit view_end(dome_host *host) : host(host)
    {
    }
    void operator()(osg::RenderInfo &info) const override
    {
        cupola_gl_view_end(host->gl, &host->error);
        info.getState()->dirtyAllModes();
        info.getState()->dirtyAllAttributes();
    }
    osg::ref_ptr<dome_host> host;
};

/* After all views: the warp into the window, whose state OSG finds as it left it. */
struct warp : osg::Camera::DrawCallback {
    explicit warp(dome_host *host) : host(host)
    {
    }
    void operator()(osg::RenderInfo &) const override
    {
        const cupola_output &output = host->rig.outputs[0];
        cupola_target middle = {0, output.width_px / 2, output.height_px / 2};
        float rgba[4];
        host->right = cupola_gl_warp(host->gl, 0, nullptr, nullptr, &host->error) >= 0 &&
                      cupola_gl_capture(&middle, 1, 1, rgba, &host->error) >= 0 && rgba[0] > 0.4f &&
                      rgba[1] < 0.3f && rgba[2] < 0.3f;
    }
    osg::ref_ptr<dome_host> host;
};

osg::ref_ptr<osg::Node> make_scene()
{
    osg::ref_ptr<osg::Geode> scene = new osg::Geode;
    for (int i = 0; i < 16; i++) {
        const float angle = 0.3927f * i;
        osg::ref_ptr<osg::ShapeDrawable> shape = new osg::ShapeDrawable(new osg::Box(
            osg::Vec3(3 * sinf(angle), 0.6f * sinf(3 * angle), -3 * cosf(angle)), 0.5f));
        shape->setColor(osg::Vec4(0.5f + 0.5f * cosf(angle), 0.5f + 0.5f * cosf(angle + 2.1f),
                                  0.5f + 0.5f * cosf(angle + 4.2f), 1));
        scene->addDrawable(shape);
    }
    return scene;
}

osg::ref_ptr<osg::GraphicsContext> make_window(const cupola_output &output)
{
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    traits->readDISPLAY();
    traits->setUndefinedScreenDetailsToDefaultScreen();
    traits->windowName = "cupola-host-openscenegraph";
    traits->width = output.width_px;
    traits->height = output.height_px;
    traits->windowDecoration = true;
    traits->doubleBuffer = true;
    traits->glContextVersion = "3.3";
    traits->glContextProfileMask = 0x2; /* compatibility */
    return osg::GraphicsContext::createGraphicsContext(traits.get());
}

/*
 * One camera per view. Its matrices come from the plan, without any GL, in OSG's terms an offset
 * from the master camera: OSG multiplies row vectors from the left, which in memory is GL's order.
 */
void add_view(osgViewer::Viewer &viewer, osg::GraphicsContext *window, dome_host *host, int index)
{
    const cupola_rect &rect = cupola_plan_view(host->plan, index)->rect;
    cupola_camera matrices;
    cupola_plan_camera(host->plan, index, &frame.depth, &matrices, nullptr);

    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setGraphicsContext(window);
    camera->setViewport(rect.x, rect.y, rect.width, rect.height);
    camera->setRenderOrder(osg::Camera::PRE_RENDER, index);
    camera->setClearMask(0); /* view_begin has cleared it */
    /* Else OSG fits near and far to the scene, per view, and the matrices are no longer ours. */
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setPreDrawCallback(new view_begin(host, index));
    camera->setPostDrawCallback(new view_end(host));
    viewer.addSlave(camera.get(), osg::Matrix(matrices.projection), osg::Matrix(matrices.view));
}

void add_warp(osgViewer::Viewer &viewer, osg::GraphicsContext *window, dome_host *host)
{
    const cupola_output &output = host->rig.outputs[0];
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setGraphicsContext(window);
    camera->setViewport(0, 0, output.width_px, output.height_px);
    camera->setRenderOrder(osg::Camera::POST_RENDER);
    camera->setClearMask(0);
    camera->setPostDrawCallback(new warp(host));
    viewer.addSlave(camera.get(), false); /* it draws nothing of the scene */
}

} // namespace

int main(int argc, char **argv)
{
    int frames = argc > 1 ? std::atoi(argv[1]) : -1;
    osg::ref_ptr<dome_host> host = new dome_host;
    cupola_dome *dome = nullptr;
    /* OSG's headlight shines in eye space, so that has to be the same in every view. */
    cupola_plan_params params = {};
    params.rotation_in_projection = true;

    if (cupola_rig_preset("visionstation", &host->rig, &host->error) < 0 ||
        cupola_dome_create(&host->rig, &dome, &host->error) < 0 ||
        cupola_plan_create(dome, &params, &host->plan, &host->error) < 0) {
        std::cerr << "cupola-host-openscenegraph: " << host->error.message << '\n';
        return 1;
    }
    cupola_dome_destroy(&dome);

    osg::ref_ptr<osg::GraphicsContext> window = make_window(host->rig.outputs[0]);
    if (!window) {
        std::cerr << "cupola-host-openscenegraph: no window with OpenGL 3.3\n";
        return 1;
    }
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer.getCamera()->setProjectionMatrix(osg::Matrix::identity()); /* the slaves bring theirs */
    viewer.getCamera()->setViewMatrix(osg::Matrix::identity());       /* move this one */
    viewer.setSceneData(make_scene());
    for (int i = 0; i < cupola_plan_view_count(host->plan); i++)
        add_view(viewer, window.get(), host.get(), i);
    add_warp(viewer, window.get(), host.get());
    viewer.realize();
    while (!viewer.done() && frames-- != 0 && host->error.status == CUPOLA_OK)
        viewer.frame();

    if (!host->right)
        std::cerr << "cupola-host-openscenegraph: "
                  << (host->error.status ? host->error.message
                                         : "the dome shows something else than the scene")
                  << '\n';
    window->makeCurrent();
    cupola_gl_destroy(&host->gl);
    window->releaseContext();
    cupola_plan_destroy(&host->plan);
    return host->right ? 0 : 1;
}
