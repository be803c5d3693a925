// clq_walkers.
#include "lib/stage/walk/limits.h"
#include "lib/stage/walk/walkers.h"

using namespace claque;

extern "C" {

clq_status clq_walkers_create(clq_navigation *navigation, const clq_walkers_def *def, clq_walkers **out)
{
    return walk::boundary("clq_walkers_create", [&] {
        walk::require(navigation && out, "navigation or out is NULL");
        const clq_walkers_def wanted = stage::read_def(def, clq_walkers_def_init, "clq_walkers_def_init");
        *out = std::make_unique<clq_walkers>(*navigation, wanted).release();
    });
}

void clq_walkers_destroy(clq_walkers *walkers) { delete walkers; }

clq_status clq_walkers_add(clq_walkers *walkers, const clq_walker_def *def, clq_walker *out)
{
    return walk::boundary("clq_walkers_add", [&] {
        walk::require(walkers && def && out, "walkers, def or out is NULL");
        walk::require_size(*def, "clq_walker_def_init");
        *out = walkers->add(*def);
    });
}

clq_status clq_walkers_remove(clq_walkers *walkers, clq_walker walker)
{
    return walk::boundary("clq_walkers_remove", [&] {
        walk::require(walkers != nullptr, "walkers is NULL");
        walkers->remove(walker);
    });
}

clq_status clq_walker_go(clq_walkers *walkers, clq_walker walker, const double goal[3], float near_m, float speed_m_s)
{
    return walk::boundary("clq_walker_go", [&] {
        walk::require(walkers && goal, "walkers or goal is NULL");
        walkers->go(walker, goal, near_m, speed_m_s);
    });
}

clq_status clq_walker_stop(clq_walkers *walkers, clq_walker walker)
{
    return walk::boundary("clq_walker_stop", [&] {
        walk::require(walkers != nullptr, "walkers is NULL");
        walkers->stop(walker);
    });
}

clq_status clq_walkers_get_walker(const clq_walkers *walkers, clq_walker walker, clq_walker_info *out)
{
    return walk::boundary("clq_walkers_get_walker", [&] {
        walk::require(walkers && out, "walkers or out is NULL");
        walk::require_size(*out, "clq_walker_info_init");
        walkers->get(walker, *out);
    });
}

clq_status clq_walkers_step(clq_walkers *walkers)
{
    return walk::boundary("clq_walkers_step", [&] {
        walk::require(walkers != nullptr, "walkers is NULL");
        walkers->step();
    });
}

clq_status clq_walkers_get_pieces(const clq_walkers *walkers, const clq_walker_piece **out, uint32_t *count)
{
    return walk::boundary("clq_walkers_get_pieces", [&] {
        walk::require(walkers && out && count, "walkers, out or count is NULL");
        *out = walkers->pieces().data();
        *count = static_cast<uint32_t>(walkers->pieces().size());
    });
}

clq_status clq_walkers_get_info(const clq_walkers *walkers, clq_walkers_info *out)
{
    return walk::boundary("clq_walkers_get_info", [&] {
        walk::require(walkers && out, "walkers or out is NULL");
        walk::require_size(*out, "clq_walkers_info_init");
        clq_walkers_info info = clq_walkers_info_init();
        walkers->get(info);
        *out = info;
    });
}

}  // extern "C"
