#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/math/slerp.h"
#include "tests/law/support/figure.h"
#include "tests/law/support/host.h"

namespace claque::crowd
{

using namespace testing_support;

namespace
{

Transform somewhere(double k)
{
    Transform transform;
    transform.position = glm::dvec3(3 * k - 7, 0.5 * k, 1e5 + k);
    transform.orientation = math::unit_quat(1, 0.3 * k, -0.7, 0.1 * k);
    transform.scale = k < 0 ? -0.75f : 1.25f;
    return transform;
}

void expect_same(const Transform &a, const Transform &b, double metres = 1e-6)
{
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a.position[k], b.position[k], metres);
    const float dot = glm::dot(a.orientation, b.orientation);
    EXPECT_NEAR(std::fabs(dot), 1, 1e-5f);
    EXPECT_NEAR(a.scale, b.scale, 1e-5f);
}

class GroupTest : public testing::Test
{
protected:
    Id add(const Transform &transform = Transform()) { return crowd::create(crowd_, *figure_, transform, Play(), 1); }
    template <class Call>
    clq_status refused(const Call &call)
    {
        const uint64_t before = crowd_.hash();
        try {
            call();
        } catch (const base::Error &error) {
            EXPECT_EQ(crowd_.hash(), before);
            return error.status();
        }
        return CLQ_OK;
    }
    CountingMemory memory_;
    std::unique_ptr<model::Template> figure_ = make_figure(FigureDef());
    Crowd crowd_{&memory_, 7};
};

}  // namespace

TEST(Transforms, ComposeAsMatricesDoAndRelativeUndoesIt)
{
    for (const double a : {-2.0, 0.5, 3.0})
        for (const double b : {-1.0, 1.0, 2.5}) {
            const Transform outer = somewhere(a), inner = somewhere(b), world = composed(outer, inner);
            const glm::dvec3 p(0.3, -0.2, 0.9);
            const auto at = [](const Transform &transform, const glm::dvec3 &x) {
                return transform.position + glm::dquat(transform.orientation) * (x * double(transform.scale));
            };
            const glm::dvec3 twice = at(outer, at(inner, p)), once = at(world, p);
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(twice[k], once[k], 0.02) << "float turns at 100 km";
            expect_same(relative(outer, world), inner, 0.03);
        }
}

TEST_F(GroupTest, JoiningAndLeavingWithoutATransformKeepsAnActorWhereItIs)
{
    const Id actor = add(somewhere(1)), group = crowd::create_group(crowd_, somewhere(-2));
    crowd::join(crowd_, actor, group, nullptr);
    EXPECT_EQ(crowd_.group(0).members, 1u);
    expect_same(crowd_.world_transform_of(0), somewhere(1), 1e-6);
    crowd::set_group_transform(crowd_, group, somewhere(4));
    const Transform moved = crowd_.world_transform_of(0);
    EXPECT_GT(std::fabs(moved.position.x - somewhere(1).position.x), 1);
    crowd::join(crowd_, actor, Id(), nullptr);
    EXPECT_EQ(crowd_.group_of(0), model::none);
    EXPECT_EQ(crowd_.group(0).members, 0u);
    expect_same(crowd_.transform_of(0), moved);
}

TEST_F(GroupTest, EndingAGroupLeavesItsMembersWhereTheyAre)
{
    const Id group = crowd::create_group(crowd_, somewhere(2));
    std::vector<Transform> before;
    for (int i = 0; i < 5; ++i) {
        const Transform transform = somewhere(i);
        crowd::join(crowd_, add(), group, &transform);
        before.push_back(crowd_.world_transform_of(uint32_t(i)));
    }
    crowd::destroy_group(crowd_, group);
    for (uint32_t i = 0; i < 5; ++i) {
        EXPECT_EQ(crowd_.group_of(i), model::none);
        expect_same(crowd_.transform_of(i), before[i], 0);
    }
    EXPECT_EQ(refused([&] { crowd::destroy_group(crowd_, group); }), CLQ_STALE_ID);
    const Id again = crowd::create_group(crowd_, Transform());
    EXPECT_EQ(again.index1, group.index1);
    EXPECT_EQ(refused([&] { crowd::set_group_transform(crowd_, group, Transform()); }), CLQ_STALE_ID)
        << "an old id stays stale";
}

TEST_F(GroupTest, AnActorThatIsDestroyedIsNoMemberAnyMore)
{
    const Id group = crowd::create_group(crowd_, Transform()), actor = add();
    crowd::join(crowd_, actor, group, nullptr);
    crowd::destroy(crowd_, actor);
    EXPECT_EQ(crowd_.group(0).members, 0u);
    add();
    EXPECT_EQ(crowd_.group_of(0), model::none) << "the row's next owner is in no group";
}

TEST_F(GroupTest, RefusesWhatIsWrongAndChangesNothing)
{
    const Id group = crowd::create_group(crowd_, Transform()), actor = add();
    Transform bad;
    bad.scale = 0;
    EXPECT_EQ(refused([&] { crowd::set_group_transform(crowd_, group, bad); }), CLQ_ARGUMENT);
    EXPECT_EQ(refused([&] { crowd::create_group(crowd_, bad); }), CLQ_ARGUMENT);
    EXPECT_EQ(refused([&] { crowd::join(crowd_, actor, group, &bad); }), CLQ_ARGUMENT);
    EXPECT_EQ(refused([&] { crowd::join(crowd_, Id{9, 1}, group, nullptr); }), CLQ_STALE_ID);
    EXPECT_EQ(refused([&] { crowd::join(crowd_, actor, Id{9, 1}, nullptr); }), CLQ_STALE_ID);
    EXPECT_EQ(refused([&] { crowd::enable_group(crowd_, Id{1, 2}, false); }), CLQ_STALE_ID);
    memory_.refuse_all(true);
    bool thrown = false;
    for (int i = 0; i < 100 && !thrown; ++i) {
        const uint64_t before = crowd_.hash();
        try {
            crowd::create_group(crowd_, Transform());
        } catch (const std::bad_alloc &) {
            thrown = true;
            EXPECT_EQ(crowd_.hash(), before);
        }
    }
    EXPECT_TRUE(thrown);
}

TEST_F(GroupTest, ChangesTheHash)
{
    const Id group = crowd::create_group(crowd_, Transform()), actor = add();
    uint64_t last = crowd_.hash();
    const auto changes = [&](const auto &call) {
        call();
        const bool changed = crowd_.hash() != last;
        last = crowd_.hash();
        return changed;
    };
    EXPECT_TRUE(changes([&] { crowd::join(crowd_, actor, group, nullptr); }));
    EXPECT_TRUE(changes([&] { crowd::enable_group(crowd_, group, false); }));
    EXPECT_TRUE(changes([&] { crowd::set_group_transform(crowd_, group, somewhere(1)); }));
    EXPECT_TRUE(changes([&] { crowd::destroy_group(crowd_, group); }));
}

}  // namespace claque::crowd
