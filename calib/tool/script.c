/* Scripts: each line does to the tool what a user would. */
#include "tool/script.h"

#include <string.h>

#include "option_paths.h"
#include "short_path.h"
#include "status.h"
#include "tool/keys.h"
#include "tool/script_expect.h"
#include "tool/script_line.h"

/* A line takes longer than the moment in which changes become one step of undo. */
static const double line_s = 2;

enum { TIMES_MAX = 100000, FRAMES_MAX = 1000000 };

struct playing {
    struct tool *tool;
    const struct script_stage *stage;
    char *message;
};

typedef bool (*verb)(struct playing *playing, int count, char **words);

static bool refuse(const struct playing *playing, const char *what, const char *given,
                   const char *allowed)
{
    snprintf(playing->message, MESSAGE_SIZE, "%s: '%.200s' is not allowed; allowed: %s", what,
             given, allowed);
    return false;
}

static bool play_key(struct playing *playing, int count, char **words)
{
    struct value_context context = {"key", playing->message};
    int key, modifiers, times = 1;

    if (!key_parse(words[0], &key, &modifiers))
        return refuse(playing, "key", words[0],
                      "a key's name: A to Z, 0 to 9, F1, Left, PageUp, Enter ..., with ctrl+ and "
                      "shift+");
    if (count == 2 && !value_integer(&context, words[1], 1, TIMES_MAX, &times))
        return false;
    for (int i = 0; i < times; i++)
        if (!tool_key(playing->tool, key, modifiers))
            return refuse(playing, "key", words[0],
                          "one that does something (cupola-calib --help)");
    return true;
}

static bool numbers(struct playing *playing, const char *what, int count, char **words,
                    double *values)
{
    for (int i = 0; i < count; i++)
        if (!parse_number(words[i], &values[i]))
            return refuse(playing, what, words[i], "numbers");
    return true;
}

static bool play_mouse(struct playing *playing, int count, char **words)
{
    double place_px[2];

    (void)count;
    if (!numbers(playing, "mouse", 2, words, place_px))
        return false;
    tool_mouse(playing->tool, place_px[0], place_px[1]);
    return true;
}

static bool play_press(struct playing *playing, int count, char **words)
{
    (void)count, (void)words;
    tool_mouse_button(playing->tool, true);
    return true;
}

static bool play_release(struct playing *playing, int count, char **words)
{
    (void)count, (void)words;
    tool_mouse_button(playing->tool, false);
    return true;
}

static bool set(struct playing *playing, char **words, bool *taken)
{
    int parameter = parameter_find(words[0]);
    double value;

    if (parameter < 0)
        return refuse(playing, "set", words[0], "the name of a value (cupola-calib --help)");
    if (!parameter_parse((enum parameter)parameter, words[1], &value, playing->message))
        return false;
    *taken = tool_set(playing->tool, (enum parameter)parameter, value);
    return true;
}

static bool play_set(struct playing *playing, int count, char **words)
{
    bool taken;

    (void)count;
    if (!set(playing, words, &taken))
        return false;
    if (!taken)
        snprintf(playing->message, MESSAGE_SIZE, "set %s %.100s is refused: %.1300s", words[0],
                 words[1], playing->tool->warning);
    return taken;
}

static bool play_refuse(struct playing *playing, int count, char **words)
{
    bool taken;

    (void)count;
    if (!set(playing, words, &taken))
        return false;
    if (taken)
        snprintf(playing->message, MESSAGE_SIZE, "expected that %s %.200s is refused; it was taken",
                 words[0], words[1]);
    return !taken;
}

static bool play_expect(struct playing *playing, int count, char **words)
{
    return script_expect(playing->tool, count, words, playing->message);
}

static bool picture(struct playing *playing, bool dome, const char *path)
{
    const struct value_context context = {dome ? "dome" : "picture", playing->message};

    playing->tool->wants_picture = false;
    if (!value_output_path(&context, path, &path) ||
        !tool_files_check_line(playing->tool, context.option, path, false, playing->message))
        return false;
    if (playing->stage)
        return playing->stage->picture(playing->stage->user, playing->tool, dome, path,
                                       playing->message);
    snprintf(playing->message, MESSAGE_SIZE, "nothing can be drawn here");
    return false;
}

static bool play_picture(struct playing *playing, int count, char **words)
{
    (void)count;
    return picture(playing, false, words[0]);
}

static bool play_dome(struct playing *playing, int count, char **words)
{
    (void)count;
    return picture(playing, true, words[0]);
}

static bool play_frames(struct playing *playing, int count, char **words)
{
    struct value_context context = {"frames", playing->message};
    int frames;

    (void)count;
    if (!value_integer(&context, words[0], 1, FRAMES_MAX, &frames))
        return false;
    if (playing->stage)
        return playing->stage->frames(playing->stage->user, playing->tool, frames,
                                      playing->message);
    snprintf(playing->message, MESSAGE_SIZE, "nothing can be drawn here");
    return false;
}

static bool play_eye(struct playing *playing, int count, char **words)
{
    struct cupola_rig rig = playing->tool->rig;
    struct cupola_error error = {0};
    double eye_m[3];

    if (count == 1 && strcmp(words[0], "off") == 0) {
        playing->tool->viewer_lives = false;
        return true;
    }
    if (count != 3 || !numbers(playing, "eye", 3, words, eye_m))
        return refuse(playing, "eye", words[0], "X Y Z, or off");
    memcpy(rig.eye_m, eye_m, sizeof eye_m);
    if (cupola_rig_complete(&rig, NULL, &error) < 0) {
        snprintf(playing->message, MESSAGE_SIZE, "eye %.100s %.100s %.100s is refused: %s",
                 words[0], words[1], words[2], error.message);
        return false;
    }
    memcpy(playing->tool->live_eye_m, eye_m, sizeof eye_m);
    playing->tool->viewer_lives = true;
    return true;
}

static bool play_save(struct playing *playing, int count, char **words)
{
    struct tool *tool = playing->tool;

    if (count > 0 && !tool_files_check_line(tool, "save", words[0], true, playing->message))
        return false;
    if (tool_save(tool, count > 0 ? words[0] : tool->rig_path))
        return true;
    snprintf(playing->message, MESSAGE_SIZE, "%s", tool->warning);
    return false;
}

static const struct {
    const char *name;
    int least, most; /* words behind it */
    verb play;
    const char *shape;
} verbs[] = {
    {"key", 1, 2, play_key, "key NAME [TIMES]"},
    {"mouse", 2, 2, play_mouse, "mouse X Y"},
    {"press", 0, 0, play_press, "press"},
    {"release", 0, 0, play_release, "release"},
    {"set", 2, 2, play_set, "set NAME VALUE"},
    {"refuse", 2, 2, play_refuse, "refuse NAME VALUE"},
    {"expect", 2, 4, play_expect, "expect NAME VALUE [within T]"},
    {"picture", 1, 1, play_picture, "picture FILE.png"},
    {"dome", 1, 1, play_dome, "dome FILE.png"},
    {"frames", 1, 1, play_frames, "frames N"},
    {"eye", 1, 3, play_eye, "eye X Y Z, or eye off"},
    {"save", 0, 1, play_save, "save [FILE]"},
};

static bool play_line(struct playing *playing, struct script_line *line)
{
    int count = line->count - 1;

    for (size_t i = 0; i < sizeof verbs / sizeof *verbs; i++) {
        if (strcmp(verbs[i].name, line->words[0]) != 0)
            continue;
        if (count >= verbs[i].least && count <= verbs[i].most)
            return verbs[i].play(playing, count, line->words + 1);
        snprintf(playing->message, MESSAGE_SIZE, "%d words; allowed: %s", line->count,
                 verbs[i].shape);
        return false;
    }
    return refuse(playing, "line", line->words[0],
                  "key, mouse, press, release, set, refuse, expect, picture, dome, frames, eye, "
                  "save");
}

int script_play(struct tool *tool, FILE *stream, const char *name, const struct script_stage *stage,
                char *message)
{
    struct script_line line = {0};
    char problem[MESSAGE_SIZE];
    struct playing playing = {tool, stage, problem};
    enum script_next next;

    while ((next = script_line_next(&line, stream, problem)) == SCRIPT_LINE) {
        tool->time_s += line_s;
        if (!play_line(&playing, &line)) {
            next = SCRIPT_REFUSED;
            break;
        }
        tool_idle(tool);
    }
    if (next == SCRIPT_END)
        return STATUS_OK;
    snprintf(message, MESSAGE_SIZE, "%s:%d: %.1100s", short_path(name).text, line.number, problem);
    return STATUS_FAILED;
}
