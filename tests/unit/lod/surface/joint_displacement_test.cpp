// Joint displacement: how far joints move apart when a character moves.
#include "lib/lod/surface/joint_displacement.h"

#include <gtest/gtest.h>

using namespace claque;

namespace
{

// Three nodes in a row, each with its own strip of surface. In the one clip the last node is half a unit aside, and the
// middle one turns, with its descendants, by 180 degrees about the up axis.
model::Model of_three()
{
    model::Model model;
    model.rig.parents.assign({model::none, 0, 1});
    model.rig.rest.resize(3);
    model.rig.palette.resize(3);
    model::Part part;
    part.skinned = true;
    for (uint32_t node = 0; node < 3; ++node) {
        model.rig.node_names.emplace_back("node");
        model.rig.palette[node].node = node;
        for (const glm::vec3 p : {glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(1, 0, 0)}) {
            part.positions.push_back(p + glm::vec3(0, float(node), 0));
            part.joints.push_back(node);
            part.weights.push_back(1);
        }
    }
    model.parts.push_back(part);
    model.rig.clips.push_back({0, 2, 0, 1});
    model.rig.clip_names.emplace_back("clip");
    model.rig.times.assign({0, 1});
    model.rig.values.assign({0, 0, 0.5f, 0, 0, 0.5f, 0, 1, 0, 0, 0, 1, 0, 0});
    model.rig.channels.push_back({2, model::ChannelTarget::translation, model::Interpolation::linear, 3, 0, 2, 0});
    model.rig.channels.push_back({1, model::ChannelTarget::rotation, model::Interpolation::linear, 4, 0, 2, 6});
    return model;
}

}  // namespace

TEST(JointDisplacement, IsTheDistanceBetweenFollowingAJointAndFollowingItsParent)
{
    const model::Model model = of_three();
    const std::vector<double> displacements = lod::joint_displacements(model, {{&model.parts[0]}});
    ASSERT_EQ(displacements.size(), 3u);
    EXPECT_EQ(displacements[0], 0);
    EXPECT_NEAR(displacements[1], 2, 1e-6) << "half a turn, a unit from the axis";
    EXPECT_NEAR(displacements[2], 0.5, 1e-6) << "independent of the parent's motion";
}

TEST(JointDisplacement, IsUnknownWhereThereAreNoClips)
{
    model::Model model = of_three();
    model.rig.clips.clear();
    EXPECT_TRUE(lod::joint_displacements(model, {{&model.parts[0]}}).empty());
}
