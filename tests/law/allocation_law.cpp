// A failed allocation gives a status and leaves everything unchanged.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "support/scene.h"

namespace claque
{

using namespace testing_support;

namespace
{

SceneDef on(CountingMemory &memory)
{
    SceneDef def;
    def.memory = &memory;
    def.actors = 30;
    return def;
}

}  // namespace

TEST(AllocationLaw, AnUpdateThatIsRefusedMemoryChangesNothing)
{
    CountingMemory plain;
    Scene undisturbed(on(plain));
    const uint64_t first = undisturbed.update(1), second = undisturbed.update(1.5);

    uint32_t refusals = 0;
    for (uint64_t n = 1; n < 400; ++n) {
        CountingMemory memory;
        Scene scene(on(memory));
        scene.update(1);
        // Grows everything: more actors, another view.
        for (uint32_t i = 0; i < 60; ++i)
            crowd::create(scene.crowd, *scene.templates[0],
                          crowd::Transform{glm::dvec3(0, 0, 1e5), glm::quat(1, 0, 0, 0), 1}, {}, 1);
        scene.add_view(glm::dvec3(0, 2, 3), glm::dvec3(0, 0, -9));
        const uint64_t hash = scene.crowd.hash();
        memory.refuse_nth(n);
        const base::Status status = scene.try_update(1.25);
        const bool refused = memory.refused();
        memory.forget();
        EXPECT_EQ(scene.crowd.hash(), hash);
        if (!status.ok()) {
            ++refusals;
            EXPECT_EQ(status.code, CLQ_OUT_OF_MEMORY);
            EXPECT_TRUE(scene.views[1]->list.items.empty());
        }
        scene.views.pop_back();
        EXPECT_TRUE(status.ok() || scene.hash() == first) << "after refusing allocation " << n;  // drawn as before
        EXPECT_EQ(scene.update(1.5), second) << "after refusing allocation " << n;
        if (!refused) break;
    }
    EXPECT_GT(refusals, 8u);
}

// The arena is full as well: actors without vertices stay in the list without them, and get vertices at the next
// successful update.
TEST(AllocationLaw, ActorsThatAreRefusedMemoryAreLeftOutAndCounted)
{
    CountingMemory memory;
    Scene scene(on(memory));
    SceneDef same = on(memory);
    same.memory = std::pmr::get_default_resource();
    Scene reference(same);
    const glm::dvec3 eye(0, 1.7, 0), behind(0, 1, 30), ahead(0, 1, -30);
    scene.look(0, eye, behind);
    scene.update(0.5);
    scene.look(0, eye, ahead);
    // Actors that come into view get no memory for vertices; the lists of the update are smaller than those.
    memory.refuse_from(16384);
    const uint64_t whole = reference.update(1);
    EXPECT_NE(scene.update(1), whole);
    const uint32_t left_out = scene.frame.stats().left_out;
    EXPECT_GT(left_out, 20u);
    const auto &items = scene.views[0]->list.items, &all = reference.views[0]->list.items;
    ASSERT_EQ(items.size(), all.size());  // the list does not depend on what the caches keep
    uint32_t without = 0;
    for (size_t i = 0; i < items.size(); ++i) {
        EXPECT_EQ(items[i].actor_index, all[i].actor_index);
        without += !items[i].vertices.any();
    }
    EXPECT_EQ(without, left_out);
    memory.refuse_from(0);
    EXPECT_EQ(scene.update(1), whole);
    EXPECT_EQ(scene.frame.stats().left_out, 0u);
}

// A budget too small for any individual: everything is in memory of single updates, which is reused.
TEST(AllocationLaw, AnUpdateWithoutCachesAllocatesNothingOnceItHasSeenTheScene)
{
    for (const bool none : {false, true}) {
        CountingMemory memory;
        SceneDef def = on(memory);
        if (none) def.settings.caches.mode = animcache::Mode::none;
        else def.settings.caches.budget_bytes = 0;
        Scene scene(def);
        scene.update(0);
        const uint64_t before = memory.allocations();
        for (int i = 1; i < 100; ++i) scene.update(i / 60.0);
        EXPECT_EQ(memory.allocations(), before);
        EXPECT_EQ(scene.frame.stats().cache_pool_bytes, 0u);
        EXPECT_GT(scene.frame.stats().arena_bytes, 0u);
    }
}

TEST(AllocationLaw, AnUpdateAllocatesNothingOnceItHasSeenTheScene)
{
    CountingMemory memory;
    Scene scene(on(memory));
    scene.update(0);
    const uint64_t before = memory.allocations();
    uint32_t skinned = 0;
    for (int i = 1; i < 100; ++i) scene.update(i / 60.0), skinned += scene.frame.stats().skinned;
    EXPECT_EQ(memory.allocations(), before);
    EXPECT_GT(skinned, 100u);
}

TEST(AllocationLaw, ActorsThatComeIntoViewReuseTheMemoryOfThoseThatLeftIt)
{
    CountingMemory memory;
    SceneDef def = on(memory);
    def.actors = 600;
    Scene scene(def);
    const auto turn = [&](int from, int to) {
        for (int i = from; i < to; ++i) {
            const double angle = i * 0.01;
            scene.look(0, glm::dvec3(0, 1.7, -35), glm::dvec3(std::sin(angle), 1.7, -35 - std::cos(angle)));
            scene.update(i / 60.0);
        }
    };
    turn(0, 700);  // once round, slowly: every actor comes into view and leaves it
    const uint64_t before = memory.allocations(), evicted = scene.frame.stats().evicted;
    const uint64_t bytes = scene.frame.stats().cache_pool_bytes;
    turn(700, 1400);
    EXPECT_EQ(memory.allocations(), before);
    EXPECT_EQ(scene.frame.stats().cache_pool_bytes, bytes);
    EXPECT_GT(scene.frame.stats().evicted, evicted + 300);  // blocks that changed owners

    SceneDef all = on(memory);
    all.actors = 600;
    Scene wide(all);  // all at once, for comparison
    wide.look(0, glm::dvec3(0, 1.7, 30), glm::dvec3(0, 1.7, -35));
    wide.update(1);
    // memory grows with the actors in view, not with all that were ever visible
    EXPECT_LT(bytes, wide.frame.stats().cache_pool_bytes);
}

TEST(AllocationLaw, ActorsAreCreatedWhollyOrNotAtAll)
{
    CountingMemory memory;
    const auto figure = make_figure();
    FigureDef other_def;
    other_def.seed = 9;
    const auto other = make_figure(other_def);
    uint32_t refusals = 0;
    {
        crowd::Crowd crowd(&memory, 1), twin(std::pmr::get_default_resource(), 1);
        for (uint32_t i = 0; i < 700; ++i) {
            const model::Template &tmpl = i % 2 ? *figure : *other;
            const auto make = [&](crowd::Crowd &in) { return crowd::create(in, tmpl, {}, {}, i); };
            crowd::Id id;
            for (uint64_t n = 1;; ++n) {
                const uint64_t hash = crowd.hash();
                memory.refuse_nth(n);
                try {
                    id = make(crowd);
                    memory.forget();
                    break;
                } catch (const std::bad_alloc &) {
                    ++refusals;
                    memory.forget();
                    ASSERT_EQ(crowd.hash(), hash);
                }
            }
            for (uint64_t n = 1;; ++n) {
                const uint64_t hash = crowd.hash();
                memory.refuse_nth(n);
                try {
                    crowd::randomise_colours(crowd, id, nullptr, 0);
                    memory.forget();
                    break;
                } catch (const std::bad_alloc &) {
                    ++refusals;
                    memory.forget();
                    ASSERT_EQ(crowd.hash(), hash);
                }
            }
            crowd::randomise_colours(twin, make(twin), nullptr, 0);
        }
        EXPECT_EQ(crowd.hash(), twin.hash());
        EXPECT_GT(refusals, 20u);
    }
    EXPECT_EQ(memory.bytes(), 0);  // all memory was given back
}

TEST(AllocationLaw, AllThatAnUpdateHoldsIsReported)
{
    for (const animcache::Mode mode : {animcache::Mode::full, animcache::Mode::animation, animcache::Mode::none})
        for (const bool key_poses : {false, true}) {
            CountingMemory memory;
            SceneDef def = on(memory);
            def.settings.caches.mode = mode;
            def.settings.caches.budget_bytes = 300000;
            if (key_poses) {
                def.settings.caches.key_poses.band_count = 1;
                def.settings.caches.key_poses.bands[0] = {0, animcache::KeyPoseMode::interpolated};
            }
            Scene scene(def);
            const int64_t before = memory.bytes();
            for (int i = 0; i < 5; ++i) scene.update(i * 0.1);
            const frame::Stats &stats = scene.frame.stats();
            const uint64_t reported =
                stats.frame_bytes + stats.cache_pool_bytes + stats.key_poses.bytes + scene.views[0]->bytes();
            EXPECT_EQ(uint64_t(memory.bytes() - before), reported) << int(mode) << key_poses;
        }
}

TEST(AllocationLaw, EverythingIsGivenBackAtTheEnd)
{
    CountingMemory memory;
    {
        SceneDef def = on(memory);
        def.settings.caches.budget_bytes = 60000;
        Scene scene(def);
        for (int i = 0; i < 20; ++i) {
            scene.look(0, glm::dvec3(0, 1.7, 0), glm::dvec3(i - 10, 1, -10));
            scene.update(i * 0.1);
        }
        EXPECT_GT(memory.bytes(), 0);
    }
    EXPECT_EQ(memory.bytes(), 0);
}

}  // namespace claque
