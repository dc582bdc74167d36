/*
 * OpenGL ES 3.0 and OpenGL 3.3 make the same images of the same theatres. One process has one API,
 * so a program of its own, WARP_FILES, writes the images of each.
 */
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"
#include "cupola/image_file.h"
#include "warp_files.h"
#include "worse.h"

/* Of directions and of points in radii: 0.006 degrees, and what a sum in another order may do. */
static const double bar = 1e-4;

static char folder[] = "/tmp/cupola-apis-XXXXXX";

static void run_program(const char *setting, const char *api)
{
    char command[8192];

    snprintf(command, sizeof command, "env %s '%s' %s/%s", setting, getenv("WARP_FILES"), folder,
             api);
    int status = system(command);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 77)
        skip();
    assert_int_equal(status, 0);
}

static float *read_image(const char *api, int number)
{
    char path[100];
    float *image = NULL;
    int width, height;

    snprintf(path, sizeof path, "%s/%s-%d.pfm", folder, api, number);
    assert_true(cupola_pfm_read(path, &image, &width, &height, NULL) >= 0);
    assert_int_equal(width, WARP_WIDTH);
    assert_int_equal(height, WARP_HEIGHT);
    assert_int_equal(unlink(path), 0);
    return image;
}

/* Over all pixels but the last column; `shift` is by how many pixels the second image is moved. */
static double difference(const float *a, const float *b, int shift)
{
    double worst = 0;

    for (int i = 0; i < WARP_WIDTH * WARP_HEIGHT; i++)
        for (int c = 0; c < 4 && i % WARP_WIDTH + shift < WARP_WIDTH; c++)
            worst = worse_of(worst, fabs((double)a[4 * i + c] - (double)b[4 * (i + shift) + c]));
    return worst;
}

static double largest(const float *image)
{
    double most = 0;

    for (int i = 0; i < 4 * WARP_WIDTH * WARP_HEIGHT; i++)
        if (i % 4 < 3)
            most = fmax(most, fabs((double)image[i]));
    return most;
}

static void images_are_the_same_in_both(void **state)
{
    double worst = 0;

    (void)state;
    run_program("CUPOLA_TEST_API=gl MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330",
                "gl");
    run_program("CUPOLA_TEST_API=es MESA_GLES_VERSION_OVERRIDE=3.0", "es");
    for (int number = 0; number < WARP_COUNT; number++) {
        float *gl = read_image("gl", number), *es = read_image("es", number);
        check_at_least(largest(gl), 0.5); /* not all black */
        worst = worse_of(worst, difference(gl, es, 0));
        check_at_least(difference(gl, es, 1), 20 * bar); /* the control */
        cupola_image_free(&gl);
        cupola_image_free(&es);
    }
    printf("%d images: at most %.2g apart\n", WARP_COUNT, worst);
    check_at_most(worst, bar);
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    (void)state;
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(images_are_the_same_in_both),
    };
    if (!getenv("WARP_FILES")) {
        fprintf(stderr, "WARP_FILES names no program\n");
        return 1;
    }
    return cmocka_run_group_tests_name("apis_agree", tests, make_folder, remove_folder);
}
