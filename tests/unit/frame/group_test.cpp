// Groups change the cost of a frame and the positions of members, but not how the members are shown.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/math/slerp.h"
#include "tests/law/support/scene.h"

namespace claque::frame
{

using namespace testing_support;

namespace
{

crowd::Transform group_place(uint32_t g)
{
    crowd::Transform transform;
    transform.position = glm::dvec3(8.0 * g - 16, 0.5 * g, -6.0 * g);
    transform.orientation = math::unit_quat(1, 0.1 * g, 0.7 * g - 1, -0.05 * g);
    transform.scale = g == 3 ? -0.8f : 0.7f + 0.2f * float(g);
    return transform;
}

// Two thirds of all actors are in five groups; in the twin scene, ungrouped actors stand where these members are.
struct Twins {
    Scene grouped, alone;
    std::vector<crowd::Id> groups;

    explicit Twins(const SceneDef &def = {}) : grouped(def), alone(def)
    {
        for (uint32_t g = 0; g < 5; ++g) groups.push_back(crowd::create_group(grouped.crowd, group_place(g)));
        for (uint32_t i = 0; i < grouped.ids.size(); ++i) {
            if (i % 3 == 0) continue;
            const crowd::Transform transform = grouped.crowd.transform_of(i);
            crowd::join(grouped.crowd, grouped.ids[i], groups[i % 5], &transform);
        }
        follow();
    }
    void follow()
    {
        for (uint32_t i = 0; i < grouped.ids.size(); ++i) {
            const crowd::Transform transform = grouped.crowd.world_transform_of(i);
            crowd::set_transforms(alone.crowd, &alone.ids[i], &transform, 1);
        }
    }
    void look(const glm::dvec3 &eye, const glm::dvec3 &target)
    {
        grouped.look(0, eye, target);
        alone.look(0, eye, target);
    }
};

}  // namespace

TEST(Group, MembersAreShownAsIfTheyStoodThereByThemselvesFromEverywhere)
{
    Twins twins;
    uint32_t skipped = 0;
    for (int turn = 0; turn < 48; ++turn) {
        const double a = turn * 0.1309;
        twins.look(glm::dvec3(std::cos(3 * a) * 9, 1.5, -12), glm::dvec3(20 * std::sin(a), 1, -12 + 20 * std::cos(a)));
        EXPECT_EQ(twins.grouped.update(1 + 0.1 * turn), twins.alone.update(1 + 0.1 * turn)) << turn;
        skipped += 80 - twins.grouped.frame.stats().tested;
    }
    EXPECT_GT(skipped, 200u) << "some groups were out of view with all their members";
}

TEST(Group, MovesItsMembersWithIt)
{
    Twins twins;
    twins.grouped.update(1);
    for (int step = 1; step < 20; ++step) {
        crowd::Transform transform = group_place(2);
        transform.position += glm::dvec3(0.4 * step, 0, -step);
        transform.orientation = math::unit_quat(1, 0, 0.2 * step, 0.02 * step);
        crowd::set_group_transform(twins.grouped.crowd, twins.groups[2], transform);
        twins.follow();
        EXPECT_EQ(twins.grouped.update(1 + 0.04 * step), twins.alone.update(1 + 0.04 * step)) << step;
    }
}

TEST(Group, SphereFollowsMembersThatMoveInsideItOrLeave)
{
    Twins twins;
    twins.grouped.update(1);
    for (uint32_t i = 1; i < twins.grouped.ids.size(); i += 3) {
        crowd::Transform transform = twins.grouped.crowd.transform_of(i);
        transform.position.x += 30;
        crowd::set_transforms(twins.grouped.crowd, &twins.grouped.ids[i], &transform, 1);
        if (i % 2) crowd::join(twins.grouped.crowd, twins.grouped.ids[i], crowd::Id(), nullptr);
    }
    twins.follow();
    for (int turn = 0; turn < 24; ++turn) {
        const double a = turn * 0.2618;
        twins.look(glm::dvec3(0, 2, 0), glm::dvec3(std::sin(a), 2, std::cos(a)));
        EXPECT_EQ(twins.grouped.update(2 + turn), twins.alone.update(2 + turn)) << turn;
    }
}

TEST(Group, ThatIsDisabledShowsNoMembersCostsNoTestAndReturnsInTime)
{
    Twins twins;
    twins.grouped.update(1);
    const uint32_t tested = twins.grouped.frame.stats().tested;
    const auto members = [&](uint32_t g) { return twins.grouped.crowd.group(g).members; };
    crowd::enable_group(twins.grouped.crowd, twins.groups[1], false);
    twins.grouped.update(1.5);
    EXPECT_EQ(twins.grouped.frame.stats().tested, tested - members(1));
    EXPECT_FALSE(twins.grouped.frame.group_visible(twins.grouped.crowd, 1));
    EXPECT_TRUE(twins.grouped.frame.group_visible(twins.grouped.crowd, 2));
    for (const draw::Item &item : twins.grouped.views[0]->list.items)
        EXPECT_NE(twins.grouped.crowd.group_of(item.actor_index), 1u);
    for (uint32_t row = 0; row < twins.grouped.crowd.row_count(); ++row) {
        if (twins.grouped.crowd.group_of(row) == 1) {
            EXPECT_FALSE(twins.grouped.frame.visibility(twins.grouped.crowd, row).visible);
        }
    }
    crowd::enable_group(twins.grouped.crowd, twins.groups[1], true);
    EXPECT_EQ(twins.grouped.update(2.25), twins.alone.update(2.25));
}

TEST(Group, OutsideEveryViewCostsItsMembersNothing)
{
    Twins twins;
    crowd::Transform away;
    away.position = glm::dvec3(0, 0, 5000);
    for (const crowd::Id group : twins.groups) crowd::set_group_transform(twins.grouped.crowd, group, away);
    twins.grouped.update(1);
    EXPECT_EQ(twins.grouped.frame.stats().tested, 27u) << "those without a group";
    EXPECT_EQ(twins.grouped.frame.stats().groups, 5u);
    EXPECT_EQ(twins.grouped.frame.stats().groups_visible, 0u);
}

TEST(Group, IsVisibleInAnyOfSeveralViews)
{
    Twins twins;
    twins.grouped.add_view(glm::dvec3(0, 2, 40), glm::dvec3(0, 2, 80));
    crowd::Transform behind;
    behind.position = glm::dvec3(0, 0, 90);
    crowd::set_group_transform(twins.grouped.crowd, twins.groups[4], behind);
    twins.grouped.update(1);
    EXPECT_TRUE(twins.grouped.frame.group_visible(twins.grouped.crowd, 4));
    EXPECT_FALSE(twins.grouped.views[1]->list.items.empty());
    for (const draw::Item &item : twins.grouped.views[1]->list.items)
        EXPECT_EQ(twins.grouped.crowd.group_of(item.actor_index), 4u);
}

TEST(Group, FramesAskForNoMemoryWhileGroupsMove)
{
    CountingMemory memory;
    SceneDef def;
    def.memory = &memory;
    Twins twins(def);
    const auto move = [&](int i) {
        crowd::Transform transform = group_place(i % 5);
        transform.position.x += i;
        crowd::set_group_transform(twins.grouped.crowd, twins.groups[i % 5], transform);
        crowd::set_transforms(twins.grouped.crowd, &twins.grouped.ids[1], &transform, 1);
        crowd::enable_group(twins.grouped.crowd, twins.groups[2], i % 2);
        twins.grouped.update(2 + 0.1 * i);
    };
    for (int i = 0; i < 30; ++i) move(i);  // caches grow for actors that come into view
    const uint64_t before = memory.allocations();
    for (int i = 0; i < 30; ++i) move(i);
    EXPECT_EQ(memory.allocations(), before);
}

}  // namespace claque::frame
