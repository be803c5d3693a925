#include "animcache/caches.h"

#include <cstring>

#include <gtest/gtest.h>

#include "tests/law/support/figure.h"
#include "tests/law/support/host.h"

namespace claque::animcache
{

using namespace testing_support;

namespace
{

class CachesTest : public ::testing::Test
{
protected:
    CachesTest() : figure_(make_figure())
    {
        FigureDef def;
        def.seed = 5;
        def.vertices = 10;
        small_ = make_figure(def);
        templates_[0] = figure_.get();
        templates_[1] = small_.get();
    }

    Settings budget(uint32_t palettes, uint32_t vertices) const
    {
        Settings settings;
        const Sizes sizes = sizes_of(*figure_, VertexFormat::floats);
        settings.budget_bytes = palettes * BlockPool::rounded_size(sizeof(float) * sizes.palette_floats) +
                                vertices * BlockPool::rounded_size(sizeof(float) * sizes.vertex_floats);
        return settings;
    }

    Request wants(uint32_t row, double clip_time_s, uint32_t level = 0) const
    {
        Request request;
        request.tmpl = figure_.get();
        request.row = row, request.slot = row;
        request.level = level;
        request.pose.version = row + 1;
        request.pose.clip_time_s = clip_time_s;
        request.pose.clip = clip_walk;
        return request;
    }

    static void update(Caches &caches, const std::vector<Request> &requests, uint32_t most_renewed = ~0u)
    {
        std::pmr::vector<Request> &list = caches.begin();
        list.assign(requests.begin(), requests.end());
        caches.allocate_poses();
        caches.defer({1, 0.1, most_renewed});
        caches.animate(base::Jobs());
        caches.allocate_vertices();
        caches.skin(base::Jobs());
    }

    static draw::Vertices vertices_of(const Caches &caches, uint32_t row)
    {
        for (const Request &request : caches.requests())
            if (request.row == row) return caches.vertices_of(request);
        return {};
    }

    bool holds(const Caches &caches, uint32_t row) const { return caches.keeps_vertices(row); }

    std::unique_ptr<model::Template> figure_, small_;
    const model::Template *templates_[2];
    base::Span<const model::Template *const> both_{templates_, 2};
};

}  // namespace

TEST(PoseKey, DiffersWhereAnyOfItsMembersDoes)
{
    PoseKey keys[8];
    keys[0].version = 9, keys[1].clip_time_s = 0.5, keys[2].tick_s = 0.5, keys[3].behaviour_levels = 2;
    keys[4].clip = 3, keys[5].skeletal_level = 1, keys[6].layers = 1, keys[7].interpolated = true;
    for (const PoseKey &key : keys) {
        EXPECT_FALSE(key == PoseKey()) << &key - keys;
        for (const PoseKey &other : keys)
            EXPECT_EQ(key == other, &key == &other) << &key - keys << ' ' << &other - keys;
    }
}

TEST_F(CachesTest, WhatIsStillGoodIsServedAndWhatIsOldIsMadeAnew)
{
    Caches caches(std::pmr::get_default_resource(), Settings());
    caches.reserve(4, both_);
    update(caches, {wants(0, 0.1), wants(2, 0.2)});
    EXPECT_EQ(caches.counters().animated, 2u);
    update(caches, {wants(0, 0.1), wants(2, 0.3), wants(3, 0.1)});
    EXPECT_EQ(caches.counters().palette_served, 1u);
    EXPECT_EQ(caches.counters().vertices_served, 1u);
    EXPECT_EQ(caches.counters().animated, 2u);
    EXPECT_EQ(caches.counters().skinned, 2u);
    EXPECT_TRUE(caches.was_animated(2));
    EXPECT_FALSE(caches.was_animated(0));
}

TEST_F(CachesTest, ANewPlayAtTheSameTimeIsAnotherPose)
{
    Caches caches(std::pmr::get_default_resource(), Settings());
    caches.reserve(1, both_);
    update(caches, {wants(0, 0.1)});
    Request replayed = wants(0, 0.1);
    replayed.pose.version = 77;
    replayed.pose.clip = clip_sway;
    update(caches, {replayed});
    EXPECT_EQ(caches.counters().animated, 1u);
}

TEST_F(CachesTest, ARowThatChangesItsTemplateStartsAfresh)
{
    Caches caches(std::pmr::get_default_resource(), Settings());
    caches.reserve(1, both_);
    update(caches, {wants(0, 0.1)});
    const uint64_t bytes = caches.counters().cache_bytes;
    Request other = wants(0, 0.1);
    other.tmpl = small_.get();
    other.pose.version = 9;
    update(caches, {other});
    EXPECT_EQ(caches.counters().animated, 1u);
    EXPECT_LT(caches.counters().cache_bytes, bytes);
}

// A fade has ended, and the update has no budget to renew poses: the pose of the fade is still drawn.
TEST_F(CachesTest, AWaitingActorKeepsTheRangeThatItsVerticesWerePackedIn)
{
    Settings settings;
    settings.vertex_format = VertexFormat::packed;
    Caches caches(std::pmr::get_default_resource(), settings);
    caches.reserve(1, both_);
    Request blended = wants(0, 0.1);
    blended.blend_radius = 8 * figure_->sklsroot.radius;
    update(caches, {blended});
    const draw::Vertices before = vertices_of(caches, 0);
    update(caches, {wants(0, 0.1)});  // the blend has ended, the pose is the same
    EXPECT_EQ(caches.counters().vertices_served, 1u);
    EXPECT_EQ(vertices_of(caches, 0).step, before.step);
    update(caches, {wants(0, 0.2)}, 0);
    EXPECT_EQ(caches.counters().deferred, 1u);
    EXPECT_EQ(vertices_of(caches, 0).step, before.step);
    update(caches, {wants(0, 0.2)});
    EXPECT_LT(vertices_of(caches, 0).step, before.step / 2);
}

TEST_F(CachesTest, TheModesKeepWhatTheirNamesSay)
{
    for (const Mode mode : {Mode::full, Mode::animation, Mode::none}) {
        Settings settings;
        settings.mode = mode;
        Caches caches(std::pmr::get_default_resource(), settings);
        caches.reserve(1, both_);
        update(caches, {wants(0, 0.1)});
        update(caches, {wants(0, 0.1)});
        EXPECT_TRUE(vertices_of(caches, 0).any());
        EXPECT_EQ(caches.keeps_palette(0), mode != Mode::none);
        EXPECT_EQ(caches.keeps_vertices(0), mode == Mode::full);
        EXPECT_EQ(caches.counters().cache_bytes > 0, mode != Mode::none);
        EXPECT_EQ(caches.counters().animated, mode == Mode::none ? 1u : 0u);
        EXPECT_EQ(caches.counters().skinned, mode == Mode::full ? 0u : 1u);
    }
}

TEST_F(CachesTest, TheLongestInvisibleActorIsEvictedFirstAndTiesGoByRow)
{
    Caches caches(std::pmr::get_default_resource(), budget(4, 4));
    caches.reserve(10, both_);
    update(caches, {wants(0, 0), wants(1, 0), wants(2, 0), wants(3, 0)});
    update(caches, {wants(1, 0)});  // 0, 2 and 3 were last seen together, before 1
    update(caches, {wants(5, 0)});  // room for one
    EXPECT_FALSE(caches.keeps_palette(0));
    EXPECT_TRUE(caches.keeps_palette(2));
    update(caches, {wants(6, 0), wants(7, 0), wants(8, 0)});
    EXPECT_FALSE(caches.keeps_palette(2));
    EXPECT_FALSE(caches.keeps_palette(3));
    EXPECT_FALSE(caches.keeps_palette(1));
    EXPECT_TRUE(caches.keeps_palette(5));
    EXPECT_EQ(caches.counters().evicted, 8u);  // four individuals, two blocks each
}

TEST_F(CachesTest, SeenActorsAreNeverThrownOutAndThoseWithoutRoomAreSkinnedForTheUpdateToTheSameBits)
{
    Caches roomy(std::pmr::get_default_resource(), Settings()), tight(std::pmr::get_default_resource(), budget(3, 1));
    roomy.reserve(5, both_);
    tight.reserve(5, both_);
    std::vector<Request> requests;
    for (uint32_t row = 0; row < 5; ++row) requests.push_back(wants(row, 0.1 * row, row % 2));
    update(roomy, requests);
    update(tight, requests);
    EXPECT_GE(tight.counters().on_demand, 3u);
    EXPECT_LE(tight.counters().cache_bytes, tight.settings().budget_bytes);
    for (uint32_t row = 0; row < 5; ++row) {
        const draw::Vertices got = vertices_of(tight, row), expected = vertices_of(roomy, row);
        ASSERT_TRUE(got.any());
        const size_t bytes = 12 * figure_->levels[row % 2].vertex_count;
        EXPECT_EQ(std::memcmp(got.positions, expected.positions, bytes), 0);
        EXPECT_EQ(std::memcmp(got.normals, expected.normals, bytes), 0);
    }
    EXPECT_EQ(tight.counters().left_out, 0u);
    EXPECT_GT(tight.counters().arena_bytes, 0u);
    EXPECT_EQ(roomy.counters().arena_bytes, 0u);
    update(tight, requests);
    EXPECT_EQ(tight.counters().evicted, 0u);
}

TEST_F(CachesTest, AVictimOfAnotherTemplateMakesRoomToo)
{
    Caches caches(std::pmr::get_default_resource(), budget(1, 1));
    caches.reserve(3, both_);
    Request small = wants(1, 0);
    small.tmpl = small_.get();
    update(caches, {small});
    EXPECT_TRUE(holds(caches, 1));
    update(caches, {wants(0, 0)});
    EXPECT_TRUE(holds(caches, 0));
    EXPECT_FALSE(holds(caches, 1));
    EXPECT_EQ(caches.counters().cache_bytes, caches.settings().budget_bytes);
}

TEST_F(CachesTest, EverySliceWorksInMemoryOfItsOwn)
{
    ScratchPool pool(std::pmr::get_default_resource(), 5);
    Sizes sizes = sizes_of(*figure_, VertexFormat::floats);
    pool.reserve(sizes_of(*small_, VertexFormat::floats));
    pool.reserve(sizes);
    pool.reserve(sizes_of(*small_, VertexFormat::floats));  // a smaller request shrinks nothing
    for (uint32_t i = 0; i + 1 < 5; ++i) {
        const Scratch a = pool.slice(i), b = pool.slice(i + 1);
        EXPECT_GE(b.locals - a.locals, std::ptrdiff_t(sizes.nodes));
        EXPECT_GE(b.globals - a.globals, std::ptrdiff_t(sizes.nodes));
        EXPECT_GE(b.floats - a.floats, std::ptrdiff_t(sizes.scratch_floats));
    }
}

TEST_F(CachesTest, AllMemoryIsGivenBack)
{
    CountingMemory memory;
    {
        Caches caches(&memory, budget(2, 2));
        caches.reserve(6, both_);
        for (uint32_t i = 0; i < 12; ++i) update(caches, {wants(i % 6, 0), wants(5, i)});
    }
    EXPECT_EQ(memory.bytes(), 0);
}

}  // namespace claque::animcache
