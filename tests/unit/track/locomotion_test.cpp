// What is measured of a walk, against what the built-in clips were written with, and names of legs.
#include "lib/track/locomotion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/figures/figure.h"
#include "lib/track/clip_checks.h"
#include "meshsplit/build.h"
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

TEST(Locomotion, FindsThatEachFootOfATurnOnTheSpotIsLiftedAndNeverBoth)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    ASSERT_EQ(citizen.turn_cells.size(), track::phase_count);
    int carry[2] = {0, 0}, none = 0;
    for (const track::GaitCell &cell : citizen.turn_cells) {
        for (int f = 0; f < 2; ++f) {
            EXPECT_TRUE(cell.supports[f] == 0 || cell.supports[f] == 1);
            carry[f] += cell.supports[f] > 0;
        }
        none += cell.supports[0] + cell.supports[1] == 0;
    }
    EXPECT_EQ(none, 0);
    for (const int phases : carry) {
        EXPECT_GT(phases, int(track::phase_count) / 2) << "it stands longer than it steps";
        EXPECT_LT(phases, int(track::phase_count));
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

// Each clip by itself: a clip that does not exist, and one of no length where the clip has to move.
TEST(Locomotion, RefusesEachWrongClipByItsName)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    model::Template still(std::pmr::get_default_resource());
    for (const figures::Builtin &builtin : figures::builtins())
        if (std::string("citizen") == builtin.name) meshsplit::build(builtin.make(), {}, still);
    const uint32_t of_no_length = static_cast<uint32_t>(still.rig.clips.size());
    still.rig.clips.push_back(still.rig.clips[citizen.clips.idles[0]]);
    still.rig.clips.back().duration_s = 0;
    still.rig.clip_names.emplace_back("still");
    const struct {
        const char *name;
        uint32_t track::LocomotionClips::*clip;
    } all[] = {{"walk", &track::LocomotionClips::walk},
               {"run", &track::LocomotionClips::run},
               {"slow walk", &track::LocomotionClips::slow},
               {"turn", &track::LocomotionClips::turn}};
    const auto said = [&](const track::LocomotionClips &clips) -> std::string {
        try {
            track::check_clips(still, clips);
        } catch (const base::Error &error) {
            return error.what();
        }
        return "";
    };
    const auto begins = [](const std::string &text, const std::string &with) { return text.rfind(with, 0) == 0; };
    for (const auto &one : all) {
        track::LocomotionClips clips = citizen.clips;
        for (const uint32_t number : {of_no_length + 1, 1000u}) {
            clips.*one.clip = number;
            EXPECT_TRUE(
                begins(said(clips), "the " + std::string(one.name) + " is clip " + std::to_string(number) + " of "))
                << said(clips);
        }
        clips.*one.clip = of_no_length;
        EXPECT_TRUE(begins(said(clips), "the " + std::string(one.name) + " is clip " + std::to_string(of_no_length)))
            << said(clips);
        EXPECT_NE(said(clips).find("which has no length"), std::string::npos) << said(clips);
    }
    track::LocomotionClips clips = citizen.clips;
    clips.idle_count = 1, clips.idles[0] = of_no_length;
    EXPECT_EQ(said(clips), "") << "one stands with a pose";
    clips.idles[0] = 1000;
    EXPECT_TRUE(begins(said(clips), "the standing clip is clip 1000 of ")) << said(clips);
    clips.idle_count = track::max_idles + 1;
    EXPECT_TRUE(begins(said(clips), "5 clips to stand with: at most 4 are possible")) << said(clips);
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

TEST(LegNames, ThatAreMissingAreNamed)
{
    try {
        legs_of(rig_of({{"root", -1}, {"thigh_l", 0}, {"shin_l", 1}, {"foot_l", 2}, {"thigh_r", 0}, {"foot_r", 4}}));
        ADD_FAILURE() << "accepted";
    } catch (const base::Error &error) {
        EXPECT_NE(std::string(error.what()).find("right shin"), std::string::npos) << error.what();
    }
}
