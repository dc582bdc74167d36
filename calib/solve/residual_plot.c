/*
 * Residuals over the dome as a picture: the dome seen along its axis, equal angles from it equally
 * far (azimuthal equidistant), the viewer's right at the right. From each mark an arrow leads
 * towards the place that its pixel lights in the solved rig, longer than it is by a factor that
 * the picture states.
 */
#include "residual_plot.h"

#include <cairo.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/dome.h>

#include "angles.h"
#include "option_values.h"
#include "order.h"
#include "short_path.h"
#include "solve/lit_place.h"
#include "solve/plot_text.h"

enum { SIZE = 1000, LEGEND = 110, MARGIN = 40, WAYS = 720, NAMES_MAX = 30 };

struct plot {
    cairo_t *cairo;
    const struct solve_request *request;
    const struct solve_result *result;
    cupola_dome *dome;
    double outline[WAYS + 1][3]; /* points of the screen round what the projector lights */
    double reach_rad;            /* angle at the edge */
    double factor;               /* of the arrows */
};

/* Where a direction of the dome frame is in the picture. */
static void place(const struct plot *plot, const double d[3], double at[2])
{
    double across = hypot(d[0], d[1]);
    double r = (0.5 * SIZE - MARGIN) * atan2(across, -d[2]) / plot->reach_rad;

    at[0] = 0.5 * SIZE + (across > 0 ? r * d[0] / across : 0);
    at[1] = 0.5 * SIZE - (across > 0 ? r * d[1] / across : 0);
}

static double px_per_rad(const struct plot *plot)
{
    return (0.5 * SIZE - MARGIN) / plot->reach_rad;
}

/* From the mark's place to what its pixel lights as far from the centre, not yet longer. */
static void arrow(const struct plot *plot, int index, double from[2], double to[2])
{
    const struct marks *marks = plot->request->marks;
    const struct mark *mark = &marks->list[index];
    double distance_m = plot->result->rig.screen.radius_m, point_m[3];

    if (marks->kind == MARKS_POINTS)
        distance_m = hypot(hypot(mark->place[0], mark->place[1]), mark->place[2]);
    place(plot, mark->place, from);
    lit_place_find(plot->dome, plot->request->output, mark->pixel_px, distance_m, mark->place,
                   point_m);
    place(plot, point_m, to);
}

/* Outwards from the middle of the image, as far as it is lit. */
static void find_outline(struct plot *plot)
{
    enum { HALVINGS = 24 };
    const struct cupola_output *output = &plot->result->rig.outputs[plot->request->output];
    const struct cupola_circle *circle = &output->circle;
    double x = fmin(fmax(circle->center_x_px, 1), output->width_px - 1);
    double y = fmin(fmax(circle->center_y_px, 1), output->height_px - 1);

    for (int k = 0; k <= WAYS; k++) {
        double low = 0, high = 2 * circle->radius_px, c = cos(2 * pi * k / WAYS);
        double s = sin(2 * pi * k / WAYS);
        struct cupola_ray ray = {{0, 0, -1}};
        for (int i = 0; i < HALVINGS; i++) {
            double r = 0.5 * (low + high);
            bool lit = cupola_dome_ray(plot->dome, plot->request->output, NULL, x + r * c,
                                       y + r * s, &ray) == 1;
            *(lit ? &low : &high) = r;
        }
        cupola_dome_ray(plot->dome, plot->request->output, NULL, x + low * c, y + low * s, &ray);
        for (int i = 0; i < 3; i++)
            plot->outline[k][i] = ray.point_m[i];
    }
}

static double off_axis(const double d[3])
{
    return atan2(hypot(d[0], d[1]), -d[2]);
}

/* As far as marks and light reach. */
static double find_reach(const struct plot *plot)
{
    const struct marks *marks = plot->request->marks;
    double reach = pi / 2;

    for (int i = 0; i < marks->count; i++)
        reach = fmax(reach, off_axis(marks->list[i].place));
    for (int i = 0; i <= WAYS; i++)
        reach = fmax(reach, off_axis(plot->outline[i]));
    return reach;
}

/* The next lower 1, 2 or 5 times a power of ten. */
static double round_down(double wished)
{
    double power = pow(10, floor(log10(wished)));

    return wished / power >= 5 ? 5 * power : wished / power >= 2 ? 2 * power : power;
}

/* A round number, so that half of the arrows are longer than 25 pixels. */
static double find_factor(const struct plot *plot)
{
    int count = plot->request->marks->count, used = 0;
    double *lengths = malloc((size_t)count * sizeof *lengths);

    for (int i = 0; i < count && lengths; i++) {
        double from[2], to[2];
        arrow(plot, i, from, to);
        if (!plot->result->marks[i].rejected)
            lengths[used++] = hypot(to[0] - from[0], to[1] - from[1]);
    }
    double wished = lengths ? 25 / fmax(order_ranked(lengths, used, (used + 1) / 2), 1e-6) : 1;
    free(lengths);
    return fmin(fmax(round_down(wished), 1), 1e6);
}

/* Named as in the tool: latitude, 90 at the dome's axis and 0 where a hemisphere ends. */
static void draw_circles(const struct plot *plot)
{
    cairo_t *cairo = plot->cairo;

    cairo_set_line_width(cairo, 1);
    cairo_set_source_rgb(cairo, 0.8, 0.8, 0.8);
    for (int angle = 30; angle <= plot->reach_rad * deg_per_rad + 0.5; angle += 30) {
        cairo_arc(cairo, 0.5 * SIZE, 0.5 * SIZE, angle / deg_per_rad * px_per_rad(plot), 0, 2 * pi);
        cairo_stroke(cairo);
    }
    for (int k = 0; k < 12; k++) {
        double reach = plot->reach_rad * px_per_rad(plot);
        cairo_move_to(cairo, 0.5 * SIZE, 0.5 * SIZE);
        cairo_rel_line_to(cairo, reach * sin(k * pi / 6), reach * cos(k * pi / 6));
        cairo_stroke(cairo);
    }
    for (int angle = 0; angle <= plot->reach_rad * deg_per_rad + 0.5; angle += 30) {
        char text[16];
        snprintf(text, sizeof text, "%d", 90 - angle);
        plot_text(cairo, text, 0.5 * SIZE + 4,
                  0.5 * SIZE - angle / deg_per_rad * px_per_rad(plot) - 4,
                  (double[3]){0.5, 0.5, 0.5});
    }
}

static void draw_outline(const struct plot *plot)
{
    for (int k = 0; k <= WAYS; k++) {
        double at[2];
        place(plot, plot->outline[k], at);
        cairo_line_to(plot->cairo, at[0], at[1]);
    }
    cairo_set_source_rgb(plot->cairo, 0.2, 0.6, 0.3);
    cairo_set_line_width(plot->cairo, 2);
    cairo_stroke(plot->cairo);
}

static void draw_arrow(cairo_t *cairo, const double from[2], const double to[2])
{
    double angle = atan2(to[1] - from[1], to[0] - from[0]);
    double head = fmin(7, 0.5 * hypot(to[0] - from[0], to[1] - from[1]));

    cairo_move_to(cairo, from[0], from[1]);
    cairo_line_to(cairo, to[0], to[1]);
    for (int side = -1; side <= 1; side += 2) {
        cairo_move_to(cairo, to[0], to[1]);
        cairo_line_to(cairo, to[0] - head * cos(angle + side * 0.45),
                      to[1] - head * sin(angle + side * 0.45));
    }
    cairo_stroke(cairo);
}

static void draw_mark(const struct plot *plot, int index)
{
    bool rejected = plot->result->marks[index].rejected;
    double factor = rejected ? 1 : plot->factor, from[2], to[2];
    static const double good[] = {0.1, 0.2, 0.7}, wrong[] = {0.85, 0.1, 0.1};
    const double *color = rejected ? wrong : good;

    arrow(plot, index, from, to);
    for (int i = 0; i < 2; i++)
        to[i] = from[i] + factor * (to[i] - from[i]);
    cairo_set_source_rgb(plot->cairo, color[0], color[1], color[2]);
    cairo_set_line_width(plot->cairo, 1.5);
    draw_arrow(plot->cairo, from, to);
    cairo_arc(plot->cairo, from[0], from[1], 3.5, 0, 2 * pi);
    cairo_fill(plot->cairo);
    if (rejected && plot->result->rejected <= NAMES_MAX)
        plot_text(plot->cairo, plot->request->marks->list[index].name, from[0] + 7, from[1] - 5,
                  color);
}

/* A length of the arrows in degrees on the dome. */
static void draw_legend(const struct plot *plot)
{
    static const double black[] = {0, 0, 0}, red[] = {0.85, 0.1, 0.1}, green[] = {0.2, 0.6, 0.3};
    double wished = 120 / (px_per_rad(plot) / deg_per_rad * plot->factor);
    double bar = round_down(wished);
    double length = bar * px_per_rad(plot) / deg_per_rad * plot->factor, y = SIZE + 10;
    char text[200];

    cairo_set_source_rgb(plot->cairo, 0.1, 0.2, 0.7);
    cairo_set_line_width(plot->cairo, 3);
    cairo_move_to(plot->cairo, MARGIN, y);
    cairo_rel_line_to(plot->cairo, length, 0);
    cairo_stroke(plot->cairo);
    snprintf(text, sizeof text, "%g degrees on the dome: arrows are %g times as long as residuals",
             bar, plot->factor);
    plot_text(plot->cairo, text, MARGIN + length + 12, y + 7, black);
    snprintf(text, sizeof text, "%d of %d marks: %.3g px rms, %.3g px at worst; circles: latitude",
             plot->request->marks->count - plot->result->rejected, plot->request->marks->count,
             plot->result->rms_px, plot->result->worst_px);
    plot_text(plot->cairo, text, MARGIN, y + 37, black);
    plot_text(plot->cairo, "outline: what the projector lights", MARGIN, y + 62, green);
    if (plot->result->rejected > 0)
        plot_text(plot->cairo, "rejected, with names: arrows as they are", MARGIN + 430, y + 62,
                  red);
}

struct sink {
    FILE *file;
    int problem; /* of errno */
};

static cairo_status_t add_bytes(void *data, const unsigned char *bytes, unsigned size)
{
    struct sink *sink = data;

    errno = 0;
    if (fwrite(bytes, 1, size, sink->file) == size)
        return CAIRO_STATUS_SUCCESS;
    sink->problem = errno ? errno : EIO;
    return CAIRO_STATUS_WRITE_ERROR;
}

static void draw(struct plot *plot)
{
    find_outline(plot);
    plot->reach_rad = find_reach(plot);
    plot->factor = find_factor(plot);
    cairo_set_source_rgb(plot->cairo, 1, 1, 1);
    cairo_paint(plot->cairo);
    draw_circles(plot);
    draw_outline(plot);
    for (int i = 0; i < plot->request->marks->count; i++)
        draw_mark(plot, i);
    draw_legend(plot);
}

/* "--plot: NAME: what: why" */
static bool fail(const char *path, const char *what, const char *why, char *message)
{
    snprintf(message, MESSAGE_SIZE, "--plot: %s: %s: %s", short_path(path).text, what, why);
    return false;
}

bool residual_plot_write(FILE *file, const char *path, const struct solve_request *request,
                         const struct solve_result *result, char *message)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, SIZE, SIZE + LEGEND);
    struct plot plot = {.cairo = cairo_create(surface), .request = request, .result = result};
    struct sink sink = {.file = file};
    struct cupola_error error = {0};
    bool made = cupola_dome_create(&result->rig, &plot.dome, &error) >= 0;

    if (made) {
        draw(&plot);
        cairo_status_t status = cairo_status(plot.cairo);
        if (status == CAIRO_STATUS_SUCCESS)
            status = cairo_surface_write_to_png_stream(surface, add_bytes, &sink);
        made = status == CAIRO_STATUS_SUCCESS;
        if (sink.problem)
            fail(path, "cannot be written", strerror(sink.problem), message);
        else if (!made)
            fail(path, "the picture cannot be made", cairo_status_to_string(status), message);
    } else {
        fail(path, "the picture cannot be made", error.message, message);
    }
    cupola_dome_destroy(&plot.dome);
    cairo_destroy(plot.cairo);
    cairo_surface_destroy(surface);
    return made;
}
