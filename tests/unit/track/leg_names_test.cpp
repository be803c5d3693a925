// Legs are found by the names of nodes, as common tools write them.
#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/track/locomotion.h"

using namespace claque;

namespace
{

model::Rig rig_of(const std::vector<std::pair<const char *, int>> &nodes)
{
    model::Rig rig;
    for (const auto &[name, parent] : nodes) {
        rig.parents.push_back(parent < 0 ? model::none : static_cast<uint32_t>(parent));
        rig.rest.emplace_back();
        rig.node_names.emplace_back(name);
    }
    return rig;
}

std::vector<uint32_t> legs_of(const model::Rig &rig)
{
    track::LocomotionClips clips;
    track::find_legs(rig, clips);
    return {clips.legs[0], clips.legs[0] + 4};
}

}  // namespace

TEST(LegNames, OfCommonToolsAreFound)
{
    using Names = std::vector<std::pair<const char *, int>>;
    const std::vector<Names> rigs = {{{"mixamorig:Hips", -1},
                                      {"mixamorig:LeftUpLeg", 0},
                                      {"mixamorig:LeftLeg", 1},
                                      {"mixamorig:LeftFoot", 2},
                                      {"mixamorig:LeftToeBase", 3},
                                      {"mixamorig:RightUpLeg", 0},
                                      {"mixamorig:RightLeg", 5},
                                      {"mixamorig:RightFoot", 6},
                                      {"mixamorig:RightToeBase", 7}},
                                     {{"pelvis", -1},
                                      {"thigh_l", 0},
                                      {"calf_l", 1},
                                      {"foot_l", 2},
                                      {"ball_l", 3},
                                      {"thigh_r", 0},
                                      {"calf_r", 5},
                                      {"foot_r", 6},
                                      {"ball_r", 7}},
                                     {{"hips", -1},
                                      {"upperleg.l", 0},
                                      {"lowerleg.l", 1},
                                      {"foot.l", 2},
                                      {"toes.l", 3},
                                      {"upperleg.r", 0},
                                      {"lowerleg.r", 5},
                                      {"foot.r", 6},
                                      {"toes.r", 7}},
                                     {{"J_Bip_C_Hips", -1},
                                      {"J_Bip_L_UpperLeg", 0},
                                      {"J_Bip_L_LowerLeg", 1},
                                      {"J_Bip_L_Foot", 2},
                                      {"J_Bip_L_ToeBase", 3},
                                      {"J_Bip_R_UpperLeg", 0},
                                      {"J_Bip_R_LowerLeg", 5},
                                      {"J_Bip_R_Foot", 6},
                                      {"J_Bip_R_ToeBase", 7}},
                                     {{"Hips", -1},
                                      {"Left leg", 0},
                                      {"Left knee", 1},
                                      {"Left ankle", 2},
                                      {"Left toe", 3},
                                      {"Right leg", 0},
                                      {"Right knee", 5},
                                      {"Right ankle", 6},
                                      {"Right toe", 7}},
                                     {{"Hips", -1},
                                      {"UpLeg_Left", 0},
                                      {"Leg_Left", 1},
                                      {"Foot_Left", 2},
                                      {"Toe_Left", 3},
                                      {"UpLeg_Right", 0},
                                      {"Leg_Right", 5},
                                      {"Foot_Right", 6},
                                      {"Toe_Right", 7}},
                                     {{"root", -1},
                                      {"thigh.L", 0},
                                      {"shin.L", 1},
                                      {"foot.L", 2},
                                      {"toe.L", 3},
                                      {"thigh.R", 0},
                                      {"shin.R", 5},
                                      {"foot.R", 6},
                                      {"toe.R", 7}}};
    for (const Names &names : rigs) {
        track::LocomotionClips clips;
        ASSERT_NO_THROW(track::find_legs(rig_of(names), clips)) << names[1].first;
        for (uint32_t part = 0; part < 4; ++part) {
            EXPECT_EQ(clips.legs[0][part], 1 + part) << names[1].first;
            EXPECT_EQ(clips.legs[1][part], 5 + part) << names[1].first;
        }
    }
    // A knee pad makes no thigh of Mixamo's shin.
    const std::vector<uint32_t> padded = legs_of(rig_of({{"Hips", -1},
                                                         {"LeftUpLeg", 0},
                                                         {"LeftLeg", 1},
                                                         {"LeftKneePad", 2},
                                                         {"LeftFoot", 2},
                                                         {"RightUpLeg", 0},
                                                         {"RightLeg", 5},
                                                         {"RightFoot", 6}}));
    EXPECT_EQ(padded, (std::vector<uint32_t>{1, 2, 4, model::none}));
    // Feet on the root, as rigs for inverse kinematics have them; without toes.
    const std::vector<uint32_t> left = legs_of(rig_of({{"Bone", -1},
                                                       {"Foot.L", 0},
                                                       {"UpperLeg.L", 0},
                                                       {"LowerLeg.L", 2},
                                                       {"PoleTarget.L", 0},
                                                       {"Foot.R", 0},
                                                       {"UpperLeg.R", 0},
                                                       {"LowerLeg.R", 6}}));
    EXPECT_EQ(left, (std::vector<uint32_t>{2, 3, 1, model::none}));
}

// As RobotExpressive has them: a mesh "Leg.L" hangs on the thigh before the shin, and the feet hang on the root. Meshes
// are parts of the palette with the identity, joints with the inverse of their place.
TEST(LegNames, OfJointsComeBeforeThoseOfMeshesThatHangOnThem)
{
    const auto robot = [](bool skinned) {
        model::Rig rig = rig_of({{"Bone", -1},
                                 {"Foot.L", 0},
                                 {"Foot.L", 1},
                                 {"UpperLeg.L", 0},
                                 {"Leg.L", 3},
                                 {"LowerLeg.L", 3},
                                 {"LowerLeg.L", 5},
                                 {"Foot.R", 0},
                                 {"Foot.R", 7},
                                 {"UpperLeg.R", 0},
                                 {"Leg.R", 9},
                                 {"LowerLeg.R", 9},
                                 {"LowerLeg.R", 11}});
        for (const uint32_t mesh : {2u, 4u, 6u, 8u, 10u, 12u}) rig.palette.push_back({mesh, math::Affine()});
        math::Affine bind;
        bind.set_column(3, glm::vec3(0, -1, 0));
        if (skinned)
            for (const uint32_t joint : {1u, 3u, 5u, 7u, 9u, 11u}) rig.palette.push_back({joint, bind});
        return rig;
    };
    for (const bool skinned : {true, false}) {
        track::LocomotionClips clips;
        track::find_legs(robot(skinned), clips);
        for (uint32_t side = 0; side < 2; ++side) {
            EXPECT_EQ(clips.legs[side][0], 3 + 6 * side) << skinned;
            EXPECT_EQ(clips.legs[side][1], 5 + 6 * side) << skinned;
            EXPECT_EQ(clips.legs[side][2], 1 + 6 * side) << skinned;
        }
    }
}

TEST(LegNames, OfOneChainComeBeforeOthers)
{
    const std::vector<std::pair<const char *, int>> nodes = {
        {"root", -1},  {"foot_l", 0},  {"thigh_l", 0}, {"thigh_l", 0}, {"calf_l", 3}, {"calf_l", 3}, {"foot_l", 5},
        {"foot_r", 0}, {"thigh_r", 0}, {"thigh_r", 0}, {"calf_r", 9},  {"calf_r", 9}, {"foot_r", 11}};
    EXPECT_EQ(legs_of(rig_of(nodes)), (std::vector<uint32_t>{3, 5, 6, model::none}));
}

std::string refusal_of(const std::vector<std::pair<const char *, int>> &nodes, const char *walk = "walk")
{
    model::Rig rig = rig_of(nodes);
    rig.clip_names.emplace_back(walk);
    track::LocomotionClips clips;
    clips.walk = 0;
    try {
        track::find_legs(rig, clips);
    } catch (const base::Error &error) {
        return error.what();
    }
    return "";
}

// As Kenney's figures of blocks have them, and others without knees or ankles.
TEST(LegNames, OfLegsWithoutKneesHaveNoRemedy)
{
    const std::string one = refusal_of({{"root", -1}, {"leg-left", 0}, {"leg-right", 0}, {"arm-left", 0}});
    EXPECT_NE(one.find("each leg is one node ('leg-left', 'leg-right')"), std::string::npos) << one;
    const std::string kneeless =
        refusal_of({{"root", -1}, {"thigh_l", 0}, {"foot_l", 1}, {"thigh_r", 0}, {"foot_r", 3}});
    EXPECT_NE(kneeless.find("each leg is two nodes ('thigh_l' with 'foot_l', 'thigh_r' with 'foot_r')"),
              std::string::npos)
        << kneeless;
    const std::string footless = refusal_of({{"root", -1},
                                             {"leg_upper.R", 0},
                                             {"leg_lower.R", 1},
                                             {"leg_lower.R_end", 2},
                                             {"leg_upper.L", 0},
                                             {"leg_lower.L", 4}});
    EXPECT_NE(footless.find("two nodes ('leg_upper.L' with 'leg_lower.L', 'leg_upper.R' with 'leg_lower.R')"),
              std::string::npos)
        << footless;
    for (const std::string &said : {one, kneeless, footless}) {
        EXPECT_NE(said.find("'claque render FILE --clip walk'"), std::string::npos) << said;
        EXPECT_EQ(said.find("--legs"), std::string::npos) << said;
    }
}

TEST(LegNames, ThatAreMissingAreNamedBesideTheOthersAndTheRemedies)
{
    const std::string strange = refusal_of(
        {{"root", -1}, {"thigh_l", 0}, {"shin_l", 1}, {"foot_l", 2}, {"thigh_r", 0}, {"K", 4}, {"foot_r", 5}});
    EXPECT_NE(strange.find("like a right shin, though 'thigh_r' is like a thigh and 'foot_r' is like a foot: name the "
                           "nodes of the legs (legs of a scenario's class, --legs of the command"),
              std::string::npos)
        << strange;
    const std::string wolf = refusal_of({{"Bone", -1}, {"Bone.001", 0}, {"Bone.002", 1}}, "Rig|Walk");
    EXPECT_NE(wolf.find("no node is named like a left thigh: name the nodes"), std::string::npos) << wolf;
    EXPECT_NE(wolf.find("without them 'claque render FILE --clip \"Rig|Walk\"' shows its clips on the spot"),
              std::string::npos)
        << wolf;
}

// As KayKit's characters have it: a mesh of that name hangs beside the skeleton, before the joint.
TEST(HeadNames, OfJointsComeBeforeThoseOfMeshes)
{
    const auto head_of = [](const std::vector<std::pair<const char *, int>> &nodes,
                            std::initializer_list<uint32_t> skin, uint32_t rigid = model::none) {
        model::Rig rig = rig_of(nodes);
        math::Affine bind;
        bind.set_column(3, glm::vec3(0, -1, 0));
        for (const uint32_t joint : skin) rig.palette.push_back({joint, bind});
        if (rigid != model::none) rig.palette.push_back({rigid, math::Affine()});
        track::LocomotionClips clips;
        track::find_upper(rig, clips);
        return clips.head == model::none ? "" : std::string(rig.node_names[clips.head]);
    };
    EXPECT_EQ(head_of({{"Rig", -1}, {"Mage_Head", 0}, {"chest", 0}, {"head", 2}}, {2, 3}), "head");
    EXPECT_EQ(head_of({{"Rig", -1}, {"Mage_Head", 0}, {"head", 0}}, {}, 1), "head");
    EXPECT_EQ(head_of({{"Rig", -1}, {"head", 0}, {"head_ear_l", 1}}, {2}), "head") << "of a chain the topmost";
    EXPECT_EQ(head_of({{"Rig", -1}, {"Head", 0}}, {}, 1), "Head") << "of blocks";
}

// Every way to name a side with every word for each part; controls, which no leg has, come first.
TEST(LegNames, OfEachSideAndPartAreFound)
{
    const char *const parts[4][4] = {{"thigh", "UpLeg", "UpperLeg", "legUpper"},
                                     {"shin", "calf", "LowerLeg", "legLower"},
                                     {"foot", "ankle", "foot", "ankle"},
                                     {"toe", "ball", "Toes", "toe"}};
    const std::pair<const char *, const char *> sides[][2] = {
        {{"Left", ""}, {"Right", ""}}, {{"", "_left"}, {"", "_right"}}, {{"left ", ""}, {"right ", ""}},
        {{"", ".L"}, {"", ".R"}},      {{"l_", ""}, {"r_", ""}},        {{"x-L-", ""}, {"x-R-", ""}},
        {{"", "_l"}, {"", "_r"}},      {{"", "L"}, {"", "R"}}};
    for (const auto &side : sides)
        for (int words = 0; words < 4; ++words) {
            std::vector<std::string> texts;
            std::vector<std::pair<const char *, int>> nodes = {{"root", -1}};
            for (int s = 0; s < 2; ++s)
                for (int part = 0; part < 4; ++part)
                    texts.push_back(side[s].first + std::string(parts[part][words]) + side[s].second);
            std::vector<std::string> controls;
            for (const char *word : {"twist", "ik", "pole", "roll", "control", "ctrl", "target", "end", "helper"})
                for (const std::string &text : texts) controls.push_back(std::string(word) + "_" + text);
            for (const std::string &control : controls) nodes.emplace_back(control.c_str(), 0);
            const int first = static_cast<int>(nodes.size());
            for (int k = 0; k < 8; ++k) nodes.emplace_back(texts[size_t(k)].c_str(), k % 4 ? first + k - 1 : 0);
            track::LocomotionClips clips;
            ASSERT_NO_THROW(track::find_legs(rig_of(nodes), clips)) << texts[0];
            for (uint32_t s = 0; s < 2; ++s)
                for (uint32_t part = 0; part < 4; ++part)
                    EXPECT_EQ(clips.legs[s][part], uint32_t(first) + 4 * s + part) << texts[4 * s + part];
        }
}
