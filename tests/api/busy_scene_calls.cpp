// The calls for scenes.
#include <cmath>

#include "tests/api/busy_calls.h"

namespace busy
{

clq_scene *new_scene(clq_crowd *crowd, clq_actor actor)
{
    clq_scene *made = nullptr;
    const double key = 2;
    EXPECT_EQ(clq_scene_create(crowd, &made), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_scene_set_keys(made, &actor, &key, 1), CLQ_OK) << clq_last_error();
    return made;
}

void add_scene_calls(std::vector<Call> &all)
{
    using O = const Objects &;
    const auto add = [&](Use use, const char *name, std::function<clq_status(O)> run) {
        all.push_back({name, use, std::move(run)});
    };
    static const double origin[3] = {0, 0, 0}, low[3] = {-50, -50, -50}, high[3] = {50, 50, 50};
    static const clq_ray ray = {{0, 1, 4}, {0, 0, -1}, 100};
    add(Use::changes_crowd, "clq_scene_create", [](O o) {
        clq_scene *made;
        return clq_scene_create(o.crowd, &made);
    });
    add(Use::changes_crowd, "clq_scene_destroy", [](O o) { return clq_scene_destroy(o.scene); });
    add(Use::changes_crowd, "clq_scene_update", [](O o) { return clq_scene_update(o.scene, 2); });
    add(Use::changes_crowd, "clq_scene_set_categories",
        [](O o) { return clq_scene_set_categories(o.scene, &o.actor, 1, 6); });
    add(Use::changes_crowd, "clq_scene_set_keys", [](O o) {
        const double key = 3;
        return clq_scene_set_keys(o.scene, &o.actor, &key, 1);
    });
    const auto read = [&](const char *name, std::function<clq_status(O)> run) {
        add(Use::reads_crowd, name, std::move(run));
    };
    read("clq_scene_get_actor", [](O o) {
        clq_scene_actor known = clq_scene_actor_init();
        return clq_scene_get_actor(o.scene, o.actor, 1, &known);
    });
    read("clq_scene_find", [](O o) {
        uint32_t count;
        clq_actor found[4];
        return clq_scene_find(o.scene, nullptr, found, 4, &count);
    });
    read("clq_scene_find_keys", [](O o) {
        uint32_t count;
        clq_actor found[4];
        return clq_scene_find_keys(o.scene, 0, 9, nullptr, found, 4, &count);
    });
    read("clq_scene_find_next", [](O o) {
        clq_actor found;
        return clq_scene_find_next(o.scene, o.actor, false, nullptr, &found);
    });
    using Hits = clq_scene_hit[4];
    read("clq_scene_find_nearest", [](O o) {
        uint32_t count;
        Hits hits;
        return clq_scene_find_nearest(o.scene, 1, origin, HUGE_VAL, nullptr, hits, 4, &count);
    });
    read("clq_scene_find_within", [](O o) {
        uint32_t count;
        Hits hits;
        return clq_scene_find_within(o.scene, 1, origin, 9, nullptr, hits, 4, &count);
    });
    read("clq_scene_find_in_box", [](O o) {
        uint32_t count;
        Hits hits;
        return clq_scene_find_in_box(o.scene, 1, low, high, nullptr, hits, 4, &count);
    });
    read("clq_scene_find_in_frustum", [](O o) {
        uint32_t count;
        Hits hits;
        const clq_look_at_def def = clq_look_at_def_init();
        clq_camera camera;
        const clq_status status = clq_camera_look_at(&def, &camera);
        return status != CLQ_OK ? status : clq_scene_find_in_frustum(o.scene, 1, &camera, nullptr, hits, 4, &count);
    });
    read("clq_scene_find_on_ray", [](O o) {
        uint32_t count;
        Hits hits;
        return clq_scene_find_on_ray(o.scene, 1, &ray, nullptr, hits, 4, &count);
    });
    read("clq_scene_get_stats", [](O o) {
        clq_scene_stats stats = clq_scene_stats_init();
        return clq_scene_get_stats(o.scene, &stats);
    });
    add(Use::reads_view, "clq_scene_pick_triangle", [](O o) {
        clq_scene_pick pick = clq_scene_pick_init();
        return clq_scene_pick_triangle(o.scene, o.view, &ray, nullptr, &pick);
    });
}

}  // namespace busy
