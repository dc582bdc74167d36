/* Any text as a rig file: refused in one line, or a rig that is complete and prints as itself. */
#define _POSIX_C_SOURCE 200809L

#include "cupola/dome.h"
#include "cupola/rig_file.h"
#include "io/rig_write.h"
#include "target.h"

static char *text_of_rig(const struct cupola_rig *rig)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    require(stream != NULL);
    rig_write(stream, rig);
    require(fclose(stream) == 0 && text != NULL);
    return text;
}

/* What is written reads back as the same rig: its text is the same, and numbers print exactly. */
static void require_round_trip(const struct cupola_rig *rig)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_rig again;
    char *text = text_of_rig(rig);
    if (cupola_rig_parse(text, "again", NULL, &again, &error) != CUPOLA_OK) {
        fprintf(stderr, "%s\n%s\n", text, error.message);
        abort();
    }
    char *second = text_of_rig(&again);
    require(strcmp(text, second) == 0);
    free(text);
    free(second);
}

static void require_usable(const struct cupola_rig *rig)
{
    struct cupola_rig complete;
    cupola_dome *dome = NULL;
    require(cupola_rig_complete(rig, &complete, NULL) == CUPOLA_OK);
    char *text = text_of_rig(rig), *completed = text_of_rig(&complete);
    require(strcmp(text, completed) == 0);
    free(text);
    free(completed);
    require(cupola_dome_create(rig, &dome, NULL) == CUPOLA_OK);
    cupola_dome_destroy(&dome);
    require(dome == NULL);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct cupola_rig untouched;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_rig rig;
    char *text = malloc(size + 1);
    require(text != NULL);
    if (size)
        memcpy(text, data, size);
    text[size] = 0;
    memset(&untouched, 0x5a, sizeof untouched);
    memset(&rig, 0x5a, sizeof rig);
    int status = cupola_rig_parse(text, "fuzz", NULL, &rig, &error);
    free(text);
    if (status == CUPOLA_OK) {
        require(error.status == CUPOLA_OK && error.message[0] == 0);
        require_usable(&rig);
        require_round_trip(&rig);
    } else {
        require_message(&error, status);
        require(memcmp(&rig, &untouched, sizeof rig) == 0);
    }
    return 0;
}
