// The crowd through the C API: what is shown depends on calls, time and views, and not on threads or caches.
#include <claque/claque.h>

#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

struct Workers {
    unsigned count = 1;
};

void run_on_threads(void *user, uint32_t count, void (*job)(void *, uint32_t), void *data)
{
    std::atomic<uint32_t> next{0};
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < static_cast<Workers *>(user)->count; ++t)
        threads.emplace_back([&] {
            for (uint32_t i = next++; i < count; i = next++) job(data, i);
        });
    for (std::thread &thread : threads) thread.join();
}

// A crowd of strips in rows, with one camera.
class Strips
{
public:
    explicit Strips(clq_crowd_def def = clq_crowd_def_init(), unsigned threads = 1)
    {
        clq_context_def context_def = clq_context_def_init();
        workers_.count = threads;
        if (threads > 1) context_def.tasks = {&workers_, run_on_threads};
        EXPECT_EQ(clq_context_create(&context_def, &context), CLQ_OK);
        EXPECT_EQ(clq_template_build(context, &small_.def, &tmpl), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_create(context, &def, &crowd), CLQ_OK) << clq_last_error();
        for (int i = 0; i < 300; ++i) {
            clq_actor_def actor_def = clq_actor_def_init();
            actor_def.tmpl = tmpl;
            actor_def.transform.position[0] = (i % 20 - 9.5) * 0.8;
            actor_def.transform.position[2] = -(i / 20) * 4.0;
            actor_def.play.clip = 0;
            actor_def.play.speed = 1 + 0.01f * static_cast<float>(i % 7);
            actor_def.play.phase_s = 0.05f * static_cast<float>(i % 19);
            actor_def.seed = static_cast<uint64_t>(i);
            clq_actor actor;
            EXPECT_EQ(clq_actor_create(crowd, &actor_def, &actor), CLQ_OK);
            EXPECT_EQ(clq_actor_randomise_colours(crowd, actor, nullptr, 0), CLQ_OK);
            actors.push_back(actor);
        }
        EXPECT_EQ(clq_view_create(crowd, &view), CLQ_OK);
        look(0);
    }
    ~Strips()
    {
        clq_crowd_destroy(crowd);
        clq_template_destroy(tmpl);
        EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
    }
    void look(double x)
    {
        clq_camera camera;
        const double eye[3] = {x, 1.5, 6}, target[3] = {0, 1, -20};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.8f, 1.33f, 0.1f, 200), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view, &camera), CLQ_OK);
    }
    uint64_t at(double time_s)
    {
        EXPECT_EQ(clq_crowd_update(crowd, time_s, &view, 1), CLQ_OK) << clq_last_error();
        return clq_view_get_hash(view);
    }
    clq_crowd_stats stats() const
    {
        clq_crowd_stats out = clq_crowd_stats_init();
        EXPECT_EQ(clq_crowd_get_stats(crowd, &out), CLQ_OK);
        return out;
    }

    clq_context *context = nullptr;
    clq_template *tmpl = nullptr;
    clq_crowd *crowd = nullptr;
    clq_view *view = nullptr;
    std::vector<clq_actor> actors;

private:
    SmallTemplate small_;
    Workers workers_;
};

clq_crowd_def with(clq_cache_mode cache, uint64_t budget_bytes)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.cache = cache;
    def.cache_budget_bytes = budget_bytes;
    return def;
}

}  // namespace

TEST(Crowd, AFrameByItselfIsTheFrameOfASequence)
{
    Strips sequence, alone;
    uint64_t last = 0;
    for (int frame = 0; frame <= 50; ++frame) last = sequence.at(frame / 25.0);
    EXPECT_EQ(alone.at(2.0), last);
    EXPECT_NE(alone.at(2.3), last) << "a hash that never changes would pass above";
    EXPECT_EQ(alone.at(2.0), last) << "time may go back";
}

TEST(Crowd, ThreadsAndCachesChangeTheCostAndNotTheList)
{
    Strips reference;
    const uint64_t full_hash = reference.at(0.5);
    const uint64_t later = reference.at(0.9);
    for (const unsigned threads : {2u, 4u}) {
        Strips other(clq_crowd_def_init(), threads);
        EXPECT_EQ(other.at(0.5), full_hash) << threads << " threads";
        EXPECT_EQ(other.at(0.9), later) << threads << " threads";
    }
    for (const clq_cache_mode cache : {CLQ_CACHE_ANIMATION, CLQ_CACHE_NONE}) {
        Strips other(with(cache, 0));
        EXPECT_EQ(other.at(0.5), full_hash) << "cache mode " << cache;
        EXPECT_EQ(other.at(0.9), later) << "cache mode " << cache;
    }
    for (const uint64_t budget : {1ull, 20000ull, 60000ull}) {
        Strips other(with(CLQ_CACHE_FULL, budget));
        EXPECT_EQ(other.at(0.5), full_hash) << budget << " bytes";
        EXPECT_EQ(other.at(0.9), later) << budget << " bytes";
        EXPECT_LE(other.stats().cache_bytes, budget);
        EXPECT_GT(other.stats().on_demand, 0u);
    }
}

TEST(Crowd, TheCacheServesActorsThatAreNotDue)
{
    Strips strips;
    strips.at(1.0);
    EXPECT_GT(strips.stats().visible, 100u);
    EXPECT_EQ(strips.stats().animated, strips.stats().visible) << "all actors are new";
    strips.at(1.0 + 1 / 60.0);
    const clq_crowd_stats second = strips.stats();
    EXPECT_LT(second.animated, second.visible) << "a sixtieth of a second later most are not due";
    EXPECT_EQ(second.animated + second.palette_served, second.visible);
    strips.at(1.0 + 1 / 60.0);
    EXPECT_EQ(strips.stats().animated, 0u);
    EXPECT_EQ(strips.stats().skinned, 0u);
    EXPECT_EQ(strips.stats().vertices_served, strips.stats().visible);
    Strips none(with(CLQ_CACHE_NONE, 0));
    none.at(1.0), none.at(1.0);
    EXPECT_EQ(none.stats().animated, none.stats().visible);
}

TEST(Crowd, ActorsOutOfViewAreNotAnimatedAndAreInTimeOnReturn)
{
    Strips strips, other;
    clq_camera away;
    const double eye[3] = {0, 1.5, 6}, target[3] = {0, 1, 60};
    const float up[3] = {0, 1, 0};
    ASSERT_EQ(api_test::look_at(&away, eye, target, up, 0.8f, 1.33f, 0.1f, 200), CLQ_OK);
    ASSERT_EQ(clq_view_set_camera(strips.view, &away), CLQ_OK);
    strips.at(0.5);
    EXPECT_EQ(strips.stats().visible, 0u);
    EXPECT_EQ(strips.stats().animated, 0u);
    strips.look(0);
    EXPECT_EQ(strips.at(1.7), other.at(1.7));
}

TEST(Crowd, ChangesOfSettingsShowAtOnce)
{
    Strips strips;
    const uint64_t before = strips.at(1.0);
    const float red[6] = {1, 0, 0, 1, 0, 0};
    ASSERT_EQ(clq_actor_set_colours(strips.crowd, strips.actors[5], red, 2), CLQ_OK);
    const uint64_t recoloured = strips.at(1.0);
    EXPECT_NE(recoloured, before);
    const clq_play rest = {CLQ_NONE, 0, 1, 0};
    ASSERT_EQ(clq_actor_play(strips.crowd, strips.actors[5], &rest), CLQ_OK);
    EXPECT_NE(strips.at(1.0), recoloured);
    ASSERT_EQ(clq_actor_destroy(strips.crowd, strips.actors[5]), CLQ_OK);
    const uint32_t visible = strips.stats().visible;
    strips.at(1.0);
    EXPECT_EQ(strips.stats().visible, visible - 1);
}

TEST(Crowd, ADestroyedActorLeavesNothingOfItsPosesToTheNext)
{
    Strips used, fresh;
    used.at(1.0);  // so that row 7 has cached poses
    for (Strips *strips : {&used, &fresh}) {
        clq_actor_info info = clq_actor_info_init();
        ASSERT_EQ(clq_actor_get_info(strips->crowd, strips->actors[7], &info), CLQ_OK);
        ASSERT_EQ(clq_actor_destroy(strips->crowd, strips->actors[7]), CLQ_OK);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = strips->tmpl, def.transform = info.transform, def.play = info.play, def.seed = info.seed;
        def.play.phase_s += 0.4f;
        clq_actor actor;
        ASSERT_EQ(clq_actor_create(strips->crowd, &def, &actor), CLQ_OK);
        ASSERT_EQ(clq_actor_randomise_colours(strips->crowd, actor, nullptr, 0), CLQ_OK);
    }
    EXPECT_EQ(used.at(1.0), fresh.at(1.0));
}

TEST(Crowd, AnIndividualCostsAtMost512BytesBesidesItsCaches)
{
    Strips strips;
    strips.at(1.0);
    EXPECT_LE(strips.stats().actor_bytes / strips.stats().actor_count, 512u);
}

TEST(Crowd, SeveralViewsShareOneUpdate)
{
    Strips strips;
    clq_view *second = nullptr;
    ASSERT_EQ(clq_view_create(strips.crowd, &second), CLQ_OK);
    clq_camera camera;
    const double eye[3] = {20, 1.5, -20}, target[3] = {0, 1, -20};
    const float up[3] = {0, 1, 0};
    ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.8f, 1.33f, 0.1f, 200), CLQ_OK);
    ASSERT_EQ(clq_view_set_camera(second, &camera), CLQ_OK);
    clq_view *const views[2] = {strips.view, second};
    ASSERT_EQ(clq_crowd_update(strips.crowd, 1.0, views, 2), CLQ_OK) << clq_last_error();
    clq_view_stats a = clq_view_stats_init(), b = clq_view_stats_init();
    ASSERT_EQ(clq_view_get_stats(strips.view, &a), CLQ_OK);
    ASSERT_EQ(clq_view_get_stats(second, &b), CLQ_OK);
    EXPECT_GT(a.visible, 0u);
    EXPECT_GT(b.visible, 0u);
    EXPECT_EQ(strips.stats().animated, strips.stats().visible) << "no actor is animated twice";
    ASSERT_EQ(clq_crowd_update(strips.crowd, 1.0, views, 1), CLQ_OK);
    ASSERT_EQ(clq_view_get_stats(second, &b), CLQ_OK);
    EXPECT_EQ(b.visible, 0u) << "a view that was not updated has an empty list";
}

TEST(Crowd, AThousandKilometresAwayActorsLookTheSame)
{
    Strips near_by, far_off;
    std::vector<clq_transform> places;
    for (const clq_actor &actor : far_off.actors) {
        clq_actor_info info = clq_actor_info_init();
        ASSERT_EQ(clq_actor_get_info(far_off.crowd, actor, &info), CLQ_OK);
        info.transform.position[0] += 1048576, info.transform.position[2] += 1048576;
        places.push_back(info.transform);
    }
    ASSERT_EQ(clq_crowd_set_transforms(far_off.crowd, far_off.actors.data(), places.data(),
                                       static_cast<uint32_t>(places.size())),
              CLQ_OK);
    clq_camera camera;
    const double eye[3] = {1048576, 1.5, 1048576 + 6}, target[3] = {1048576, 1, 1048576 - 20};
    const float up[3] = {0, 1, 0};
    ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.8f, 1.33f, 0.1f, 200), CLQ_OK);
    ASSERT_EQ(clq_view_set_camera(far_off.view, &camera), CLQ_OK);
    near_by.at(1.0), far_off.at(1.0);
    EXPECT_EQ(near_by.stats().visible, far_off.stats().visible);
    EXPECT_EQ(near_by.stats().animated, far_off.stats().animated);
}
