/* A trial of a model in a process of its own. */
#include "model_trial.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "model.h"
#include "short_path.h"

/* Where a PLY header does not end, assimp 5.2 looks for its end for ever. */
static bool header_ends(const char *path)
{
    enum { HEADER_MAX = 1 << 20 };
    char line[4096];
    long read = 0;
    bool ends = false;
    FILE *file = fopen(path, "rb");

    if (!file)
        return true;
    if (!fgets(line, sizeof line, file) || strncmp(line, "ply", 3) != 0) {
        fclose(file);
        return true; /* no PLY */
    }
    while (!ends && read < HEADER_MAX && fgets(line, sizeof line, file)) {
        ends = strncmp(line, "end_header", 10) == 0;
        read += (long)strlen(line) + 1;
    }
    fclose(file);
    return ends;
}

/* In the child. What assimp says to the terminal is not for the user. */
static void try_and_exit(const char *path, bool want_normals, off_t size)
{
    char message[200];
    rlim_t seconds = 20 + (rlim_t)(size / 100000);
    int nowhere = open("/dev/null", O_RDWR);

    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds + 1});
    signal(SIGABRT, SIG_DFL);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    model_destroy(model_load(path, want_normals, message, sizeof message));
    _exit(0);
}

bool model_trial(const char *path, bool want_normals, char *message, size_t message_size)
{
    struct stat file;
    int status = 0;
    pid_t child;

    if (stat(path, &file) != 0 || !S_ISREG(file.st_mode))
        return true;
    if (!header_ends(path)) {
        snprintf(message, message_size,
                 "%s: cannot be read as a model: it begins like a PLY file, but its header has no "
                 "line end_header",
                 short_path(path).text);
        return false;
    }
    fflush(NULL);
    child = fork();
    if (child < 0)
        return true; /* no room for a trial: take the risk */
    if (child == 0)
        try_and_exit(path, want_normals, file.st_size);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return true;
    snprintf(message, message_size,
             "%s: cannot be read as a model (OBJ, PLY, glTF, 3DS ...): it is broken, its reader %s",
             short_path(path).text,
             WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)
                 ? "did not come to an end"
                 : "crashed");
    return false;
}
