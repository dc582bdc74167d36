/* cupola-bench: what a dome costs, as ratios within one run. docs/benchmarks.md explains them. */
#include <stdio.h>
#include <stdlib.h>

#include "families.h"
#include "headless.h"
#include "json.h"

/* A machine without any GL context: Meson counts it as skipped. */
enum { EXIT_SKIPPED = 77 };

static bool run(struct bench *bench)
{
    struct stopwatch watch;
    bool done = true;

    stopwatch_create(&watch, bench->options.wishes.clock);
    json_begin(bench->file, &bench->options.wishes, watch.clock);
    stopwatch_destroy(&watch);
    for (int i = 0; i < FAMILIES && done; i++)
        if (bench->options.families[i])
            done = family_run(bench, (enum family)i);
    json_end(bench->file);
    if (done && bench->others == 0) {
        snprintf(bench->message, sizeof bench->message,
                 "--contenders names none that takes part; the results without it have the names");
        done = false;
    }
    if (bench->scene)
        bench->scene->destroy(bench->scene);
    if (!done)
        fprintf(stderr, "cupola-bench: %s\n", bench->message);
    return done;
}

static bool names_contenders(const struct options *options)
{
    for (int i = 0; i < options->contender_count; i++)
        if (!family_has(options->contenders[i])) {
            fprintf(stderr,
                    "cupola-bench: --contenders: there is no '%s'; docs/benchmarks.md has the "
                    "names\n",
                    options->contenders[i]);
            return false;
        }
    return true;
}

int main(int argc, char **argv)
{
    struct bench bench = {.file = stdout};
    struct headless *headless;
    int status;

    if (!options_read(&bench.options, argc, argv, &status))
        return status;
    if (!names_contenders(&bench.options))
        return 2;
    if (!loads_check(bench.options.loads, bench.options.load_count, bench.message)) {
        fprintf(stderr, "cupola-bench: %s\n", bench.message);
        return 2;
    }
    headless = headless_create(bench.message, sizeof bench.message);
    if (!headless) {
        fprintf(stderr, "cupola-bench: %s\n", bench.message);
        return EXIT_SKIPPED;
    }
    if (bench.options.output && !(bench.file = fopen(bench.options.output, "w"))) {
        fprintf(stderr, "cupola-bench: '%s' cannot be written\n", bench.options.output);
        headless_destroy(headless);
        return EXIT_FAILURE;
    }
    status = run(&bench) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (!json_close(bench.file, bench.options.output, bench.message)) {
        fprintf(stderr, "cupola-bench: %s\n", bench.message);
        status = EXIT_FAILURE;
    }
    headless_destroy(headless);
    return status;
}
