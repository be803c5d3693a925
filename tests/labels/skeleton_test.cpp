// Keypoints of characters of several makers: each is found, and lies where that part of a body is.
#include "samples/labels/skeleton.h"

#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/labels/vrm_skeleton.h"
#include "tests/support/collected_file.h"

namespace
{

using labels::Skeletons;
using scenes::check;

// Positions by keypoint, in the rest pose.
std::map<std::string, std::array<double, 3>> rest_points(scenes::Library &library, clq_template *tmpl,
                                                         const labels::KeypointSet &set)
{
    Skeletons skeletons(library, set);
    const Skeletons::Skeleton &skeleton = skeletons.of(tmpl);
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(library.context(), nullptr, &crowd));
    const scenes::Own<clq_crowd> owner(crowd);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = tmpl, def.play.clip = CLQ_NONE;
    clq_actor actor = {};
    check(clq_actor_create(crowd, &def, &actor));
    std::map<std::string, std::array<double, 3>> out;
    for (size_t i = 0; i < set.names.size(); ++i) {
        const Skeletons::Place &place = skeleton.places[i];
        if (place.node == CLQ_NONE) continue;
        double m[16];
        check(clq_actor_get_node(crowd, actor, place.node, 0, m));
        for (size_t k = 0; k < 3; ++k)
            out[set.names[i]][k] = m[12 + k] + m[k] * place.at[0] + m[4 + k] * place.at[1] + m[8 + k] * place.at[2];
    }
    return out;
}

// Up to down, and left (+x) to right.
void expect_body(const std::map<std::string, std::array<double, 3>> &at)
{
    for (const std::string side : {"left_", "right_"}) {
        const double sign = side == "left_" ? 1 : -1;
        EXPECT_GT(at.at(side + "shoulder")[1], at.at(side + "hip")[1]) << side;
        EXPECT_GT(at.at(side + "hip")[1], at.at(side + "knee")[1]) << side;
        EXPECT_GT(at.at(side + "knee")[1], at.at(side + "ankle")[1]) << side;
        EXPECT_GT(sign * at.at(side + "shoulder")[0], 0) << side;
        EXPECT_GT(sign * at.at(side + "elbow")[0], sign * at.at(side + "shoulder")[0] - 0.05) << side;
        EXPECT_GT(sign * at.at(side + "wrist")[0], 0) << side;
        EXPECT_GT(sign * at.at(side + "eye")[0], 0) << side;
        EXPECT_GT(at.at("nose")[1], at.at(side + "shoulder")[1]) << side;
        EXPECT_GT(at.at("nose")[2], at.at(side + "ear")[2]) << side;
    }
}

TEST(Keypoints, OfBuiltInPeopleAreTheirJoints)
{
    scenes::Library library(1);
    for (const char *name : {"citizen", "patrician", "decurion", "plebeian"}) {
        SCOPED_TRACE(name);
        const auto at = rest_points(library, library.builtin(name), labels::coco_keypoints());
        ASSERT_EQ(at.size(), 17u);
        expect_body(at);
        EXPECT_EQ(rest_points(library, library.builtin(name), labels::smpl_keypoints()).size(), 24u);
    }
}

// Whatever their hair: lib/figures paints the eyes of all four at the same place.
TEST(Keypoints, OfFacesAreWhereTheFacesArePainted)
{
    scenes::Library library(1);
    for (const char *name : {"citizen", "patrician", "decurion", "plebeian"}) {
        SCOPED_TRACE(name);
        const auto at = rest_points(library, library.builtin(name), labels::coco_keypoints());
        for (const std::string side : {"left_eye", "right_eye"}) {
            EXPECT_NEAR(at.at(side)[0], side == "left_eye" ? 0.0315 : -0.0315, 0.006);
            EXPECT_NEAR(at.at(side)[1], 1.6345, 0.006);
            EXPECT_NEAR(at.at(side)[2], 0.0895, 0.006);
        }
        EXPECT_NEAR(at.at("nose")[1], 1.597, 0.008);
        EXPECT_GT(at.at("nose")[2], at.at("left_eye")[2] + 0.02);
    }
}

TEST(Keypoints, OfAFileAreAtTheirJointsAndNodesWithTheirOffsets)
{
    const labels::KeypointSet set = labels::read_keypoints(R"(name = "own"
[[points]]
name = "elbow"
joint = "left_elbow"
[[points]]
name = "beside"
joint = "left_elbow"
offset_m = [0.1, 0.2, -0.3]
[[points]]
name = "glasses"
joint = "left_eye"
offset_m = [0, 0, 0.05]
[[points]]
name = "hip"
nodes = ["no such node", "thigh_r", "thigh_l"]
[[points]]
name = "wing"
nodes = ["no such node"]
)",
                                                           "k.toml");
    scenes::Library library(1);
    const auto at = rest_points(library, library.builtin("patrician"), set);
    const auto coco = rest_points(library, library.builtin("patrician"), labels::coco_keypoints());
    EXPECT_EQ(at.count("wing"), 0u);
    EXPECT_EQ(at.at("elbow"), coco.at("left_elbow"));
    const double offset[3] = {0.1, 0.2, -0.3};
    for (size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(at.at("beside")[k], coco.at("left_elbow")[k] + offset[k], 1e-6);
        EXPECT_NEAR(at.at("glasses")[k], coco.at("left_eye")[k] + (k == 2 ? 0.05 : 0), 1e-6);
        EXPECT_NEAR(at.at("hip")[k], coco.at("right_hip")[k], 1e-6);
    }
}

TEST(Keypoints, OfAnOwlAreAbsentOrItsOwn)
{
    scenes::Library library(1);
    const auto at = rest_points(library, library.builtin("owl"), labels::coco_keypoints());
    EXPECT_EQ(at.count("left_knee"), 0u);
}

class KeypointsOfFiles : public testing::TestWithParam<const char *>
{
};

TEST_P(KeypointsOfFiles, AreFoundByTheNamesOfTheirMakers)
{
    const std::string path = std::string(CLAQUE_ASSETS_DIR) + "/humanoids/" + GetParam();
    CLAQUE_NEEDS_FILE(path);
    scenes::Library library(1);
    clq_asset *asset = nullptr;
    check(clq_asset_load_file(library.context(), path.c_str(), nullptr, &asset));
    const scenes::Own<clq_asset> held(asset);
    clq_template *tmpl = nullptr;
    check(clq_asset_build(library.context(), asset, 0, &tmpl));
    const scenes::Own<clq_template> owner(tmpl);
    const auto at = rest_points(library, tmpl, labels::coco_keypoints());
    ASSERT_EQ(at.size(), 17u);
    expect_body(at);
}

INSTANTIATE_TEST_SUITE_P(Makers, KeypointsOfFiles,
                         testing::Values("kaykit/Barbarian.glb", "kaykit/Mage.glb",
                                         "quaternius-ultimate/Casual_Male.gltf", "quaternius-modular/Man_Suit.glb"));

// What VRoid Studio calls a bone of VRM: J_Bip_L_UpperArm for leftUpperArm.
std::string vroid_name(const std::string &bone)
{
    std::string side = "C", rest = bone;
    for (const char *word : {"left", "right"})
        if (bone.rfind(word, 0) == 0)
            side = word == std::string("left") ? "L" : "R", rest = bone.substr(std::strlen(word));
    rest[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(rest[0])));
    if (rest == "Toes") rest = "ToeBase";
    if (rest == "MiddleProximal") rest = "Middle1";
    return "J_Bip_" + side + "_" + rest;
}

TEST(Keypoints, OfSkeletonsOfVrmAreFoundByTheNamesOfItsBonesAndOfVroidStudio)
{
    scenes::Library library(1);
    for (const bool of_studio : {false, true}) {
        SCOPED_TRACE(of_studio ? "J_Bip_L_UpperArm" : "leftUpperArm");
        const std::vector<uint8_t> file =
            labels_test::vrm_skeleton([&](const std::string &bone) { return of_studio ? vroid_name(bone) : bone; });
        clq_asset *asset = nullptr;
        check(clq_asset_load(library.context(), file.data(), file.size(), nullptr, &asset));
        const scenes::Own<clq_asset> held(asset);
        clq_template *tmpl = nullptr;
        check(clq_asset_build(library.context(), asset, 0, &tmpl));
        const scenes::Own<clq_template> owner(tmpl);
        const auto coco = rest_points(library, tmpl, labels::coco_keypoints());
        ASSERT_EQ(coco.size(), 17u);
        expect_body(coco);
        const auto smpl = rest_points(library, tmpl, labels::smpl_keypoints());
        ASSERT_EQ(smpl.size(), 24u);
        const char *const upwards[] = {"pelvis", "spine1", "spine2", "spine3", "neck", "head"};
        for (size_t i = 1; i < 6; ++i) EXPECT_GT(smpl.at(upwards[i])[1], smpl.at(upwards[i - 1])[1]) << upwards[i];
        for (const std::string side : {"left_", "right_"}) {
            EXPECT_NEAR(std::abs(smpl.at(side + "hand")[0] - smpl.at(side + "wrist")[0]), 0.09, 1e-6);
            EXPECT_NEAR(smpl.at(side + "foot")[2] - smpl.at(side + "ankle")[2], 0.12, 1e-6);
            EXPECT_NEAR(std::abs(smpl.at(side + "shoulder")[0] - smpl.at(side + "collar")[0]), 0.12, 1e-6);
        }
    }
}

TEST(KeypointSets, HaveTheNumbersOfTheirPublications)
{
    EXPECT_EQ(labels::coco_keypoints().names.size(), 17u);
    EXPECT_EQ(labels::smpl_keypoints().names.size(), 24u);
    EXPECT_EQ(labels::coco_keypoints().edges.size(), 19u);
    EXPECT_EQ(labels::smpl_keypoints().edges.size(), 23u);
    try {
        labels::keypoint_set("openpose");
        FAIL();
    } catch (const scenes::Failure &failure) {
        EXPECT_STREQ(failure.what(), "there are no keypoints 'openpose'; there are coco, smpl, and files of your own");
    }
}

}  // namespace
