// The counters of updates against what is counted one by one, where everything is in view and nothing crosses an edge.
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "tests/actors/robot.h"

using namespace actors;

namespace
{

constexpr uint32_t robots = 300;

// Robots at all distances up to 95 m in the middle of the picture; some in groups, of which the last is disabled.
void stand_in_view(World &world)
{
    std::vector<crowd::Id> groups;
    for (uint32_t g = 0; g < 3; ++g) groups.push_back(crowd::create_group(world.crowd, crowd::Transform()));
    for (uint32_t i = 0; i < robots; ++i) {
        const double away = 5 + 0.3 * i;
        const crowd::Id id = world.add({0.2 * away * (random_unit(1, i) - 0.5), 0, -away}, float(i), i);
        if (i % 4 == 0) crowd::join(world.crowd, id, groups[i / 4 % 3], nullptr);
    }
    crowd::enable_group(world.crowd, groups[2], false);
}

bool is_shown(uint32_t i) { return i % 4 != 0 || i / 4 % 3 != 2; }

uint64_t nodes_of(const World &world, crowd::Id id)
{
    const model::Level &level = world.tmpl->levels[world.seen(id).level];
    return level.active.empty() ? world.tmpl->rig.node_count() : level.nodes.size();
}

struct FakeClock {
    double reads = 0;
    static double now(void *user) { return static_cast<FakeClock *>(user)->reads += 1; }
};

}  // namespace

TEST(Stats, AreWhatIsCountedOneByOne)
{
    for (const animcache::RigidMode mode : {animcache::RigidMode::vertices, animcache::RigidMode::matrices})
        for (const uint32_t views : {1u, 2u}) {
            frame::Settings settings;
            settings.rigid_mode = mode;
            World world(settings);
            stand_in_view(world);
            for (uint32_t v = 0; v < views; ++v) world.look({0.1 * v, 1.7, 0}, {0, 1, -30});
            std::set<uint64_t> counts;
            for (int frame = 0; frame < 4; ++frame) {
                world.update(0.3 * frame);
                uint32_t shown = 0;
                uint64_t nodes = 0;
                for (uint32_t i = 0; i < robots; ++i) {
                    ASSERT_EQ(world.seen(world.ids[i]).visible, is_shown(i)) << i;
                    if (!is_shown(i)) continue;
                    ++shown, nodes += nodes_of(world, world.ids[i]);
                    counts.insert(nodes_of(world, world.ids[i]));
                }
                const frame::Stats &stats = world.frame.stats();
                EXPECT_EQ(stats.groups, 3u);
                EXPECT_EQ(stats.groups_visible, 2u);
                EXPECT_EQ(stats.tested, shown);
                EXPECT_EQ(stats.passed_refpoint, shown);
                EXPECT_EQ(stats.passed_sklsroot, shown);
                EXPECT_EQ(stats.roots_placed, shown);
                EXPECT_EQ(stats.visible, shown);
                EXPECT_EQ(stats.crossing, 0u);
                EXPECT_EQ(stats.spheres_built, 0u);
                EXPECT_EQ(stats.sphere_tests, 2 * views * shown) << "the first and the second phase";
                EXPECT_EQ(stats.distances, views * shown);
                EXPECT_EQ(stats.matrices_needed, nodes);
                EXPECT_EQ(stats.products, nodes);
                EXPECT_EQ(stats.products_tracked, mode == animcache::RigidMode::vertices ? nodes : 0);
                for (const auto &view : world.views) EXPECT_EQ(view->list.items.size(), shown);
            }
            EXPECT_EQ(counts.size(), 3u) << "all levels of detail are seen";
        }
}

TEST(Stats, OfBandsAreThoseOfTheDistancesThatUpdatesSaw)
{
    World world;
    stand_in_view(world);
    world.look({0, 1.7, 0}, {0, 1, -30});
    const frame::Stats &stats = world.frame.stats();
    const animcache::Settings &caches = world.frame.settings().caches;
    for (uint32_t k = 0; k < frame::band_count; ++k) {
        const double step = double(caches.period.d_far - caches.period.d_near) / 6;
        EXPECT_NEAR(stats.bands[k].distance_min, k == 0 ? 0 : double(caches.period.d_near) + step * (k - 1), 1e-4);
        if (k + 1 < frame::band_count) {
            EXPECT_EQ(stats.bands[k].distance_max, stats.bands[k + 1].distance_min);
        }
    }
    frame::Band wanted[frame::band_count];
    uint64_t posed = 0, posed_in_bands = 0;
    std::set<uint32_t> before;
    double last_s = 0;
    // A time that passes, one that stands, one that goes back, jumps of just below a second and of one.
    for (const double time_s : {1.0, 1.25, 1.25, 1.5, 0.5, 0.75, 1.6875, 2.6875, 2.75}) {
        if (time_s == 1.5) world.views[0]->camera.eye.z = -30;  // some are behind the eye now
        if (time_s == 0.75) world.views[0]->camera.eye.z = 0;
        world.update(time_s);
        const double elapsed_s = time_s - last_s;
        const bool counts = elapsed_s > 0 && elapsed_s < 1 && !before.empty();
        std::set<uint32_t> now;
        for (uint32_t i = 0; i < robots; ++i) {
            const frame::ActorVisibility seen = world.seen(world.ids[i]);
            if (!seen.visible) continue;
            now.insert(i);
            uint32_t k = 0;
            for (uint32_t b = 1; b < frame::band_count; ++b)
                if (seen.distance >= stats.bands[b].distance_min) k = b;
            ++wanted[k].actor_frames;
            if (counts && before.count(i)) wanted[k].seconds += elapsed_s;
        }
        if (counts && now == before) posed += stats.animated;
        last_s = time_s, before = now;
    }
    for (uint32_t k = 0; k < frame::band_count; ++k) {
        EXPECT_EQ(stats.bands[k].actor_frames, wanted[k].actor_frames) << k;
        EXPECT_NEAR(stats.bands[k].seconds, wanted[k].seconds, 1e-9) << k;
        EXPECT_GT(wanted[k].seconds, 0) << k;
        posed_in_bands += stats.bands[k].animated;
    }
    EXPECT_GE(posed_in_bands, posed);
    EXPECT_GT(posed, 100u);
    world.frame.reset_bands();
    for (const frame::Band &band : stats.bands) {
        EXPECT_EQ(band.actor_frames + band.animated, 0u);
        EXPECT_EQ(band.seconds, 0);
    }
}

// Each step ends where the next one begins: by a clock that counts how often it is read.
TEST(Stats, OfStepsShareTheTimeOfTheUpdate)
{
    World world;
    stand_in_view(world);
    world.look({0, 1.7, 0}, {0, 1, -30});
    FakeClock clock;
    world.update(1);
    EXPECT_FALSE(world.frame.step_times().measured);
    world.frame.set_step_clock({FakeClock::now, &clock, {}});
    for (int frame = 0; frame < 3; ++frame) {
        clock.reads = 100;
        world.update(2 + frame);
        const frame::StepTimes times = world.frame.step_times();
        EXPECT_TRUE(times.measured);
        for (const double one : times.seconds) EXPECT_EQ(one, 1);
        EXPECT_EQ(clock.reads, 101 + double(frame::step_count));
    }
}

TEST(Lists, HoldTheColoursOfTheirItemsOneAfterTheOther)
{
    World world;
    stand_in_view(world);
    const float colours[3] = {0.1f, 0.4f, 0.9f};
    for (uint32_t i = 0; i < robots; i += 3) crowd::set_colours(world.crowd, world.ids[i], colours, 1);
    const frame::View &view = world.look({0, 1.7, 0}, {0, 1, -30});
    world.update(1);
    const uint8_t *next = view.colours.data();
    for (const draw::Item &item : view.list.items) {
        ASSERT_EQ(item.zone_rgb != nullptr, world.crowd.zone_rgb(item.actor_index) != nullptr);
        if (!item.zone_rgb) continue;
        EXPECT_EQ(item.zone_rgb, next);
        next += 3 * world.tmpl->zone_count();
    }
    EXPECT_EQ(next, view.colours.data() + view.colours.size());
    EXPECT_FALSE(view.colours.empty());
}

TEST(Stats, AreNoneBeforeTheFirstUpdate)
{
    World world;
    const frame::Stats &stats = world.frame.stats();
    EXPECT_EQ(stats.groups + stats.groups_visible + stats.tested + stats.passed_refpoint + stats.passed_sklsroot, 0u);
    EXPECT_EQ(stats.crossing + stats.sphere_tests + stats.spheres_built + stats.roots_placed + stats.distances, 0u);
    EXPECT_EQ(stats.matrices_needed + stats.products + stats.products_tracked + stats.visible + stats.frame_bytes, 0u);
    EXPECT_EQ(stats.due + stats.animated + stats.matrices_built + stats.skinned + stats.palette_served, 0u);
    EXPECT_EQ(stats.vertices_served + stats.on_demand + stats.left_out + stats.deferred + stats.overdue, 0u);
    EXPECT_EQ(stats.over_budget + stats.evicted + stats.cache_bytes + stats.cache_pool_bytes + stats.arena_bytes, 0u);
    for (const frame::Band &band : stats.bands) EXPECT_EQ(band.actor_frames + band.animated, 0u);
    EXPECT_FALSE(world.frame.step_times().measured);
    EXPECT_EQ(world.frame.last_time_s(), 0);
}

TEST(LiveClock, BindsNoActorThatItHasNotShown)
{
    frame::Settings settings;
    settings.clock = frame::Clock::live;
    World world(settings);
    stand_in_view(world);
    world.look({0, 1.7, 0}, {0, 1, -30});
    world.update(-7);
    for (uint32_t i = 0; i < robots; ++i)
        if (is_shown(i)) EXPECT_NEAR(world.seen(world.ids[i]).shown_s, -7, 0.5) << i;
}

// What moves away has longer periods, whose ticks may lie before the one that was shown.
TEST(LiveClock, BindsActorsFromTheFirstUpdateOn)
{
    frame::Settings settings;
    settings.clock = frame::Clock::live;
    World world(settings), reference;
    for (World *one : {&world, &reference}) {
        stand_in_view(*one);
        one->look({0, 1.7, 0}, {0, 1, -30});
        one->update(1);
    }
    std::vector<double> before;
    for (const crowd::Id id : world.ids) before.push_back(world.seen(id).shown_s);
    uint32_t earlier = 0;
    for (World *one : {&world, &reference}) one->views[0]->camera.eye.z = 60, one->update(1.0005);
    for (uint32_t i = 0; i < robots; ++i) {
        if (!is_shown(i)) continue;
        EXPECT_GE(world.seen(world.ids[i]).shown_s, before[i]) << i;
        earlier += reference.seen(reference.ids[i]).shown_s < before[i];
    }
    EXPECT_GT(earlier, 50u) << "by the reference clock some go back";
}
