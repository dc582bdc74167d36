/* Any lens: refused in one line, or monotone and finite both ways, each the other's inverse. */
#include "lens_values.h"
#include "target.h"

/* Where the curve is so steep that neighbouring doubles of the angle differ visibly in the radius,
 * the radius must lie between those of the neighbours. */
static void require_inverse(const struct cupola_lens *lens, double radius, double angle)
{
    const double slack = 1e-9, near = 1e-12;
    double half = cupola_lens_angle(lens, 1);
    double low = cupola_lens_radius(lens, angle - near * half);
    double high = cupola_lens_radius(lens, angle + near * half);
    require(low - slack <= radius && radius <= high + slack);
}

static void require_curve(const struct cupola_lens *lens)
{
    enum { STEPS = 24 };
    const double slack = 1e-9;
    double half = cupola_lens_angle(lens, 1), angle_before = 0, radius_before = 0;
    require(half > 0 && half <= pi + 1e-11);
    require(fabs(cupola_lens_angle(lens, 0)) <= 1e-12 && cupola_lens_radius(lens, 0) == 0);
    require(fabs(cupola_lens_radius(lens, half) - 1) <= slack);
    require(isnan(cupola_lens_angle(lens, nan(""))) && isnan(cupola_lens_radius(lens, nan(""))));
    for (int i = 1; i <= STEPS; i++) {
        double radius = (double)i / STEPS, angle = cupola_lens_angle(lens, radius);
        require(isfinite(angle) && angle <= half && angle >= angle_before - slack * half);
        require_inverse(lens, radius, angle);
        angle_before = angle;
        double curve = cupola_lens_radius(lens, half * radius);
        require(isfinite(curve) && curve <= 1 + slack && curve >= radius_before - slack);
        radius_before = curve;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct values values = {data, size};
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_lens lens = take_lens(&values);
    int status = cupola_lens_validate(&lens, &error);
    if (status == CUPOLA_OK) {
        require(error.status == CUPOLA_OK);
        require_curve(&lens);
    } else {
        require_message(&error, status);
        require(isnan(cupola_lens_angle(&lens, 0.5)) && isnan(cupola_lens_radius(&lens, 0.5)));
    }
    return 0;
}
