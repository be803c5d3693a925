// An allocation that fails gives a status and leaves everything as it was (SPEC 4).
#include <gtest/gtest.h>

#include <cmath>

#include "lib/base/error.h"
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

TEST(AllocationLaw, AnUpdateThatIsRefusedMemoryChangesNothingAndTheNextOneIsAsIfItHadNotBeen)
{
    CountingMemory plain;
    Scene undisturbed(on(plain));
    const uint64_t first = undisturbed.update(1), second = undisturbed.update(1.5);

    uint32_t refusals = 0;
    for (uint64_t n = 1; n < 400; ++n) {
        CountingMemory memory;
        Scene scene(on(memory));
        scene.update(1);
        // Grow everything: more actors, another view.
        for (uint32_t i = 0; i < 60; ++i)
            scene.crowd.create(*scene.templates[0], crowd::Transform{glm::dvec3(0, 0, 1e5), glm::quat(1, 0, 0, 0), 1},
                               {}, 1);
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

TEST(AllocationLaw, CachesThatAreRefusedMemoryLeaveTheWorkToTheDrawing)
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
    memory.refuse_all(true);  // nobody who comes into view gets memory
    EXPECT_EQ(scene.update(1), reference.update(1));
    EXPECT_GT(scene.frame.stats().on_demand, 20u);
    memory.refuse_all(false);
}

TEST(AllocationLaw, AnUpdateAllocatesNothingOnceItHasSeenTheScene)
{
    CountingMemory memory;
    Scene scene(on(memory));
    scene.update(0);
    const uint64_t before = memory.allocations();
    for (int i = 1; i < 100; ++i) scene.update(i / 60.0);
    EXPECT_EQ(memory.allocations(), before);
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
    turn(0, 700);  // once round, slowly: everybody comes into view and leaves it
    const uint64_t before = memory.allocations(), evicted = scene.frame.stats().evicted;
    const uint64_t bytes = scene.frame.stats().cache_pool_bytes;
    turn(700, 1400);
    EXPECT_EQ(memory.allocations(), before);
    EXPECT_EQ(scene.frame.stats().cache_pool_bytes, bytes);
    EXPECT_GT(scene.frame.stats().evicted, evicted + 300);  // blocks that changed hands

    SceneDef all = on(memory);
    all.actors = 600;
    Scene wide(all);  // all at once, for comparison
    wide.look(0, glm::dvec3(0, 1.7, 30), glm::dvec3(0, 1.7, -35));
    wide.update(1);
    EXPECT_LT(bytes, wide.frame.stats().cache_pool_bytes);  // room is for who is in view, not for all who ever were
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
            const auto make = [&](crowd::Crowd &in) { return in.create(tmpl, {}, {}, i); };
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
                    crowd.randomise_colours(id, nullptr, 0);
                    memory.forget();
                    break;
                } catch (const std::bad_alloc &) {
                    ++refusals;
                    memory.forget();
                    ASSERT_EQ(crowd.hash(), hash);
                }
            }
            twin.randomise_colours(make(twin), nullptr, 0);
        }
        EXPECT_EQ(crowd.hash(), twin.hash());
        EXPECT_GT(refusals, 20u);
    }
    EXPECT_EQ(memory.bytes(), 0);  // all given back
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
