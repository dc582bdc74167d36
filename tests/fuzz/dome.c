/* Any rig: refused in one line, or a dome whose every answer is a number. */
#include "cupola/dome.h"
#include "rig_values.h"
#include "target.h"

static void require_ray(const cupola_dome *dome, int output, double x_px, double y_px)
{
    struct cupola_ray ray;
    double radius_m = cupola_dome_rig(dome)->screen.radius_m, pixel_px[2] = {nan(""), nan("")};
    int lit = cupola_dome_ray(dome, output, NULL, x_px, y_px, &ray);
    require(lit == 0 || lit == 1);
    require(lit == (ray.coverage > 0) && ray.coverage >= 0 && ray.coverage <= 1);
    require(is_finite3(ray.point_m) && is_unit(ray.lens_direction) && is_unit(ray.direction));
    double off_m = sqrt(ray.point_m[0] * ray.point_m[0] + ray.point_m[1] * ray.point_m[1] +
                        ray.point_m[2] * ray.point_m[2]);
    require(fabs(off_m - radius_m) <= 1e-9 * radius_m);
    require(isfinite(ray.distance_m) && ray.distance_m > 0);
    require(!isnan(ray.solid_angle_sr) && ray.solid_angle_sr >= 0);
    int found = cupola_dome_pixel(dome, output, NULL, ray.direction, pixel_px);
    require(found == 0 || found == 1);
    require(found == !isnan(pixel_px[0]) && found == !isnan(pixel_px[1]));
}

static void require_dome(const cupola_dome *dome, struct values *values)
{
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    for (int output = 0; output < rig->output_count; output++) {
        double width = rig->outputs[output].width_px, height = rig->outputs[output].height_px;
        require_ray(dome, output, 0.5, 0.5);
        require_ray(dome, output, width / 2, height / 2);
        for (int i = 0; i < 4; i++) {
            double x = take_double(values, width), y = take_double(values, height);
            if (isfinite(x) && isfinite(y))
                require_ray(dome, output, x, y);
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    enum { SIDE_MAX_PX = 33000 };
    struct values values = {data, size};
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_rig rig = take_rig(&values, SIDE_MAX_PX);
    cupola_dome *dome = NULL;
    int status = cupola_dome_create(&rig, &dome, &error);
    if (status != CUPOLA_OK) {
        require_message(&error, status);
        require(dome == NULL);
        return 0;
    }
    require(error.status == CUPOLA_OK);
    require_dome(dome, &values);
    cupola_dome_destroy(&dome);
    return 0;
}
