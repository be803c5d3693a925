// Skeletal levels of detail (S0 5.2): deactivated nodes, and vertices that move to the remaining ones.
#include <gtest/gtest.h>

#include "lib/model/template_check.h"
#include "posed.h"

namespace claque::test
{

namespace
{

std::vector<uint32_t> list(const model::Array<uint32_t> &array) { return {array.begin(), array.end()}; }

}  // namespace

TEST(SkeletalLevels, ANodeThatStopsTakesAlongAllBelowIt)
{
    Puppet m;
    m.skin({m.root, m.spine, m.arm, m.hand, m.finger}, "body");
    m.stop(m.arm, 30);
    m.stop(m.finger, 10);
    m.stop(m.hand, 80);
    const auto tmpl = built(m);
    ASSERT_EQ(tmpl->levels.size(), 4u);
    EXPECT_EQ(list(tmpl->levels[0].nodes), (std::vector<uint32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(list(tmpl->levels[1].nodes), (std::vector<uint32_t>{0, 1, 2, 3, 5}));
    EXPECT_EQ(list(tmpl->levels[2].nodes), (std::vector<uint32_t>{0, 1, 5}));
    EXPECT_EQ(list(tmpl->levels[3].nodes), (std::vector<uint32_t>{0, 1, 5}));
    EXPECT_EQ(std::vector<uint8_t>(tmpl->levels[2].active.begin(), tmpl->levels[2].active.end()),
              (std::vector<uint8_t>{1, 1, 0, 0, 0, 1}));
    EXPECT_EQ(tmpl->levels[1].skeletal_level, 1u);
    EXPECT_EQ(tmpl->levels[3].skeletal_level, 2u) << "it shares poses with the level before";
    model::check(*tmpl);
}

TEST(SkeletalLevels, EntriesAreThoseOfAllLevelsThatSharePoses)
{
    Puppet m;
    m.hang(m.root, "body", 0, 30);
    m.hang(m.spine, "coarse body", 30, 60);
    m.hang(m.leg, "block", 60);
    m.skin({m.arm, m.hand}, "sleeve", 0, 40);
    m.stop(m.hand, 40);
    const auto tmpl = built(m);
    ASSERT_EQ(tmpl->levels.size(), 4u);
    EXPECT_EQ(list(tmpl->levels[0].entries), (std::vector<uint32_t>{0, 1, 3, 4}));
    EXPECT_EQ(list(tmpl->levels[1].entries), list(tmpl->levels[0].entries));
    EXPECT_EQ(tmpl->levels[1].skeletal_level, 0u);
    EXPECT_EQ(list(tmpl->levels[2].entries), (std::vector<uint32_t>{1, 2}));
    EXPECT_EQ(tmpl->levels[3].skeletal_level, 2u);
}

TEST(SkeletalLevels, LevelsOfMeshesAloneKeepOneWholeSkeleton)
{
    Puppet m;
    m.hang(m.root, "body", 0, 30);
    m.hang(m.spine, "coarse body", 30);
    const auto tmpl = built(m);
    for (const model::Level &level : tmpl->levels) {
        EXPECT_EQ(level.skeletal_level, 0u);
        EXPECT_TRUE(level.active.empty() && level.nodes.empty() && level.entries.empty());
    }
}

TEST(SkeletalLevels, WhereStoppedNodesAreAtRestVerticesAreWhereTheyAreWithAllNodes)
{
    Puppet m;
    m.rig.rest[m.arm].rotation = glm::quat(0.8f, 0.6f, 0, 0);
    m.rig.rest[m.hand].scale = glm::vec3(2);
    m.rig.rest[m.finger].translation = {0.5f, 0.25f, 3};
    m.skin({m.root, m.spine, m.arm, m.hand, m.finger}, "body");
    m.rig.rest[m.hand].rotation = glm::quat(0.6f, 0, 0.8f, 0);  // its rest pose differs from its bind pose
    m.rig.dofs.push_back({m.finger, model::DofKind::rotation, 0, glm::vec3(0, 0, 1), 0, 1, 0.5f});
    m.rig.dofs.push_back({m.hand, model::DofKind::translation, 0, glm::vec3(1, 0, 0), 0, 1, 0.25f});
    m.rig.dof_names.resize(2);
    m.swing({m.root, m.spine});
    m.stop(m.finger, 10);
    m.stop(m.hand, 20);
    m.stop(m.arm, 30);
    const auto tmpl = built(m);
    ASSERT_EQ(tmpl->levels.size(), 4u);
    for (const double time : {0.0, 0.7, 1.3})
        for (size_t k = 1; k < 4; ++k)
            EXPECT_LT(largest_difference(posed(*tmpl, k, 0, time), posed(*tmpl, 0, 0, time)),
                      1e-6f * tmpl->sklsroot.radius)
                << k << " at " << time;
    model::check(*tmpl);
}

TEST(SkeletalLevels, WhereStoppedNodesMoveVerticesFollowWhatIsLeft)
{
    Puppet m;
    m.skin({m.root, m.spine, m.arm, m.hand, m.finger}, "body");
    m.swing({m.spine, m.finger});
    m.stop(m.finger, 10);
    const auto tmpl = built(m);
    EXPECT_GT(largest_difference(posed(*tmpl, 1, 0, 0.0), posed(*tmpl, 0, 0, 0.0)), 0.1f);
}

TEST(SkeletalLevels, ASkinThatRestsAsItWasBoundNeedsNoFurtherEntries)
{
    Puppet m;
    m.rig.rest[m.spine].rotation = glm::quat(0.8f, 0.6f, 0, 0);
    m.skin({m.root, m.spine, m.arm, m.hand, m.finger}, "body");
    m.stop(m.hand, 20);
    EXPECT_EQ(built(m)->rig.palette.size(), 5u);
    m.rig.rest[m.finger].translation.x += 0.01f;
    EXPECT_EQ(built(m)->rig.palette.size(), 6u) << "the finger rests beside its bind pose";
    m.rig.rest[m.hand].translation.x += 0.01f;
    EXPECT_EQ(built(m)->rig.palette.size(), 7u);
}

TEST(SkeletalLevels, WeightsOfEntriesThatBecomeOneAddUp)
{
    Puppet m;
    m.skin({m.root, m.spine, m.arm, m.hand, m.finger}, "body");
    m.stop(m.spine, 20);
    const auto tmpl = built(m);
    const model::Level &level = tmpl->levels[1];
    ASSERT_EQ(level.runs.size(), 1u);
    EXPECT_EQ(level.runs[0].influences, 1u);
    for (size_t i = 0; i < level.weights.size(); ++i) {
        EXPECT_EQ(level.joints[i], 0u);
        EXPECT_EQ(level.weights[i], 1.0f);
    }
    EXPECT_EQ(list(level.entries), std::vector<uint32_t>{0});
    EXPECT_GT(tmpl->levels[0].runs.back().influences, 1u);
}

TEST(SkeletalLevels, EntriesThatOnlyStoppedPartsUseDoNotMove)
{
    Puppet m;
    m.skin({m.root, m.spine}, "body");
    m.rig.rest[m.finger].translation.x += 1;
    m.hang(m.finger, "ring", 0, 20);
    m.hang(m.spine, "stump", 20);
    m.stop(m.finger, 20);
    EXPECT_EQ(built(m)->rig.palette.size(), m.rig.palette.size());
}

}  // namespace claque::test
