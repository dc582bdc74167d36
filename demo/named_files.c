/* Files that a command line names twice. */
#include "named_files.h"

#include <stdio.h>

#include "option_values.h"
#include "same_file.h"
#include "short_path.h"

bool named_files_differ(const struct named_file *files, int count, char *message)
{
    for (int i = 0; i < count; i++) {
        for (int j = i + 1; j < count; j++) {
            bool in_place = i == 0 && files[j].in_place;
            if (!files[i].path || !files[j].path || !(files[i].written || files[j].written) ||
                in_place || !same_file(files[i].path, files[j].path))
                continue;
            snprintf(message, MESSAGE_SIZE,
                     "%s and %s are the same file, %s; allowed: files of their own", files[i].name,
                     files[j].name, short_path(files[j].path).text);
            return false;
        }
    }
    return true;
}
