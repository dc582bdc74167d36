/* What a project with Cupola as its subproject sees: headers, symbols and the version. */
#include <stdio.h>
#include <string.h>

#include <cupola/cupola.h>

int main(void)
{
    char compiled[32];
    struct cupola_rig rig = {0};
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    int views = 0;

    snprintf(compiled, sizeof compiled, "%d.%d.%d", CUPOLA_VERSION_MAJOR, CUPOLA_VERSION_MINOR,
             CUPOLA_VERSION_PATCH);
    if (cupola_dome_create(&rig, &dome, NULL) == CUPOLA_OK &&
        cupola_plan_create(dome, NULL, &plan, NULL) == CUPOLA_OK)
        views = cupola_plan_view_count(plan);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
    return strcmp(compiled, cupola_version()) == 0 && views > 0 ? 0 : 1;
}
