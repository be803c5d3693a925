// Random calls for scenes: what is asked and given, while all else happens to their crowd.
#include <algorithm>
#include <cmath>

#include "tests/api/calls.h"
#include "tests/api/fuzz_world.h"

namespace fuzz
{

void World::new_scene()
{
    if (scenes_.size() > 1) return;
    clq_scene *made = nullptr;
    if (call("clq_scene_create", [&] { return clq_scene_create(crowd_, &made); })) scenes_.push_back(made);
}

void World::end_scene()
{
    if (scenes_.empty()) {
        EXPECT_EQ(clq_scene_destroy(nullptr), CLQ_OK);
        return;
    }
    const uint32_t which = random_.below(static_cast<uint32_t>(scenes_.size()));
    clq_scene_destroy(scenes_[which]);
    scenes_.erase(scenes_.begin() + which);
}

void World::tell_scene()
{
    if (scenes_.empty()) return;
    clq_scene *scene = scenes_[random_.below(static_cast<uint32_t>(scenes_.size()))];
    clq_actor ids[3];
    double keys[3];
    const uint32_t count = random_.below(4);
    for (uint32_t i = 0; i < count; ++i) ids[i] = person(), keys[i] = random_.odd(0, 9, 5);
    call("clq_scene_set_categories",
         [&] { return clq_scene_set_categories(scene, ids, count, uint64_t(1) << random_.below(64)); });
    call("clq_scene_set_keys", [&] { return clq_scene_set_keys(scene, ids, keys, count); });
    const double time_s = random_.odd(time_s_, time_s_, 25);
    call("clq_scene_update", [&] { return clq_scene_update(scene, time_s); });
}

clq_scene_filter World::any_filter()
{
    clq_scene_filter filter = clq_scene_filter_init();
    if (random_.one_in(4)) filter.tmpl = templates_[random_.below(4)];
    if (random_.one_in(6)) filter.texture_set = random_.index(2);
    if (random_.one_in(6)) filter.level = random_.index(2);
    if (random_.one_in(6)) filter.any_of = random_.number();
    if (random_.one_in(9)) filter.all_of = uint64_t(1) << random_.below(64);
    if (random_.one_in(6)) filter.none_of = random_.number();
    if (random_.one_in(60)) filter.struct_bytes = random_.index(200, 3);
    return filter;
}

void World::ask_scene()
{
    if (scenes_.empty()) return;
    const clq_scene *scene = scenes_[random_.below(static_cast<uint32_t>(scenes_.size()))];
    const clq_scene_filter filter = any_filter();
    clq_actor found[8];
    uint32_t count = 0;
    const uint32_t room = random_.below(9);
    if (call("clq_scene_find", [&] { return clq_scene_find(scene, &filter, found, room, &count); })) {
        EXPECT_LE(count, known_.actors.size()) << "seed " << seed_ << ", step " << step_;
        clq_actor_info info = clq_actor_info_init();
        for (uint32_t i = 0; i < std::min(count, room); ++i)
            EXPECT_EQ(clq_actor_get_info(crowd_, found[i], &info), CLQ_OK) << "it is alive";
    }
    const double low = random_.odd(0, 9), high = random_.odd(0, 9);
    call("clq_scene_find_keys", [&] { return clq_scene_find_keys(scene, low, high, &filter, found, room, &count); });
    const clq_actor id = person();
    call("clq_scene_find_next", [&] { return clq_scene_find_next(scene, id, random_.one_in(2), &filter, &found[0]); });
    clq_scene_actor known = clq_scene_actor_init();
    const double time_s = random_.odd(time_s_, time_s_ + 1, 9);
    call("clq_scene_get_actor", [&] { return clq_scene_get_actor(scene, id, time_s, &known); });
    clq_scene_stats stats = clq_scene_stats_init();
    ASSERT_EQ(clq_scene_get_stats(scene, &stats), CLQ_OK);
}

void World::ask_places()
{
    if (scenes_.empty()) return;
    const clq_scene *scene = scenes_[random_.below(static_cast<uint32_t>(scenes_.size()))];
    const clq_scene_filter filter = any_filter();
    clq_scene_hit hits[8];
    uint32_t count = 0, all = 0;
    const uint32_t room = random_.below(9);
    const double time_s = random_.odd(time_s_, time_s_ + 1, 9), size = random_.odd(0, 40);
    const double point[3] = {random_.odd(-20, 20), random_.odd(0, 2), random_.odd(-20, 0)};
    const double high[3] = {point[0] + size, point[1] + size, point[2] + size};
    const bool good = call("clq_scene_find_within", [&] {
        return clq_scene_find_within(scene, time_s, point, size, &filter, hits, room, &all);
    });
    if (call("clq_scene_find_nearest",
             [&] { return clq_scene_find_nearest(scene, time_s, point, size, &filter, hits, room, &count); })) {
        EXPECT_TRUE(good);
        EXPECT_EQ(count, std::min(all, room)) << "seed " << seed_ << ", step " << step_;
    }
    call("clq_scene_find_in_box",
         [&] { return clq_scene_find_in_box(scene, time_s, point, high, &filter, hits, room, &count); });
    clq_look_at_def def = clq_look_at_def_init();
    for (int k = 0; k < 3; ++k) def.eye[k] = point[k], def.target[k] = random_.odd(-20, 20);
    clq_camera camera = {};
    if (call("clq_camera_look_at", [&] { return clq_camera_look_at(&def, &camera); })) {
        call("clq_scene_find_in_frustum",
             [&] { return clq_scene_find_in_frustum(scene, time_s, &camera, &filter, hits, room, &count); });
    }
    clq_ray ray = {{point[0], point[1], point[2]}, {0, random_.odd(-0.1, 0.1), random_.odd(-1, 1)}, 2 * size};
    clq_actor_info seen = clq_actor_info_init();
    if (random_.one_in(4))
        call("clq_camera_get_ray",
             [&] { return clq_camera_get_ray(&camera, random_.oddf(-1, 1), random_.oddf(-1, 1), &ray); });
    else if (clq_actor_get_info(crowd_, person(), &seen) == CLQ_OK)
        for (int k = 0; k < 3; ++k) ray.direction[k] = seen.root.position[k] + 0.7 * (k == 1) - point[k];
    call("clq_scene_find_on_ray",
         [&] { return clq_scene_find_on_ray(scene, time_s, &ray, &filter, hits, room, &count); });
    if (views_.empty()) return;
    const clq_view *view = random_.one_in(20) ? strange_view_ : views_[random_.below(uint32_t(views_.size()))];
    clq_scene_pick pick = clq_scene_pick_init();
    if (call("clq_scene_pick_triangle", [&] { return clq_scene_pick_triangle(scene, view, &ray, &filter, &pick); }) &&
        pick.actor.index1 != 0) {
        clq_actor_info info = clq_actor_info_init();
        EXPECT_EQ(clq_actor_get_info(crowd_, pick.actor, &info), CLQ_OK) << "seed " << seed_ << ", step " << step_;
        EXPECT_GE(pick.distance, 0);
        ++picked_;
    }
}

}  // namespace fuzz
