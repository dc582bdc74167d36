/* What cupola-calib --help says. */
#include <stdio.h>

#include "tool/keys.h"
#include "tool/tool.h"
#include "tool/tool_options.h"

static const char usage_text[] =
    "Usage: cupola-calib [OPTIONS] [RIG.cfg]\n"
    "       cupola-calib solve MARKS.csv --rig START.cfg --output RIG.cfg [...]\n"
    "       cupola-calib capture COMMAND [...]\n"
    "Makes a dome right for its viewer. Without a command it fills the projector's monitor with a\n"
    "pattern, and keys adjust everything while one watches. solve: the projector from measured\n"
    "marks; capture: marks by structured light. Both have a --help of their own.\n";

static const char file_text[] = "\nFiles\n"
                                "  --rig FILE             the rig to begin with, as RIG.cfg\n"
                                "  --preset NAME          or one of these: ";

static const char more_file_text[] =
    "\n"
    "  --projector N          the rig's projector that is set up, 0 the first\n"
    "  --output FILE          where to save; default RIG.cfg, else rig.cfg. What was there stays "
    "as\n"
    "                         FILE.bak\n"
    "  --marks FILE.csv       places of the screen to steer the cross-hair to, or marks that have\n"
    "                         pixels already\n"
    "  --marks-output FILE    where they are saved with their pixels; default FILE-steered.csv\n"
    "  --theatre TRUE.cfg     the theatre that the preview simulates; default: the rig at the "
    "start\n"
    "  --fresh                does not go on with what a crash or Esc left unsaved: moves the\n"
    "                         journal, FILE.journal beside --output, aside as FILE.journal.old\n";

static const char show_text[] = "\nWhat is shown\n"
                                "  --pattern NAME         ";

static const char more_show_text[] =
    "\n"
    "  --preview NAME         none | eye | outside: the simulated theatre beside the image\n"
    "  --monitor N            the projector's, 0 the first\n"
    "  --windowed [WxH]       a window instead of the whole monitor, default as the rig's image\n"
    "  --swap-interval N      0 to 60; default 1\n"
    "  --osc [HOST:]PORT      the eye is where messages /viewer x y z say, metres; of this "
    "machine\n"
    "                         unless HOST is another address of its own\n"
    "  --viewer-lookahead MS  predicts the eye of --osc so far ahead, 0 to 500, default 20\n"
    "\nWithout a display\n"
    "  --script FILE|-        plays keys and checks values; see cupola-calib(1). Exit status 1 at\n"
    "                         the first line that fails\n"
    "  --journal              keeps a journal of a script, too\n"
    "  --picture FILE.png     writes what the window would show and ends\n"
    "  --frames N             ends after N frames\n"
    "  --headless             no window, with --frames\n"
    "  -h, --help, --version\n"
    "\nKeys\n";

static void print_names(const char *(*name_of)(int index))
{
    char list[400];

    value_name_list(name_of, list, sizeof list);
    fputs(list, stdout);
}

static void print_words(enum parameter parameter)
{
    const char *word;

    printf("  %s is", parameter_name((int)parameter));
    for (int i = 0; (word = parameter_word(parameter, i)); i++)
        printf("%s %s", i > 0 ? "," : "", word);
    putchar('\n');
}

/* Wraps: there are many. */
static void print_values(void)
{
    int column = 0;

    printf("\nValues, as scripts name them\n");
    for (int i = 0; parameter_name(i); i++) {
        int length = (int)snprintf(NULL, 0, "%s", parameter_name(i)) + 2;
        if (column + length > 90) {
            printf(",\n");
            column = 0;
        }
        column += printf("%s%s", column ? ", " : "  ", parameter_name(i));
    }
    putchar('\n');
    print_words(PARAMETER_FLIP);
    print_words(PARAMETER_LENS);
}

void tool_options_help(void)
{
    struct key_line line;

    fputs(usage_text, stdout);
    fputs(file_text, stdout);
    print_names(cupola_rig_preset_name);
    fputs(more_file_text, stdout);
    fputs(show_text, stdout);
    print_names(tool_pattern_name);
    fputs(more_show_text, stdout);
    for (int i = 0; key_line(i, &line); i++)
        printf("  %-21s  %s\n", line.keys, line.help);
    print_values();
    printf("\nExit status: 0; 1 for failures and expectations of a script that are not met; 2 for\n"
           "wrong options.\n");
}
