#include "tests/unit/walk/floors.h"

namespace floors
{

Floor two_rooms(bool with_door)
{
    Floor floor;
    floor.add(0, 0, 16.2, 6);
    floor.wall(8, 0, 8.2, 2.4);
    floor.wall(8, 3.6, 8.2, 6);
    if (with_door) floor.door(7.9, 2.4, 8.3, 3.6);
    return floor;
}

clq_walker Held::add(double x, double z, const clq_locomotion *locomotion, float radius_m) const
{
    clq_walker_def def = clq_walker_def_init();
    def.position[0] = x, def.position[2] = z, def.locomotion = locomotion;
    def.radius_m = radius_m;
    clq_walker made = {0, 0};
    EXPECT_EQ(clq_walkers_add(walkers, &def, &made), CLQ_OK) << clq_last_error();
    return made;
}

void Held::go(clq_walker walker, double x, double z, float near_m) const
{
    const double goal[3] = {x, 0, z};
    EXPECT_EQ(clq_walker_go(walkers, walker, goal, near_m, 0), CLQ_OK) << clq_last_error();
}

clq_walker_info Held::info(clq_walker walker) const
{
    clq_walker_info out = clq_walker_info_init();
    EXPECT_EQ(clq_walkers_get_walker(walkers, walker, &out), CLQ_OK) << clq_last_error();
    return out;
}

uint64_t Held::hash() const
{
    clq_walkers_info out = clq_walkers_info_init();
    EXPECT_EQ(clq_walkers_get_info(walkers, &out), CLQ_OK);
    return out.hash;
}

void Held::step(int count) const
{
    for (int i = 0; i < count; ++i) ASSERT_EQ(clq_walkers_step(walkers), CLQ_OK) << clq_last_error();
}

}  // namespace floors
