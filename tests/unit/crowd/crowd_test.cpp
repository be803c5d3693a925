#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "tests/law/support/figure.h"
#include "tests/law/support/host.h"

namespace claque::crowd
{

using namespace testing_support;

namespace
{

template <class Body>
clq_status status_of(const Body &body)
{
    try {
        body();
    } catch (const base::Error &error) {
        return error.status();
    }
    return CLQ_OK;
}

class CrowdTest : public ::testing::Test
{
protected:
    CrowdTest() : figure_(make_figure()), crowd_(std::pmr::get_default_resource(), 7) {}
    Id add(uint64_t seed = 1) { return crowd::create(crowd_, *figure_, Transform(), Play(), seed); }
    std::unique_ptr<model::Template> figure_;
    Crowd crowd_;
};

}  // namespace

TEST_F(CrowdTest, AnIdWhoseActorIsGoneIsStaleForEver)
{
    const Id first = add(), second = add();
    crowd::destroy(crowd_, first);
    EXPECT_EQ(crowd_.actor_count(), 1u);
    const Id reused = add();
    EXPECT_EQ(reused.index1, first.index1);
    EXPECT_NE(reused.generation, first.generation);
    const Transform transform;
    const float rgb[9] = {};
    for (const Id stale : {first, Id{0, 0}, Id{0, 1}, Id{77, 1}, Id{second.index1, 0}, Id{first.index1, 2}}) {
        const uint64_t hash = crowd_.hash();
        EXPECT_EQ(status_of([&] { crowd_.row_of(stale); }), CLQ_STALE_ID);
        EXPECT_EQ(status_of([&] { crowd::destroy(crowd_, stale); }), CLQ_STALE_ID);
        EXPECT_EQ(status_of([&] { crowd::play(crowd_, stale, Play()); }), CLQ_STALE_ID);
        EXPECT_EQ(status_of([&] { crowd::set_transforms(crowd_, &stale, &transform, 1); }), CLQ_STALE_ID);
        EXPECT_EQ(status_of([&] { crowd::set_colours(crowd_, stale, rgb, 3); }), CLQ_STALE_ID);
        EXPECT_EQ(status_of([&] { crowd::randomise_colours(crowd_, stale, nullptr, 0); }), CLQ_STALE_ID);
        EXPECT_EQ(crowd_.hash(), hash);
    }
    EXPECT_EQ(crowd_.row_of(second), 1u);
}

TEST_F(CrowdTest, SetsAllTransformsOrNone)
{
    const Id ids[3] = {add(), add(), {9, 9}};
    Transform transforms[3];
    transforms[0].position.x = 5;
    const uint64_t hash = crowd_.hash();
    EXPECT_EQ(status_of([&] { crowd::set_transforms(crowd_, ids, transforms, 3); }), CLQ_STALE_ID);
    EXPECT_EQ(crowd_.hash(), hash);
    transforms[1].position.y = NAN;
    EXPECT_EQ(status_of([&] { crowd::set_transforms(crowd_, ids, transforms, 2); }), CLQ_ARGUMENT);
    EXPECT_EQ(crowd_.hash(), hash);
    crowd::set_transforms(crowd_, ids, transforms, 1);
    EXPECT_EQ(crowd_.transform_of(0).position.x, 5);
}

TEST_F(CrowdTest, RefusesWhatCannotBeShown)
{
    const Id id = add();
    Transform transform;
    transform.scale = 0;
    EXPECT_EQ(status_of([&] { crowd::set_transforms(crowd_, &id, &transform, 1); }), CLQ_ARGUMENT);
    transform.scale = -1;
    EXPECT_EQ(status_of([&] { crowd::set_transforms(crowd_, &id, &transform, 1); }), CLQ_OK);
    transform.orientation = glm::quat(0, 0, 0, 0);
    EXPECT_EQ(status_of([&] { crowd::set_transforms(crowd_, &id, &transform, 1); }), CLQ_ARGUMENT);
    Play play;
    play.clip = 4;
    EXPECT_EQ(status_of([&] { crowd::play(crowd_, id, play); }), CLQ_ARGUMENT);
    play.clip = 0;
    play.speed = INFINITY;
    EXPECT_EQ(status_of([&] { crowd::play(crowd_, id, play); }), CLQ_ARGUMENT);
    const float high[9] = {0, 0, 0, 0, 1.01f};
    EXPECT_EQ(status_of([&] { crowd::set_colours(crowd_, id, high, 3); }), CLQ_ARGUMENT);
    EXPECT_EQ(status_of([&] { crowd::set_colours(crowd_, id, high, 2); }), CLQ_ARGUMENT);
    EXPECT_EQ(crowd_.zone_rgb(0), nullptr);
}

TEST_F(CrowdTest, EveryPlayIsAStateOfItsOwn)
{
    std::set<uint64_t> versions;
    for (int i = 0; i < 10; ++i) {
        const Id id = add();
        versions.insert(crowd_.actor(crowd_.row_of(id)).play_version);
        crowd::play(crowd_, id, Play());
        versions.insert(crowd_.actor(crowd_.row_of(id)).play_version);
        if (i % 2) crowd::destroy(crowd_, id);
    }
    EXPECT_EQ(versions.size(), 20u);
}

TEST_F(CrowdTest, DrawsColoursInsideTheirRangesRepeatablyFromTheSeed)
{
    const Id a = add(5), twin = add(5), other = add(6);
    for (const Id id : {a, twin, other}) crowd::randomise_colours(crowd_, id, nullptr, 0);
    const uint8_t *rgb = crowd_.zone_rgb(0);
    EXPECT_EQ(std::vector<uint8_t>(rgb, rgb + 9), std::vector<uint8_t>(crowd_.zone_rgb(1), crowd_.zone_rgb(1) + 9));
    EXPECT_NE(std::vector<uint8_t>(rgb, rgb + 9), std::vector<uint8_t>(crowd_.zone_rgb(2), crowd_.zone_rgb(2) + 9));
    // Zone 1 of the figure: hue 120 to 160, so green is the largest, red the smallest; brightness at least one half.
    for (uint64_t seed = 0; seed < 300; ++seed) {
        const Id id = add(seed);
        crowd::randomise_colours(crowd_, id, nullptr, 0);
        const uint8_t *c = crowd_.zone_rgb(crowd_.row_of(id)) + 3;
        EXPECT_GE(c[1], 127);
        EXPECT_GE(c[1], c[2]);
        EXPECT_GE(c[2], c[0]);
        EXPECT_LE(c[0], 0.5 * c[1] + 1);  // saturation at least one half
    }
}

TEST_F(CrowdTest, ColoursStayWhereTheyAreWhileTheCrowdGrows)
{
    const Id first = add();
    const float rgb[9] = {0.5f, 0, 1, 0, 0, 0, 0, 0, 0};
    crowd::set_colours(crowd_, first, rgb, 3);
    const uint8_t *at = crowd_.zone_rgb(0);
    for (int i = 0; i < 2000; ++i) crowd::randomise_colours(crowd_, add(), nullptr, 0);
    EXPECT_EQ(crowd_.zone_rgb(0), at);
    EXPECT_EQ(at[0], 128);
    EXPECT_EQ(at[2], 255);
}

TEST_F(CrowdTest, TheSameCallsGiveTheSameHashAndAnyDifferenceChangesIt)
{
    Crowd twin(std::pmr::get_default_resource(), 7);
    const auto both = [&](const auto &call) { call(crowd_), call(twin); };
    Id id;
    both([&](Crowd &c) { id = crowd::create(c, *figure_, Transform(), Play(), 3); });
    both([&](Crowd &c) { crowd::randomise_colours(c, id, nullptr, 0); });
    EXPECT_EQ(crowd_.hash(), twin.hash());
    Transform transform;
    transform.position.z = 1e-9;
    crowd::set_transforms(crowd_, &id, &transform, 1);
    EXPECT_NE(crowd_.hash(), twin.hash());
    crowd::set_transforms(twin, &id, &transform, 1);
    EXPECT_EQ(crowd_.hash(), twin.hash());
    const float rgb[9] = {};
    crowd::set_colours(twin, id, rgb, 3);
    EXPECT_NE(crowd_.hash(), twin.hash());
}

TEST_F(CrowdTest, ACloneThatFindsNoMemoryIsAsIfItHadNeverBeenAskedFor)
{
    CountingMemory memory;
    Crowd crowd(&memory, 7);
    crowd.behaviours().add(RootPath(&memory));
    const Id first = crowd::create(crowd, *figure_, Transform(), Play(), 1);
    crowd::randomise_colours(crowd, first, nullptr, 0);
    crowd::follow_ground(crowd, first, 1, 2);
    crowd::play_root_path(crowd, first, RootPathPlay{0, 1, 0, 0});
    crowd::join(crowd, first, crowd::create_group(crowd, Transform()), nullptr);
    uint32_t refused = 0;
    for (uint32_t i = 0; i < 600; ++i) {
        const uint64_t hash = crowd.hash(), structure = crowd.structure_version();
        for (uint64_t nth = 1; nth <= 12; ++nth) {
            memory.refuse_nth(nth);
            try {
                crowd::destroy(crowd, crowd::clone(crowd, first, nullptr, i));
                break;
            } catch (const std::bad_alloc &) {
                ++refused;
                ASSERT_EQ(crowd.hash(), hash);
                ASSERT_EQ(crowd.structure_version(), structure);
            }
        }
        memory.forget();
        const Id made = crowd::clone(crowd, first, nullptr, i);
        EXPECT_EQ(made.index1, i + 2);
        EXPECT_EQ(made.generation, 3u) << "the row was taken once before";
        ASSERT_TRUE(crowd.behaviours().has_root_path_play(made.index1 - 1));
    }
    EXPECT_GT(refused, 20u);
    EXPECT_EQ(crowd.group(0).members, 601u);
    EXPECT_EQ(std::vector<uint8_t>(crowd.zone_rgb(600), crowd.zone_rgb(600) + 9),
              std::vector<uint8_t>(crowd.zone_rgb(0), crowd.zone_rgb(0) + 9));
    EXPECT_EQ(crowd.extra_of(600)->max_down, 2);
}

TEST_F(CrowdTest, AnIndividualCostsAtMost512Bytes)
{
    for (uint32_t i = 0; i < 10000; ++i) crowd::randomise_colours(crowd_, add(i), nullptr, 0);
    EXPECT_LE(crowd_.bytes() / 10000, 512u);
    EXPECT_GE(crowd_.bytes() / 10000, 100u);
}

}  // namespace claque::crowd
