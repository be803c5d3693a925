// What is measured of a walk, against what the built-in clips were written with, and names of legs.
#include "lib/track/locomotion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "tests/unit/track/made_tracks.h"

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

TEST(Locomotion, MeasuresTheStrideThatTheWalkWasWrittenWith)
{
    const track::Locomotion &walk = test::locomotion_of("citizen");
    // lib/figures/clips/walk.cpp: 1.24 m a cycle while a foot carries weight.
    EXPECT_NEAR(walk.stride[track::walk_step], 1.24, 0.05);
    EXPECT_NEAR(walk.walking_speed(), 1.13, 0.05);
    EXPECT_GT(walk.running_speed(), 1.8);
}

TEST(Locomotion, FindsThatAFootCarriesWeightForTheGreaterPartOfAWalkAndTheLesserOfARun)
{
    const track::Locomotion &walk = test::locomotion_of("citizen");
    for (int f = 0; f < 2; ++f) {
        int walking = 0, running = 0;
        for (uint32_t p = 0; p < track::phase_count; ++p) {
            walking += walk.cell(track::walk_step, p).supports[f] > 0;
            running += walk.cell(track::gait_step_count - 1, p).supports[f] > 0;
        }
        EXPECT_NEAR(double(walking) / track::phase_count, 0.62, 0.08);
        EXPECT_LT(running, walking);
    }
}

TEST(Locomotion, OfAClipThatDoesNotWalkIsRefused)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    track::LocomotionClips clips = citizen.clips;
    clips.walk = citizen.clips.idles[0];
    track::Locomotion out(std::pmr::get_default_resource());
    EXPECT_THROW(track::measure(*citizen.tmpl, clips, out), base::Error);
    clips = citizen.clips, clips.run = citizen.clips.walk, clips.walk = citizen.clips.run;
    EXPECT_THROW(track::measure(*citizen.tmpl, clips, out), base::Error);
    clips = citizen.clips, clips.walk = 1000;
    EXPECT_THROW(track::measure(*citizen.tmpl, clips, out), base::Error);
    clips = citizen.clips, clips.legs[1][1] = clips.legs[0][1];
    EXPECT_THROW(track::measure(*citizen.tmpl, clips, out), base::Error);
}

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

TEST(LegNames, ThatAreMissingAreNamed)
{
    try {
        legs_of(rig_of({{"root", -1}, {"thigh_l", 0}, {"shin_l", 1}, {"foot_l", 2}, {"thigh_r", 0}, {"foot_r", 4}}));
        ADD_FAILURE() << "accepted";
    } catch (const base::Error &error) {
        EXPECT_NE(std::string(error.what()).find("right shin"), std::string::npos) << error.what();
    }
}
