/* A host in C++: what it includes is what it can link. */
#include <cupola/cupola.h>

#include <cstring>

static_assert(CUPOLA_ERROR_ARGUMENT < 0, "errors are negative");

int main()
{
    cupola_rig rig = {};
    cupola_dome *dome = nullptr;
    cupola_plan *plan = nullptr;
    if (cupola_dome_create(&rig, &dome, nullptr) < 0 ||
        cupola_plan_create(dome, nullptr, &plan, nullptr) < 0)
        return 1;
    int views = cupola_plan_view_count(plan);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
    return views > 0 && std::strlen(cupola_version()) > 0 ? 0 : 1;
}
