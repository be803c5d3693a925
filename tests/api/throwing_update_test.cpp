// Callbacks of an update that throw: no exception leaves claque, and what the last update left is there as it was.
#include <cmath>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/seen_bytes.h"
#include "tests/api/test_world.h"
#include "tests/api/throwing_host.h"

namespace
{

using throwing::Host;
using throwing::Kind;
using throwing::Moment;

struct Variant {
    const char *name;
    clq_crowd_def def;
};

clq_crowd_def def_of(clq_cache_mode cache)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.cache = cache;
    return def;
}

std::vector<Variant> variants()
{
    std::vector<Variant> all = {
        {"full", def_of(CLQ_CACHE_FULL)},         {"palettes", def_of(CLQ_CACHE_ANIMATION)},
        {"nothing kept", def_of(CLQ_CACHE_NONE)}, {"hardly any room", def_of(CLQ_CACHE_FULL)},
        {"key-poses", def_of(CLQ_CACHE_FULL)},    {"hardly any key-poses", def_of(CLQ_CACHE_FULL)},
        {"traditional", def_of(CLQ_CACHE_NONE)}};
    all[3].def.cache_budget_bytes = 20000;
    for (const int k : {4, 5}) {
        clq_key_poses &poses = all[static_cast<size_t>(k)].def.key_poses;
        poses.bands[0].distance_min_m = 1;
        poses.bands[0].mode = CLQ_KEY_POSE_INTERPOLATED;
        poses.band_count = 1;
        poses.max_kept = k == 4 ? 64 : 2;
    }
    all[6].def.cull = CLQ_CULL_TRADITIONAL;
    for (const uint64_t bytes : {3000, 6000, 10000, 40000}) {
        all.push_back({"little room", def_of(CLQ_CACHE_FULL)});
        all.back().def.cache_budget_bytes = bytes;
    }
    return all;
}

// A crowd on a host that may throw, with two views.
class Stage
{
public:
    Stage(const clq_crowd_def &wanted, bool threads)
    {
        const clq_context_def context = host.context_def(threads);
        world = std::make_unique<TestWorld>(&context);
        clq_crowd_def def = wanted;
        def.now_s = Host::now_s, def.now_user = &host;
        crowd = world->new_crowd(&def);
        world->set_up(crowd);
        actors = world->fill(crowd, 60, 5);
        for (uint32_t k = 0; k < 2; ++k) {
            clq_mechanism_def mechanism = world->mechanism(TestWorld::host);
            mechanism.host = {k ? Host::remember : Host::move, &host, k == 1};
            clq_mechanism made;
            EXPECT_EQ(clq_crowd_add_mechanism(crowd, &mechanism, &made), CLQ_OK) << clq_last_error();
            mechanisms[k] = made;
        }
        EXPECT_EQ(clq_crowd_set_ground(crowd, Host::height, &host), CLQ_OK);
        for (size_t i = 0; i < actors.size(); ++i) {
            if (i % 3 == 0) clq_actor_follow_ground(crowd, actors[i], 0.3f, 0.3f);
            if (i % 2 == 0)
                clq_actor_attach_mechanism(crowd, actors[i], attachment(0));  // not those of the other template
            if (i % 6 == 0) clq_actor_attach_mechanism(crowd, actors[i], attachment(1));
        }
        views[0] = world->new_view(crowd, -3), views[1] = world->new_view(crowd, 9);
    }

    const clq_mechanism_attachment *attachment(uint32_t k)
    {
        attachment_ = {mechanisms[k], 2, 0, 0};
        return &attachment_;
    }

    clq_status update(double time_s) { return clq_crowd_update(crowd, time_s, views, 2); }
    void change(uint32_t first)
    {
        for (uint32_t step = first; step < first + 30; ++step) world->happen(crowd, actors, 9, step);
    }
    // Some individuals leave the pictures and others enter: their memory is sought while lists still show the former.
    void turn(bool aside)
    {
        for (int k = 0; k < 2; ++k) {
            clq_camera camera;
            const double eye[3] = {k ? 9.0 : -3.0, 2, 4}, target[3] = {aside ? (k ? 24.0 : -18.0) : 0.0, 1, -10};
            const float up[3] = {0, 1, 0};
            ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.5f, 1.3f, 0.1f, 200), CLQ_OK);
            ASSERT_EQ(clq_view_set_camera(views[k], &camera), CLQ_OK);
        }
    }

    Host host;
    std::unique_ptr<TestWorld> world;
    clq_crowd *crowd = nullptr;
    std::vector<clq_actor> actors;
    clq_mechanism mechanisms[2] = {};
    clq_view *views[2] = {nullptr, nullptr};

private:
    clq_mechanism_attachment attachment_ = {};
};

// Everything that a host can see of a crowd after an update.
std::string seen(const Stage &stage)
{
    api_test::SeenBytes all;
    const auto add = [&all](const auto &value) { all.add(value); };
    add(clq_crowd_get_hash(stage.crowd));
    clq_crowd_stats stats = clq_crowd_stats_init();
    EXPECT_EQ(clq_crowd_get_stats(stage.crowd, &stats), CLQ_OK);
    stats.actor_bytes = 0;
    add(stats);
    for (const clq_actor actor : stage.actors) {
        clq_actor_info info = clq_actor_info_init();
        EXPECT_EQ(clq_actor_get_info(stage.crowd, actor, &info), CLQ_OK) << clq_last_error();
        add(info);
        double matrix[16];
        EXPECT_EQ(clq_actor_get_node(stage.crowd, actor, 1, std::nan(""), matrix), CLQ_OK) << clq_last_error();
        add(matrix);
    }
    for (clq_view *view : stage.views) {
        add(clq_view_get_hash(view));
        clq_view_stats counts = clq_view_stats_init();
        EXPECT_EQ(clq_view_get_stats(view, &counts), CLQ_OK);
        counts.bytes = 0;
        add(counts);
        for (uint32_t i = 0; i < counts.visible; ++i) {
            float vertices[64 * 3] = {}, palette[64 * 12] = {};
            EXPECT_EQ(clq_view_get_vertices(view, i, vertices, nullptr, 64), CLQ_OK) << clq_last_error();
            if (clq_view_get_palette(view, i, palette, 64) == CLQ_OK) add(palette);
            add(vertices);
        }
    }
    return all.all;
}

std::string pictures(const Stage &stage)
{
    return std::to_string(clq_view_get_hash(stage.views[0])) + " " + std::to_string(clq_view_get_hash(stage.views[1]));
}

// Lets every call of a kind throw, in one update each, and compares with a crowd in which none did.
void throw_in_each_call(Kind kind, const Variant &variant)
{
    SCOPED_TRACE(variant.name);
    Stage stage(variant.def, true), calm(variant.def, false);
    uint64_t failures = 0;
    for (uint32_t round = 0; round < 2; ++round) {
        const double time_s = 2 + 0.4 * round;
        stage.turn(round == 0), calm.turn(round == 0);
        ASSERT_EQ(stage.update(time_s), CLQ_OK) << clq_last_error();
        ASSERT_EQ(calm.update(time_s), CLQ_OK);
        stage.change(40 * round), calm.change(40 * round);
        stage.turn(round == 1), calm.turn(round == 1);
        const std::string before = seen(stage);
        for (uint64_t n = 1;; ++n) {
            stage.host.arm(kind, n);
            const clq_status status = stage.update(time_s + 0.3);
            const uint64_t calls = stage.host.disarm();
            if (calls < n) {
                ASSERT_EQ(status, CLQ_OK) << clq_last_error();
                break;
            }
            ++failures;
            ASSERT_EQ(status, CLQ_CALLBACK) << n << ": " << clq_last_error();
            ASSERT_NE(std::strstr(clq_last_error(), throwing::words), nullptr) << clq_last_error();
            ASSERT_EQ(calls, n) << "no callback follows one that threw";
            ASSERT_EQ(seen(stage), before) << "call " << n;
        }
        ASSERT_EQ(calm.update(time_s + 0.3), CLQ_OK);
        EXPECT_EQ(pictures(stage), pictures(calm)) << "failures on the way changed what is shown";
    }
    EXPECT_GT(failures, 5u) << "this test saw nothing";
}

TEST(ThrowingUpdate, AGroundThatThrowsFailsTheUpdateAndChangesNothing)
{
    for (const Variant &variant : variants()) throw_in_each_call(Kind::ground, variant);
}

TEST(ThrowingUpdate, AMechanismThatThrowsFailsTheUpdateAndChangesNothing)
{
    for (const Variant &variant : variants()) throw_in_each_call(Kind::mechanism, variant);
}

TEST(ThrowingUpdate, AMechanismWithMemoryThatThrowsFailsTheUpdateAndChangesNothing)
{
    for (const Variant &variant : variants()) throw_in_each_call(Kind::memory, variant);
}

TEST(ThrowingUpdate, TheCallsThatThrowingTasksLeaveOutAreMadeAllTheSame)
{
    for (const bool threads : {false, true})
        for (const Moment moment : {Moment::before, Moment::half, Moment::after}) {
            Stage stage(clq_crowd_def_init(), threads), calm(clq_crowd_def_init(), false);
            uint64_t calls = 1;
            for (uint64_t n = 1; n <= calls; ++n) {
                const double time_s = 2 + 0.1 * static_cast<double>(n);
                stage.host.last_log.clear();
                stage.host.arm(Kind::tasks, n, moment);
                ASSERT_EQ(stage.update(time_s), CLQ_OK) << clq_last_error();
                calls = stage.host.disarm();
                if (calls >= n) {
                    ASSERT_NE(stage.host.last_log.find("tasks.run threw an exception: thrown on purpose"),
                              std::string::npos)
                        << stage.host.last_log;
                }
                ASSERT_EQ(calm.update(time_s), CLQ_OK);
                ASSERT_EQ(pictures(stage), pictures(calm)) << "call " << n << " of " << calls;
            }
            EXPECT_GE(calls, 3u) << "poses, spheres, vertices";
        }
}

TEST(ThrowingUpdate, AClockThatThrowsIsReportedAndTheUpdateGoesOn)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.clock = CLQ_CLOCK_LIVE, def.update_budget_ms = 1000;
    Stage stage(def, false), calm(def, false);
    uint64_t calls = 1;
    for (uint64_t n = 1; n <= calls; ++n) {
        const double time_s = 2 + 0.1 * static_cast<double>(n);
        stage.host.last_log.clear();
        stage.host.arm(Kind::clock, n);
        ASSERT_EQ(stage.update(time_s), CLQ_OK) << clq_last_error();
        calls = std::max(calls, stage.host.disarm());
        if (n == 1) calls = 4;  // a clock that threw is not read again
        EXPECT_NE(stage.host.last_log.find("now_s threw an exception: thrown on purpose"), std::string::npos);
        ASSERT_EQ(calm.update(time_s), CLQ_OK);
        ASSERT_EQ(pictures(stage), pictures(calm)) << "call " << n;
    }
}

TEST(ThrowingUpdate, AnAllocatorThatThrowsRefuses)
{
    Stage stage(clq_crowd_def_init(), true);
    ASSERT_EQ(stage.update(2), CLQ_OK);
    stage.world->fill(stage.crowd, 100, 8);  // so that the update must make room
    const std::string before = seen(stage);
    uint64_t failures = 0;
    for (uint64_t n = 1;; ++n) {
        stage.host.arm(Kind::allocate, n);
        const clq_status status = stage.update(2.5);
        if (stage.host.disarm() < n) break;
        if (status == CLQ_OK) continue;  // it could do without
        ++failures;
        ASSERT_EQ(status, CLQ_OUT_OF_MEMORY) << clq_last_error();
        ASSERT_EQ(seen(stage), before) << n;
    }
    EXPECT_GT(failures, 0u);
}

TEST(ThrowingUpdate, AReleaseThatThrowsIsIgnored)
{
    uint64_t calls = 1;
    for (uint64_t n = 1; n <= calls; n += 1 + n / 8) {
        clq_crowd_def def = clq_crowd_def_init();
        def.cache_budget_bytes = 20000;
        Stage stage(def, true), calm(def, false);
        stage.host.arm(Kind::release, n);
        ASSERT_EQ(stage.update(2), CLQ_OK);
        stage.change(0), calm.change(0);
        ASSERT_EQ(stage.update(3), CLQ_OK);
        ASSERT_EQ(calm.update(2), CLQ_OK);
        ASSERT_EQ(calm.update(3), CLQ_OK);
        EXPECT_EQ(pictures(stage), pictures(calm));
        EXPECT_EQ(clq_view_destroy(stage.views[1]), CLQ_OK);
        EXPECT_EQ(clq_crowd_destroy(stage.crowd), CLQ_OK);
        stage.world->crowds.clear();
        calls = stage.host.disarm();
    }
    EXPECT_GT(calls, 5u);
}

}  // namespace
