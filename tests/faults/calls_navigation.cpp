// Calls for grounds and walkers. Recast and Detour get memory that never fails: the former ends the process otherwise
// (docs/navigation.md).
#include <cstdlib>

#include <DetourAlloc.h>
#include <RecastAlloc.h>

#include "tests/api/failing_memory.h"
#include "tests/faults/calls.h"
#include "tests/unit/walk/floors.h"

namespace faults
{
namespace
{

using W = World &;
using floors::Held;

void *unfailing(size_t bytes)
{
    const failing_memory::Unarmed unarmed;
    return std::malloc(bytes);
}

floors::Floor two_halves()
{
    floors::Floor floor;
    floor.cell_m = 0.2f;
    floor.add(0, 0, 8, 3);
    floor.door(3.8, 0.2, 4.4, 2.8);
    return floor;
}

struct Crowd : Held {
    explicit Crowd(W w) : Held(two_halves())
    {
        for (int i = 0; i < 3; ++i) go(last = add(1 + 0.8 * i, 0.6 + 0.8 * i, w.test.locomotion), 7, 1.5);
        step(12);
    }
    clq_walker last = {0, 0};
};

uint64_t seen_of(const Held &held)
{
    clq_walkers_info info = clq_walkers_info_init();
    EXPECT_EQ(clq_walkers_get_info(held.walkers, &info), CLQ_OK) << clq_last_error();
    bool open = false;
    EXPECT_EQ(clq_navigation_get_door(held.navigation, 0, &open), CLQ_OK) << clq_last_error();
    return info.hash ^ (info.ticks << 8) ^ (info.pieces << 16) ^ (info.count << 24) ^ (info.waiting << 28) ^ open;
}

// A call for walkers on their way; a failed one must have changed nothing.
template <class Body>
auto on_crowd(const Body &body)
{
    return [body](W w) {
        Crowd *crowd;
        uint64_t before;
        {
            const failing_memory::Unarmed unarmed;
            crowd = new Crowd(w);
            before = seen_of(*crowd);
        }
        clq_status status = body(w, *crowd);
        const failing_memory::Unarmed unarmed;
        w.found = seen_of(*crowd);
        if (status != CLQ_OK && w.found != before) status = clq_report(CLQ_CALLBACK, "the failed call moved walkers");
        delete crowd;
        return status;
    };
}

// A step that fails is made good by the next ones.
clq_status walkers_step(W w)
{
    const auto finish = [](const Crowd &crowd) {
        for (clq_walkers_info info = clq_walkers_info_init(); info.ticks < 40;) {
            (void)clq_walkers_step(crowd.walkers);
            EXPECT_EQ(clq_walkers_get_info(crowd.walkers, &info), CLQ_OK);
        }
        return seen_of(crowd);
    };
    Crowd *crowd;
    {
        const failing_memory::Unarmed unarmed;
        crowd = new Crowd(w);
    }
    clq_status status = CLQ_OK;
    for (int i = 0; i < 10 && status == CLQ_OK; ++i) status = clq_walkers_step(crowd->walkers);
    const failing_memory::Unarmed unarmed;
    const std::string says = clq_last_error();
    static const uint64_t wanted = finish(Crowd(w));  // without a fault
    w.found = finish(*crowd);
    delete crowd;
    if (w.found != wanted) return clq_report(CLQ_CALLBACK, "the steps after a failed one went elsewhere");
    return status == CLQ_OK ? status : clq_report(status, says.c_str());
}

void add_grounds(std::vector<Call> &all)
{
    all.push_back({"clq_navigation_create",
                   [](W w) {
                       floors::Floor *floor;
                       {
                           const failing_memory::Unarmed unarmed;
                           floor = new floors::Floor(two_halves());
                       }
                       const clq_navigation_def def = floor->def();
                       const clq_status status = clq_navigation_create(&def, w.out<clq_navigation>());
                       const failing_memory::Unarmed unarmed;
                       delete floor;
                       return status;
                   },
                   0, [](W w) { clq_navigation_destroy(static_cast<clq_navigation *>(w.made)); }});
    all.push_back({"clq_navigation_destroy", [](W) { return clq_navigation_destroy(nullptr), CLQ_OK; }, quiet});
    all.push_back({"clq_navigation_get_info", on_crowd([](W, const Crowd &crowd) {
                       clq_navigation_info info = clq_navigation_info_init();
                       return clq_navigation_get_info(crowd.navigation, &info);
                   }),
                   quiet});
    all.push_back({"clq_navigation_set_door",
                   on_crowd([](W, const Crowd &crowd) { return clq_navigation_set_door(crowd.navigation, 0, false); }),
                   quiet});
    all.push_back({"clq_navigation_get_door", on_crowd([](W, const Crowd &crowd) {
                       bool open = false;
                       return clq_navigation_get_door(crowd.navigation, 0, &open);
                   }),
                   quiet});
    all.push_back({"clq_navigation_find_nearest", on_crowd([](W, const Crowd &crowd) {
                       const double point[3] = {2, 0.5, 1};
                       double out[3];
                       bool found = false;
                       return clq_navigation_find_nearest(crowd.navigation, point, 2, out, &found);
                   }),
                   quiet});
    all.push_back({"clq_navigation_find_way", on_crowd([](W, const Crowd &crowd) {
                       const double from[3] = {1, 0, 1}, to[3] = {7, 0, 2};
                       double points[30];
                       clq_way way = clq_way_init();
                       return clq_navigation_find_way(crowd.navigation, from, to, 10, points, &way);
                   })});
}

void add_walkers(std::vector<Call> &all)
{
    all.push_back({"clq_walkers_create", on_crowd([](W, const Crowd &crowd) {
                       clq_walkers *made = nullptr;
                       const clq_status status = clq_walkers_create(crowd.navigation, nullptr, &made);
                       clq_walkers_destroy(made);
                       return status;
                   })});
    all.push_back({"clq_walkers_destroy", [](W) { return clq_walkers_destroy(nullptr), CLQ_OK; }, quiet});
    all.push_back({"clq_walkers_add", on_crowd([](W w, const Crowd &crowd) {
                       clq_walker_def def = clq_walker_def_init();
                       def.position[0] = def.position[2] = 2, def.locomotion = w.test.locomotion;
                       clq_walker made = {0, 0};
                       return clq_walkers_add(crowd.walkers, &def, &made);
                   })});
    all.push_back({"clq_walkers_remove",
                   on_crowd([](W, const Crowd &crowd) { return clq_walkers_remove(crowd.walkers, crowd.last); }),
                   quiet});
    all.push_back({"clq_walker_go", on_crowd([](W, const Crowd &crowd) {
                       const double goal[3] = {1, 0, 1};
                       return clq_walker_go(crowd.walkers, crowd.last, goal, 0.5f, 0);
                   }),
                   quiet});
    all.push_back({"clq_walker_stop",
                   on_crowd([](W, const Crowd &crowd) { return clq_walker_stop(crowd.walkers, crowd.last); }), quiet});
    all.push_back({"clq_walkers_get_walker", on_crowd([](W, const Crowd &crowd) {
                       clq_walker_info info = clq_walker_info_init();
                       return clq_walkers_get_walker(crowd.walkers, crowd.last, &info);
                   }),
                   quiet});
    all.push_back({"clq_walkers_step", walkers_step});
    all.push_back({"clq_walkers_get_pieces", on_crowd([](W, const Crowd &crowd) {
                       const clq_walker_piece *pieces = nullptr;
                       uint32_t count = 0;
                       return clq_walkers_get_pieces(crowd.walkers, &pieces, &count);
                   }),
                   quiet});
    all.push_back({"clq_walkers_get_info", on_crowd([](W, const Crowd &crowd) {
                       clq_walkers_info info = clq_walkers_info_init();
                       return clq_walkers_get_info(crowd.walkers, &info);
                   }),
                   quiet});
    all.push_back({"clq_stage_set_navigation", on_crowd([](W w, const Crowd &crowd) {
                       clq_stage *stage = nullptr;
                       {
                           const failing_memory::Unarmed unarmed;
                           EXPECT_EQ(clq_stage_create(w.test.context, nullptr, &stage), CLQ_OK) << clq_last_error();
                       }
                       const clq_locomotion *const walks[1] = {w.test.locomotion};
                       const clq_status status = clq_stage_set_navigation(stage, crowd.navigation, nullptr, walks, 1);
                       const failing_memory::Unarmed unarmed;
                       clq_stage_destroy(stage);
                       return status;
                   })});
}

}  // namespace

void add_navigation_calls(std::vector<Call> &all)
{
    rcAllocSetCustom([](size_t bytes, rcAllocHint) { return unfailing(bytes); }, std::free);
    dtAllocSetCustom([](size_t bytes, dtAllocHint) { return unfailing(bytes); }, std::free);
    add_grounds(all), add_walkers(all);
}

}  // namespace faults
