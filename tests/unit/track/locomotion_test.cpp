// What is measured of a walk, against what the built-in clips were written with.
#include "lib/track/locomotion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/figures/figure.h"
#include "lib/track/clip_checks.h"
#include "meshsplit/build.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

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
    clips = citizen.clips;
    while (clips.idle_count < track::max_idles) clips.idles[clips.idle_count++] = clips.idles[0];
    EXPECT_EQ(said(clips), "");
    clips.run = clips.slow = clips.turn = model::none;
    EXPECT_EQ(said(clips), "") << "one that only walks";
    clips.idle_count = track::max_idles + 1;
    EXPECT_TRUE(begins(said(clips), "5 clips to stand with: at most 4 are possible")) << said(clips);
}
