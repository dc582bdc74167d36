/* The journal. */
#include "tool/journal.h"

enum journal_found journal_open(struct tool *tool, bool fresh, char *message)
{
    (void)tool, (void)fresh, (void)message;
    return JOURNAL_NEW;
}

void journal_change(struct tool *tool, const struct values *before, const struct change *change,
                    bool merges)
{
    (void)tool, (void)before, (void)change, (void)merges;
}

void journal_note(struct tool *tool, const char *line)
{
    (void)tool, (void)line;
}

void journal_look(struct tool *tool)
{
    (void)tool;
}

void journal_idle(struct journal *journal, double time_s)
{
    (void)journal, (void)time_s;
}

void journal_close(struct journal **journal, bool remove_file)
{
    (void)journal, (void)remove_file;
}
