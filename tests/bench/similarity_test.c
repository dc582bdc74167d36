/* PSNR, SSIM and the worst pixels against numbers by hand and a plain sum over windows. */
#include "similarity.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { SIDE = 24, PIXELS = SIDE * SIDE };

static unsigned char wished[3 * PIXELS], found[3 * PIXELS], counts[PIXELS];
static const struct picture_pair pair = {SIDE, SIDE, wished, found, counts};

static struct similarity compared(void)
{
    struct similarity similarity;

    assert_true(similarity_of(&pair, &similarity));
    return similarity;
}

static void fill(int wished_value, int found_value)
{
    memset(wished, wished_value, sizeof wished);
    memset(found, found_value, sizeof found);
    memset(counts, 1, sizeof counts);
}

static void fill_random(uint64_t seed)
{
    for (int i = 0; i < 3 * PIXELS; i++) {
        wished[i] = (unsigned char)random_between(&seed, 0, 256);
        found[i] = (unsigned char)(0.7 * wished[i] + random_between(&seed, 0, 70));
    }
    for (int i = 0; i < PIXELS; i++)
        counts[i] = random_between(&seed, 0, 1) < 0.8;
}

/* The mean over all windows, each summed up as the paper writes it. */
static double plain_ssim(double sigma)
{
    const double c1 = 6.5025, c2 = 58.5225;
    double sum = 0;
    int windows = 0;

    for (int at = 0; at < PIXELS; at++) {
        double weight = 0, m[5] = {0};
        if (!counts[at])
            continue;
        for (int near = 0; near < PIXELS; near++) {
            int dx = near % SIDE - at % SIDE, dy = near / SIDE - at / SIDE;
            if (abs(dx) > 5 || abs(dy) > 5 || !counts[near])
                continue;
            const unsigned char *a = wished + 3 * near, *b = found + 3 * near;
            double x = 0.299 * a[0] + 0.587 * a[1] + 0.114 * a[2];
            double y = 0.299 * b[0] + 0.587 * b[1] + 0.114 * b[2];
            double w = exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
            const double terms[5] = {x, y, x * x, y * y, x * y};
            for (int k = 0; k < 5; k++)
                m[k] += w * terms[k];
            weight += w;
        }
        for (int k = 0; k < 5; k++)
            m[k] /= weight;
        sum += (2 * m[0] * m[1] + c1) * (2 * (m[4] - m[0] * m[1]) + c2) /
               ((m[0] * m[0] + m[1] * m[1] + c1) * (m[2] - m[0] * m[0] + m[3] - m[1] * m[1] + c2));
        windows++;
    }
    return sum / windows;
}

static void same_pictures_have_the_most(void **state)
{
    (void)state;
    fill_random(3);
    memcpy(found, wished, sizeof found);
    struct similarity same = compared();
    check_near(same.psnr_db, DECIBEL_MOST, 0);
    check_near(same.worst_db, DECIBEL_MOST, 0);
    check_near(same.ssim, 1, 1e-4);
}

/* 20 log10(255 / 10), and the luminance term alone: (2 100 110 + C1) / (100^2 + 110^2 + C1). */
static void constant_pictures_are_known_by_hand(void **state)
{
    (void)state;
    fill(100, 110);
    struct similarity constant = compared();
    check_near(constant.psnr_db, 28.130803608679103, 1e-9);
    check_near(constant.worst_db, 28.130803608679103, 1e-9);
    check_near(constant.ssim, 0.995476444, 1e-4);
}

/* One of 576 pixels differs, by 51 in red: 51^2 / (3 576); the worst hundredth is 5 pixels. */
static void worst_pixels_are_a_hundredth(void **state)
{
    (void)state;
    fill(100, 100);
    found[3 * 100] = 151;
    struct similarity one = compared();
    check_near(one.psnr_db, 10 * log10(65025.0 * 3 * 576 / 2601), 1e-9);
    check_near(one.worst_db, 10 * log10(65025.0 * 3 * 5 / 2601), 1e-9);
}

static void pixels_that_do_not_count_change_nothing(void **state)
{
    (void)state;
    fill_random(7);
    struct similarity before = compared();
    for (int i = 0; i < PIXELS; i++)
        if (!counts[i])
            memset(found + 3 * i, 0, 3);
    struct similarity after = compared();
    check_near(after.psnr_db, before.psnr_db, 0);
    check_near(after.ssim, before.ssim, 0);
    memset(counts, 0, sizeof counts);
    assert_false(similarity_of(&pair, &after));
}

static void ssim_is_the_plain_sum_over_windows(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 3; seed++) {
        fill_random(seed);
        check_near(compared().ssim, plain_ssim(1.5), 1e-5);
        /* Control: another window would be noticed. */
        check_at_least(fabs(compared().ssim - plain_ssim(1.6)), 1e-4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_pictures_have_the_most),
        cmocka_unit_test(constant_pictures_are_known_by_hand),
        cmocka_unit_test(worst_pixels_are_a_hundredth),
        cmocka_unit_test(pixels_that_do_not_count_change_nothing),
        cmocka_unit_test(ssim_is_the_plain_sum_over_windows),
    };
    return cmocka_run_group_tests_name("similarity", tests, NULL, NULL);
}
