/* Runs the demo as a user does. */
#include "process.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "check.h"

enum { ARGUMENTS_MAX = 64 };

static char directory[] = "/tmp/cupola-cli-XXXXXX";

static void read_back(FILE *file, char *text, size_t text_size)
{
    size_t length;

    rewind(file);
    length = fread(text, 1, text_size - 1, file);
    text[length] = 0;
    fclose(file);
}

static void become(char **arguments, const char *setting, FILE *out, FILE *err)
{
    char copy[200];
    char *equals;

    alarm(60); /* outlives the exec: a program that hangs ends by a signal */
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    if (setting) {
        snprintf(copy, sizeof copy, "%s", setting);
        equals = strchr(copy, '=');
        *equals = 0;
        setenv(copy, equals + 1, 1);
    }
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(fileno(out), STDOUT_FILENO);
    dup2(fileno(err), STDERR_FILENO);
    execv(arguments[0], arguments);
    _exit(127);
}

/* A program that runs. */
struct running {
    pid_t child;
    FILE *out, *err;
};

static struct running start(const char *command, const char *setting)
{
    char copy[2000];
    char *arguments[ARGUMENTS_MAX] = {getenv("CUPOLA_DEMO")};
    int count = 1;
    struct running running = {.out = tmpfile(), .err = tmpfile()};

    assert_non_null(arguments[0]);
    assert_non_null(running.out);
    assert_non_null(running.err);
    snprintf(copy, sizeof copy, "%s", command);
    for (char *word = strtok(copy, " "); word; word = strtok(NULL, " ")) {
        assert_true(count < ARGUMENTS_MAX - 1);
        arguments[count++] = word;
    }
    fflush(NULL);
    running.child = fork();
    assert_true(running.child >= 0);
    if (running.child == 0)
        become(arguments, setting, running.out, running.err);
    return running;
}

static void end(const struct running *running, int status, struct process *process)
{
    process->status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    read_back(running->out, process->out, sizeof process->out);
    read_back(running->err, process->err, sizeof process->err);
}

void process_run(struct process *process, const char *command, const char *setting)
{
    struct running running = start(command, setting);
    int status = 0;

    assert_int_equal(waitpid(running.child, &status, 0), running.child);
    end(&running, status, process);
}

void process_run_until(struct process *process, const char *command, const char *awaited,
                       int more_ms, int signal_number)
{
    const struct timespec pause = {0, 1000000};
    struct running running = start(command, NULL);
    int status = 0;
    pid_t ended = 0;

    while (more_ms > 0 && (ended = waitpid(running.child, &status, WNOHANG)) == 0) {
        nanosleep(&pause, NULL);
        more_ms -= access(awaited, F_OK) == 0;
    }
    if (ended == 0) {
        kill(running.child, signal_number);
        ended = waitpid(running.child, &status, 0);
    }
    assert_int_equal(ended, running.child);
    end(&running, status, process);
}

int process_enter_directory(void **state)
{
    (void)state;
    strcpy(directory, "/tmp/cupola-cli-XXXXXX");
    return mkdtemp(directory) && chdir(directory) == 0 ? 0 : -1;
}

int process_leave_directory(void **state)
{
    char command[100];

    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", directory);
    return chdir("/") == 0 && system(command) == 0 ? 0 : -1;
}

int process_count_files(void)
{
    int count = 0;
    DIR *here = opendir(".");

    assert_non_null(here);
    while (readdir(here))
        count++;
    closedir(here);
    return count;
}

void process_write_file(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");

    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, strlen(text), file), strlen(text));
    assert_int_equal(fclose(file), 0);
}

bool process_file_is(const char *name, const char *text)
{
    char found[4096];
    size_t length;
    FILE *file = fopen(name, "r");

    if (!file)
        return false;
    length = fread(found, 1, sizeof found, file);
    fclose(file);
    return length == strlen(text) && memcmp(found, text, length) == 0;
}
