// The citizen, its walk, tracks and crowds that follow them.
#pragma once

#include <claque/assets.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"

namespace walkers
{

struct Threads {
    static void run(void *user, uint32_t count, void (*task)(void *data, uint32_t index), void *data)
    {
        std::vector<std::thread> threads;
        const uint32_t n = *static_cast<uint32_t *>(user);
        for (uint32_t k = 0; k < n; ++k)
            threads.emplace_back([=] {
                for (uint32_t i = k; i < count; i += n) task(data, i);
            });
        for (std::thread &thread : threads) thread.join();
    }
};

// A context, the citizen and its walk.
class Walkers : public testing::Test
{
protected:
    explicit Walkers(uint32_t threads = 1) : threads_(threads)
    {
        clq_context_def def = clq_context_def_init();
        def.tasks = {&threads_, Threads::run};
        EXPECT_EQ(clq_context_create(&def, &context_), CLQ_OK);
        EXPECT_EQ(clq_template_builtin(context_, "citizen", &citizen_), CLQ_OK) << clq_last_error();
        clq_locomotion_def walk = clq_locomotion_def_init();
        const uint32_t stand = clq_template_find_clip(citizen_, "stand");
        walk.tmpl = citizen_, walk.walk = clq_template_find_clip(citizen_, "walk");
        walk.run = clq_template_find_clip(citizen_, "jog"), walk.idle_count = 1, walk.idles = &stand;
        EXPECT_EQ(clq_locomotion_create(context_, &walk, &locomotion_), CLQ_OK) << clq_last_error();
    }
    ~Walkers() override
    {
        for (clq_track *track : tracks_) clq_track_destroy(track);
        for (clq_crowd *crowd : crowds_) clq_crowd_destroy(crowd);
        clq_locomotion_destroy(locomotion_);
        clq_template_destroy(citizen_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }

    // Along x at `speed`, a stand from the fifth to the eighth second, z metres away.
    clq_track *track(double speed, double z, double bend = 0)
    {
        std::vector<clq_track_point> points;
        for (int i = 0; i <= 160; ++i) {
            const double t = 0.1 * i, walked = std::min(t, 5.0) + std::max(0.0, t - 8);
            points.push_back({t, {speed * (walked - 6), 0, z + bend * std::sin(0.8 * walked)}, NAN});
        }
        clq_track_def def = clq_track_def_init();
        def.points = points.data(), def.point_count = static_cast<uint32_t>(points.size());
        clq_track *made = nullptr;
        EXPECT_EQ(clq_track_create(locomotion_, &def, &made), CLQ_OK) << clq_last_error();
        tracks_.push_back(made);
        return made;
    }
    clq_crowd *crowd(const clq_crowd_def *def = nullptr)
    {
        clq_crowd *made = nullptr;
        EXPECT_EQ(clq_crowd_create(context_, def, &made), CLQ_OK) << clq_last_error();
        crowds_.push_back(made);
        return made;
    }
    clq_actor walker(clq_crowd *crowd, clq_track *track, double start_s = 0)
    {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = citizen_;
        clq_actor made = {0, 0};
        EXPECT_EQ(clq_actor_create(crowd, &def, &made), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_actor_follow_track(crowd, made, track, start_s), CLQ_OK) << clq_last_error();
        return made;
    }
    static clq_view *view(clq_crowd *crowd, double z)
    {
        clq_view *made = nullptr;
        EXPECT_EQ(clq_view_create(crowd, &made), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1.5, z}, target[3] = {0, 1, 0};
        const float up[3] = {0, 1, 0};
        EXPECT_EQ(api_test::look_at(&camera, eye, target, up, 1.0472f, 1.333f, 0.1f, 400), CLQ_OK);
        EXPECT_EQ(clq_view_set_camera(made, &camera), CLQ_OK);
        return made;
    }
    static uint32_t visible(clq_view *view)
    {
        clq_view_stats stats = clq_view_stats_init();
        EXPECT_EQ(clq_view_get_stats(view, &stats), CLQ_OK);
        return stats.visible;
    }
    std::vector<double> place(clq_crowd *crowd, clq_actor actor, uint32_t node, double time_s)
    {
        double m[16] = {};
        EXPECT_EQ(clq_actor_get_node(crowd, actor, node, time_s, m), CLQ_OK) << clq_last_error();
        return {m[12], m[13], m[14]};
    }

    uint32_t threads_;
    clq_context *context_ = nullptr;
    clq_template *citizen_ = nullptr;
    clq_locomotion *locomotion_ = nullptr;
    std::vector<clq_track *> tracks_;
    std::vector<clq_crowd *> crowds_;
};

}  // namespace walkers
