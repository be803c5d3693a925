// Keypoints of one's own: files are read, and what is wrong is refused by file, line and column.
#include "samples/labels/keypoints.h"

#include <gtest/gtest.h>

#include "samples/labels/joint_names.h"
#include "samples/scenes/check.h"

namespace
{

std::string refusal_of_points(const std::string &text)
{
    try {
        labels::read_keypoints(text, "k.toml");
    } catch (const scenes::Failure &failure) {
        return failure.what();
    }
    return "";
}

TEST(KeypointFiles, HavePointsAndLines)
{
    const labels::KeypointSet set = labels::read_keypoints(R"(name = "upper"
[[points]]
name = "chin"
joint = "head"
offset_m = [0, -0.05, 0.1]
[[points]]
name = "badge"
nodes = ["chest", "Spine2"]
[[lines]]
from = "badge"
to = "chin"
)",
                                                           "k.toml");
    EXPECT_EQ(set.name, "upper");
    EXPECT_EQ(set.names, (std::vector<std::string>{"chin", "badge"}));
    EXPECT_EQ(set.own.at("chin").joint, "head");
    EXPECT_EQ(set.own.at("chin").offset_m, (std::array<double, 3>{0, -0.05, 0.1}));
    EXPECT_EQ(set.own.at("badge").nodes, (std::vector<std::string>{"chest", "Spine2"}));
    ASSERT_EQ(set.edges.size(), 1u);
    EXPECT_EQ(set.edges[0], (std::array<int, 2>{1, 0}));
}

TEST(KeypointFiles, ThatAreWrongAreRefusedAtTheirPlace)
{
    const std::string name = "name = \"n\"\n", point = "[[points]]\nname = \"a\"\n";
    const std::vector<std::pair<std::string, const char *>> wrong = {
        {"", "the file of keypoints lacks 'name'"},
        {name, "the file of keypoints has no [[points]]"},
        {name + point, "k.toml:2:1: [[points]] 1 needs one of 'joint' and 'nodes'"},
        {name + point + "joint = \"head\"\nnodes = []", "needs one of 'joint' and 'nodes'"},
        {name + point + "joint = \"tail\"", "k.toml:4:9: [[points]] 1 has no joint 'tail' to be at; there are "},
        {name + point + "joint = \"head\"\noffset_m = [1, 2]", "'offset_m' of 2 numbers instead of 3"},
        {name + point + "joint = \"head\"\n" + point + "joint = \"neck\"", "is a second point 'a'"},
        {name + point + "joint = \"head\"\n[[lines]]\nfrom = \"a\"\nto = \"b\"",
         "k.toml:7:6: [[lines]] 1 has no point 'b' to end at"},
        {name + point + "joint = \"head\"\nsize = 3", "unknown key 'size'"},
    };
    for (const auto &[text, sentence] : wrong)
        EXPECT_NE(refusal_of_points(text).find(sentence), std::string::npos) << text << "\n" << refusal_of_points(text);
}

TEST(JointNames, HaveBothSidesOfWhatPeopleHaveTwice)
{
    const std::vector<std::string> &all = labels::joint_names();
    const auto has = [&](const char *name) { return std::find(all.begin(), all.end(), name) != all.end(); };
    EXPECT_TRUE(has("head") && has("pelvis") && has("left_knee") && has("right_knee"));
    EXPECT_FALSE(has("left_head") || has("knee"));
    for (const std::string &name : labels::smpl_keypoints().names) EXPECT_TRUE(has(name.c_str())) << name;
}

using Names = std::vector<const char *>;

// The nodes of a maker's left side by the joints that they are.
TEST(JointNames, OfDazPoserAndBipedsAreKnown)
{
    const Names joints = {"pelvis",    "spine1",      "spine2",        "spine3",     "neck",
                          "head",      "left_collar", "left_shoulder", "left_elbow", "left_wrist",
                          "left_hand", "left_hip",    "left_knee",     "left_ankle", "left_foot"};
    for (const Names &nodes :
         {Names{"pelvis", "abdomen", "abdomen2", "chest", "neck", "head", "lCollar", "lShldr", "lForeArm", "lHand",
                "lMid1", "lThigh", "lShin", "lFoot", "lToe"},
          Names{"pelvis", "abdomenLower", "abdomenUpper", "chestUpper", "neckLower", "head", "lCollar", "lShldrBend",
                "lForearmBend", "lHand", "lMid1", "lThighBend", "lShin", "lFoot", "lToe"},
          Names{"pelvis", "", "", "", "neck1", "head", "l_shoulder", "l_upperarm", "l_forearm", "l_hand", "l_mid1",
                "l_thigh", "l_shin", "l_foot", "l_toes"},
          Names{"Bip001 Pelvis", "Bip001 Spine", "Bip001 Spine1", "Bip001 Spine2", "Bip001 Neck", "Bip001 Head",
                "Bip001 L Clavicle", "Bip001 L UpperArm", "Bip001 L Forearm", "Bip001 L Hand", "Bip001 L Finger2",
                "Bip001 L Thigh", "Bip001 L Calf", "Bip001 L Foot", "Bip001 L Toe0"}}) {
        std::map<std::string, uint32_t> plain;
        for (uint32_t i = 0; i < nodes.size(); ++i) plain.emplace(labels::plain_name(nodes[i]), i);
        for (uint32_t i = 0; i < nodes.size(); ++i)
            if (*nodes[i] != 0) EXPECT_EQ(labels::find_joint(plain, joints[i]), i) << nodes[i];
    }
}

}  // namespace
