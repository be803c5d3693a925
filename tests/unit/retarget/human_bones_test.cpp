// Skeletons of people with other names are bound as bodies by the names of the usual programs.
#include "lib/retarget/human_bones.h"

#include <map>

#include <gtest/gtest.h>

#include "lib/retarget/retarget.h"
#include "resting_rigs.h"

namespace claque::testing
{
namespace
{

using Names = std::map<std::string, std::string>;  // of joints of a body

// As those programs write them, and as claque does.
const std::vector<std::pair<const char *, Names>> &conventions()
{
    static const std::vector<std::pair<const char *, std::vector<std::string>>> rows = {
        {"claque", {"pelvis", "spine", "head", "upper_arm_l", "forearm_l", "hand_l", "thigh_l", "shin_l", "foot_l"}},
        {"Mixamo",
         {"mixamorig:Hips", "mixamorig:Spine", "mixamorig:Head", "mixamorig:LeftArm", "mixamorig:LeftForeArm",
          "mixamorig:LeftHand", "mixamorig:LeftUpLeg", "mixamorig:LeftLeg", "mixamorig:LeftFoot"}},
        {"LAFAN1", {"Hips", "Spine", "Head", "LeftArm", "LeftForeArm", "LeftHand", "LeftUpLeg", "LeftLeg", "LeftFoot"}},
        {"Bandai-Namco",
         {"Hips", "Spine", "Head", "UpperArm_L", "LowerArm_L", "Hand_L", "UpperLeg_L", "LowerLeg_L", "Foot_L"}},
        {"Unreal", {"pelvis", "spine_01", "head", "upperarm_l", "lowerarm_l", "hand_l", "thigh_l", "calf_l", "foot_l"}},
        {"KayKit",
         {"hips", "spine", "head", "upperarm.l", "lowerarm.l", "wrist.l", "upperleg.l", "lowerleg.l", "foot.l"}},
        {"VRoid",
         {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_Head", "J_Bip_L_UpperArm", "J_Bip_L_LowerArm", "J_Bip_L_Hand",
          "J_Bip_L_UpperLeg", "J_Bip_L_LowerLeg", "J_Bip_L_Foot"}},
        {"Biped",
         {"Bip01 Pelvis", "Bip01 Spine", "Bip01 Head", "Bip01 L UpperArm", "Bip01 L Forearm", "Bip01 L Hand",
          "Bip01 L Thigh", "Bip01 L Calf", "Bip01 L Foot"}},
        {"Maya", {"pelvis28", "spine1", "head1", "l_shoulder1", "l_elbow1", "l_hand1", "l_hip1", "l_knee1", "l_foot1"}},
        {"VRChat",
         {"Hips", "Spine", "Head", "Left arm", "Left elbow", "Left wrist", "Left leg", "Left knee", "Left ankle"}},
        {"sides last",
         {"Hips", "Spine", "Head", "Arm_Left", "ForeArm_Left", "Hand_Left", "UpLeg_Left", "Leg_Left", "Foot_Left"}},
        {"Poser", {"hip", "abdomen", "head", "lShldr", "lForeArm", "lHand", "lThigh", "lShin", "lFoot"}}};
    const std::vector<std::string> parts = {"hips",  "spine", "head",  "arm.", "elbow.",
                                            "hand.", "leg.",  "knee.", "foot."};
    static const std::vector<std::pair<const char *, Names>> out = [&] {
        std::vector<std::pair<const char *, Names>> made;
        for (const auto &[program, names] : rows) {
            Names one;
            for (size_t i = 0; i < parts.size(); ++i) {
                if (i < 3) one[parts[i]] = names[i];
                else one[parts[i] + "l"] = names[i];
                std::string right = names[i];
                const size_t word = right.find("Left"), letter = right.find_last_of("lL");
                if (word != std::string::npos) right.replace(word, 4, "Right");
                else if (right.find("J_Bip_L") == 0) right[6] = 'R';
                else if (std::string(program) == "Poser" || std::string(program) == "Maya") right[0] = 'r';
                else if (right.find("Bip01 L") == 0) right[6] = 'R';
                else if (letter != std::string::npos) right[letter] = right[letter] == 'l' ? 'r' : 'R';
                if (i >= 3) one[parts[i] + "r"] = right;
            }
            made.emplace_back(program, one);
        }
        return made;
    }();
    return out;
}

model::Rig named(model::Rig rig, const Names &names)
{
    for (std::pmr::string &name : rig.node_names) name = names.at(std::string(name)).c_str();
    return rig;
}

}  // namespace

TEST(HumanBones, OfEachConventionMoveAPersonOfEachOther)
{
    for (const auto &[from, source_names] : conventions())
        for (const auto &[to, target_names] : conventions()) {
            const model::Rig clips = named(rig_with_motion(person(1, 0)), source_names);
            model::Rig target = named(rig_of(person(1, 0)), target_names);
            const retarget::Report report = retarget::add_clips(target, clips, {});
            EXPECT_EQ(report.joint_count, 15u) << from << " to " << to;
            for (uint32_t k = 0; k < 12; ++k)
                for (uint32_t i = 0; i < target.node_count(); ++i)
                    EXPECT_LT(glm::distance(posed(clips, 0, k).places[i], posed(target, 0, k).places[i]), 1e-5)
                        << from << " to " << to << " " << target.node_names[i];
        }
}

TEST(HumanBones, AreNotGuessedForBodiesWithoutLegs)
{
    std::vector<Bone> bones;
    for (const Bone &bone : person(1, 0))
        if (std::string(bone.name).find("knee") != 0 && std::string(bone.name).find("foot") != 0) bones.push_back(bone);
    const Names names = conventions()[1].second;
    const model::Rig source = named(rig_with_motion(bones), names),
                     target = named(rig_of(bones), conventions()[3].second);
    EXPECT_TRUE(retarget::bind_human(target, source, {}).matches.empty());
}

TEST(HumanBones, LetSkirtsFollowTheThighs)
{
    std::vector<Bone> bones = person(1, 0);
    bones.push_back({"skirt_l", "hips", {0.1f, 0, 0.1f}});
    Names names = conventions()[0].second;
    names["skirt_l"] = "skirt_l";
    const retarget::HumanBinding bound = retarget::bind_human(
        named(rig_of(bones), names), named(rig_with_motion(person(1, 0)), conventions()[1].second), {});
    ASSERT_EQ(bound.followers.size(), 2u);
    EXPECT_EQ(bound.followers[0].leader, "thigh_l");
    EXPECT_EQ(bound.followers[1].leader, "thigh_r");
    EXPECT_GT(bound.followers[0].share, bound.followers[1].share);
}

namespace
{

// The joint of `target` that each joint of a person of Mixamo is bound to.
Names bound_to(const std::vector<Bone> &bones, const Names &names)
{
    const model::Rig target = named(rig_of(bones), names),
                     source = named(rig_with_motion(person(1, 0)), conventions()[1].second);
    Names out;
    for (const retarget::JointMatch &match : retarget::bind_human(target, source, {}).matches)
        out[std::string(source.node_names[match.source])] = std::string(target.node_names[match.target]);
    return out;
}

}  // namespace

// As Bob of Doom 3, whose pelvis carries the spine, and as a skeleton that names no hips.
TEST(HumanBones, BindTheHipsToTheJointAboveBothLegs)
{
    std::vector<Bone> bones = person(1, 0);
    bones[1].parent = "back";
    bones.insert(bones.begin() + 1, {"back", "hips", {0, 0.05f, 0}});
    Names names = conventions()[4].second;
    names["hips"] = "pubis", names["back"] = "pelvis";
    Names bound = bound_to(bones, names);
    EXPECT_EQ(bound["mixamorig:Hips"], "pubis");
    EXPECT_EQ(bound["mixamorig:Spine"], "spine_01");
    names["hips"] = "bind_0001", names["back"] = "bind_0002";
    bound = bound_to(bones, names);
    EXPECT_EQ(bound["mixamorig:Hips"], "bind_0001");
    EXPECT_EQ(bound["mixamorig:Head"], "head");
    EXPECT_EQ(bound.size(), 15u);
}

// Meshes and control rigs beside the skeleton may have the names of its joints.
TEST(HumanBones, AreJointsOfSkinsBeforeOtherNodesOfTheirNames)
{
    std::vector<Bone> bones = person(1, 0);
    bones.insert(bones.begin() + 1, {"beside", "hips", {0, 0.4f, 0.2f}});
    Names names = conventions()[0].second;
    for (const char *name : {"arm.l", "leg.l", "knee.l"}) {
        names["beside"] = names[name];
        const std::string limb = names[name];
        Names others = names;
        others[name] = "other " + limb;  // the same part of the body
        model::Rig target = named(rig_of(bones), others);
        target.palette.clear();
        for (uint32_t i = 0; i < target.node_count(); ++i) {
            if (std::string(target.node_names[i]) == limb) continue;
            target.palette.push_back({});
            target.palette.back().node = i, target.palette.back().inverse_bind.c[9] = -1;
        }
        const model::Rig source = named(rig_with_motion(person(1, 0)), conventions()[1].second);
        bool is_bound = false;
        for (const retarget::JointMatch &match : retarget::bind_human(target, source, {}).matches) {
            EXPECT_NE(std::string(target.node_names[match.target]), limb);
            is_bound = is_bound || std::string(target.node_names[match.target]) == others[name];
        }
        EXPECT_TRUE(is_bound) << limb;
    }
}

TEST(HumanBones, NameTheLimbsThatAreNotBound)
{
    const model::Rig source = named(rig_with_motion(person(1, 0)), conventions()[1].second);
    Names names = conventions()[0].second;
    EXPECT_TRUE(retarget::bind_human(named(rig_of(person(1, 0)), names), source, {}).unbound.empty());
    names["hand.r"] = "claw";
    const retarget::HumanBinding bound = retarget::bind_human(named(rig_of(person(1, 0)), names), source, {});
    EXPECT_EQ(bound.unbound, std::vector<std::string>{"rightHand"});
}

TEST(HumanBones, SwapLeftAndRightOfAMirroredSkeleton)
{
    for (const float left : {1.0f, -1.0f}) {
        std::vector<Bone> bones = person(1, 0);
        for (Bone &bone : bones) bone.offset.x *= left;
        bones.push_back({"toe.l", "foot.l", {0, -0.05f, 0.1f}}),
            bones.push_back({"toe.r", "foot.r", {0, -0.05f, 0.1f}});
        Names names = conventions()[0].second;
        names["toe.l"] = "toes_l", names["toe.r"] = "toes_r";
        Names bound = bound_to(bones, names);
        EXPECT_EQ(bound["mixamorig:LeftUpLeg"], left > 0 ? "thigh_l" : "thigh_r");
        EXPECT_EQ(bound["mixamorig:RightHand"], left > 0 ? "hand_r" : "hand_l");
        EXPECT_EQ(bound.size(), 15u);
        // All bones along z are no pose, whatever they look like.
        for (Bone &bone : bones)
            if (const std::string name = bone.name; name.find("leg") != 0)
                bone.offset = {0, 0, glm::length(bone.offset)};
        EXPECT_EQ(bound_to(bones, names)["mixamorig:LeftUpLeg"], "thigh_l");
    }
}

TEST(HumanBones, BindTheEndsOfSpinesOfOtherLengths)
{
    const auto with_spine = [](std::vector<std::string> spine, const Names &names) {
        model::Rig rig = named(rig_with_motion(person(1, 0)), names);
        // The spine of the body becomes the last joint, below new ones.
        model::Rig out;
        out.parents.push_back(model::none), out.rest.push_back(rig.rest[0]),
            out.node_names.push_back(rig.node_names[0]);
        for (const std::string &name : spine) {
            out.parents.push_back(out.node_count() - 1);
            out.rest.emplace_back();
            out.node_names.emplace_back(name.c_str());
        }
        const uint32_t more = static_cast<uint32_t>(spine.size()) - 1;
        for (uint32_t i = 2; i < rig.node_count(); ++i) {
            out.parents.push_back(rig.parents[i] == 0 ? 0 : rig.parents[i] + more);
            out.rest.push_back(rig.rest[i]);
            out.node_names.push_back(rig.node_names[i]);
        }
        return out;
    };
    const model::Rig target = with_spine({"spine", "spine_upper", "chest"}, conventions()[0].second);
    const auto bound = [&](const std::vector<std::string> &spine) {
        const model::Rig source = with_spine(spine, conventions()[2].second);
        std::map<std::string, std::string> out;
        for (const retarget::JointMatch &match : retarget::bind_human(target, source, {}).matches)
            out[std::string(target.node_names[match.target])] = std::string(source.node_names[match.source]);
        return out;
    };
    auto three = bound({"LowerBack", "Spine", "Spine1"});
    EXPECT_EQ(three["spine"], "LowerBack");
    EXPECT_EQ(three["spine_upper"], "Spine");
    EXPECT_EQ(three["chest"], "Spine1");
    auto five = bound({"Spine", "Spine1", "Spine2", "Spine3", "Chest"});
    EXPECT_EQ(five["spine"], "Spine");
    EXPECT_EQ(five["spine_upper"], "Spine2");
    EXPECT_EQ(five["chest"], "Chest");
    auto two = bound({"Spine", "Chest"});
    EXPECT_EQ(two["spine"], "Spine");
    EXPECT_EQ(two["chest"], "Chest");
    EXPECT_EQ(two.count("spine_upper"), 0u);
    auto single = bound({"Spine"});
    EXPECT_EQ(single["chest"], "Spine");
    EXPECT_EQ(single.count("spine"), 0u);
}

}  // namespace claque::testing
