// The nodes of legs, torso, neck and head: each one that there is not, or that hangs elsewhere, is refused by name.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/track/clip_checks.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

// The refusal; "" if there is none.
template <class Check>
std::string said(const Check &check)
{
    try {
        check();
        return "";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_ARGUMENT);
        return error.what();
    }
}

bool is_below(const model::Rig &rig, uint32_t node, uint32_t above)
{
    for (node = rig.parents[node]; node != model::none; node = rig.parents[node])
        if (node == above) return true;
    return false;
}

}  // namespace

// Every node of the skeleton in every place of a leg.
TEST(NodesOfLegs, AreThoseThatHangBelowEachOther)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    const model::Template &tmpl = *citizen.tmpl;
    const model::Rig &rig = tmpl.rig;
    for (int side = 0; side < 2; ++side)
        for (int part = 0; part < 4; ++part)
            for (uint32_t node = 0; node <= rig.node_count(); ++node) {
                track::LocomotionClips clips = citizen.clips;
                uint32_t(&leg)[4] = clips.legs[side];
                leg[part] = node;
                const std::string refusal = said([&] { track::check_legs(tmpl, clips); });
                if (node == rig.node_count()) {
                    EXPECT_NE(refusal.find("has node " + std::to_string(node) + " of " + std::to_string(node)),
                              std::string::npos)
                        << refusal;
                    continue;
                }
                // The shin hangs below the thigh, toes below the foot.
                bool good = true;
                for (const int below : {1, 3})
                    if (leg[below] != model::none) good = good && is_below(rig, leg[below], leg[below - 1]);
                EXPECT_EQ(refusal.empty(), good) << part << ", " << rig.node_names[node] << ": " << refusal;
                if (!good) EXPECT_NE(refusal.find("is not below node"), std::string::npos) << refusal;
            }
    track::LocomotionClips clips = citizen.clips;
    clips.legs[0][3] = clips.legs[1][3] = model::none;
    EXPECT_EQ(said([&] { track::check_legs(tmpl, clips); }), "") << "toes may be missing";
    for (int part = 0; part < 3; ++part) {
        clips = citizen.clips, clips.legs[1][part] = model::none;
        EXPECT_NE(said([&] { track::check_legs(tmpl, clips); }), "") << part;
    }
}

TEST(NodesThatTurn, AreThoseThatHangBelowEachOther)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    const model::Template &tmpl = *citizen.tmpl;
    const model::Rig &rig = tmpl.rig;
    const char *const names[] = {"torso", "neck", "head"};
    uint32_t track::LocomotionClips::*const members[] = {&track::LocomotionClips::torso, &track::LocomotionClips::neck,
                                                         &track::LocomotionClips::head};
    for (uint32_t missing = 0; missing < 8; ++missing)
        for (int part = 0; part < 3; ++part)
            for (uint32_t node = 0; node <= rig.node_count(); ++node) {
                track::LocomotionClips clips = citizen.clips;
                for (int k = 0; k < 3; ++k)
                    if (missing >> k & 1) clips.*members[k] = model::none;
                clips.*members[part] = node;
                const std::string refusal = said([&] { track::check_upper(tmpl, clips); });
                if (node == rig.node_count()) {
                    EXPECT_EQ(refusal.rfind("the " + std::string(names[part]) + " of template", 0), 0u) << refusal;
                    continue;
                }
                bool good = true;
                uint32_t above = model::none;
                for (const auto member : members) {
                    if (clips.*member == model::none) continue;
                    good = good && (above == model::none || is_below(rig, clips.*member, above));
                    above = clips.*member;
                }
                EXPECT_EQ(refusal.empty(), good) << names[part] << " at " << rig.node_names[node] << ": " << refusal;
            }
}

// Clips that walk, run and slow down in another order than their names say.
TEST(SpeedsOfClips, AscendFromTheSlowWalkToTheRun)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    const auto refusal = [&](double slow, double walk, double run, float leg) {
        track::Locomotion made(std::pmr::get_default_resource());
        made.clips = citizen.clips, made.leg_length = leg;
        for (uint32_t step = 0; step < track::gait_step_count; ++step) made.cycle_s[step] = 1;
        made.stride[track::slow_step] = float(slow), made.stride[track::walk_step] = float(walk);
        made.stride[track::gait_step_count - 1] = float(run);
        return said([&] { track::check_speeds(*citizen.tmpl, made); });
    };
    EXPECT_EQ(refusal(0.9, 1, 1.1, 0.9f), "");
    EXPECT_NE(refusal(1, 1, 1.1, 0.9f).find("walks slowly at 1 units a second"), std::string::npos);
    EXPECT_NE(refusal(0.9, 1, 1, 0.9f).find("runs at 1 units a second"), std::string::npos);
    EXPECT_NE(refusal(0.9, 1, 0.95, 0.9f).find("runs at 0.95 units a second"), std::string::npos);
    EXPECT_NE(refusal(0.9, 1, 1, 0.9f).find("; name another one (--walk of the command, clips of a scenario's class"),
              std::string::npos);
    EXPECT_EQ(refusal(0.9, 1, 1.1, 9.9f), "");
    EXPECT_NE(refusal(0.9, 1, 1.1, 10).find("move back by 0.1 of a leg's length a cycle, as in a clip that stands"),
              std::string::npos);
    EXPECT_NE(refusal(0.9, 1, 1.1, 10.1f)
                  .find("of a leg's length a cycle, as in a clip that stands: a walk in place is wanted"),
              std::string::npos);
}

// A walk that has neither is as fast as itself.
TEST(SpeedsOfClips, AreAskedOfARunAndASlowWalkThatThereAre)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    for (const bool has_run : {false, true})
        for (const bool has_slow : {false, true}) {
            track::Locomotion made(std::pmr::get_default_resource());
            made.clips = citizen.clips, made.leg_length = 1;
            for (uint32_t step = 0; step < track::gait_step_count; ++step) made.stride[step] = made.cycle_s[step] = 1;
            if (!has_run) made.clips.run = model::none;
            if (!has_slow) made.clips.slow = model::none;
            const std::string refusal = said([&] { track::check_speeds(*citizen.tmpl, made); });
            EXPECT_EQ(refusal.empty(), !has_run && !has_slow) << refusal;
        }
}

// Low feet move back, or aside by up to 60 degrees; steps on the spot have no direction.
TEST(DirectionsOfClips, AreAheadUpTo60Degrees)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    const auto refusal = [&](double x, double z) {
        return said([&] { track::check_direction(*citizen.tmpl, citizen.clips.walk, x, z); });
    };
    EXPECT_EQ(refusal(0, 0.1), "");
    EXPECT_NE(refusal(0, 0.1000001).find("move forward at stance, and its "), std::string::npos) << refusal(0, 0.11);
    EXPECT_EQ(refusal(0.06, 0.08), "");
    EXPECT_NE(refusal(0.0601, 0.08), "");
    const double aside = std::sqrt(3.0);  // of 1 back or ahead: 60 degrees
    for (const double x : {aside, -aside}) {
        EXPECT_EQ(refusal(x, -1.0000001), "");
        const std::string back = refusal(x, -0.9999999), level = refusal(x, 0), ahead = refusal(x, 0.9999999);
        for (const std::string &sideways : {back, level, ahead}) {
            EXPECT_NE(sideways.find("move sideways at stance"), std::string::npos) << sideways;
            EXPECT_NE(sideways.find("it faces +z: the clip walks aside; "), std::string::npos) << sideways;
        }
        const std::string forward = refusal(x, 1.0000001);
        EXPECT_NE(forward.find("move forward at stance"), std::string::npos) << forward;
        EXPECT_NE(forward.find("it faces +z: the clip walks backwards; "), std::string::npos) << forward;
    }
}
