// Retargeting of motion between different skeletons, by properties that hold for any algorithm.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/retarget/retarget.h"
#include "rigs.h"

namespace claque::testing
{
namespace
{

retarget::Options motion_at_keys()
{
    retarget::Options options;
    options.mode = retarget::Mode::motion;
    options.travel = retarget::RootTravel::keep;
    options.rate_hz = 10;  // the rate of the source's keys
    return options;
}

model::Rig source_of(float size, float arms_down_deg, uint32_t keys = 12)
{
    model::Rig rig = rig_of(person(size, arms_down_deg));
    add_motion(rig, "dance", keys, size);
    return rig;
}

constexpr const char *limbs[][2] = {{"arm.l", "elbow.l"},  {"elbow.l", "hand.l"}, {"arm.r", "elbow.r"},
                                    {"elbow.r", "hand.r"}, {"leg.l", "knee.l"},   {"knee.l", "foot.l"},
                                    {"leg.r", "knee.r"},   {"knee.r", "foot.r"},  {"hips", "spine"}};

}  // namespace

TEST(Transfer, ASkeletonOfAnotherSizeDoesTheSameInItsOwnSize)
{
    const model::Rig source = source_of(1, 0);
    model::Rig target = rig_of(person(2.5f, 0));
    retarget::add_clips(target, source, motion_at_keys());
    ASSERT_EQ(target.clips.size(), 1u);
    const glm::dvec3 start = posed(target, 0, 0).places[0] - 2.5 * posed(source, 0, 0).places[0];
    for (uint32_t k = 0; k < 12; ++k) {
        const Posed s = posed(source, 0, k), t = posed(target, 0, k);
        for (uint32_t i = 0; i < target.node_count(); ++i)
            EXPECT_LT(glm::distance(t.places[i], 2.5 * s.places[i] + start), 1e-5) << target.node_names[i] << " " << k;
    }
}

TEST(Transfer, AlignedLimbsPointWhereThoseOfTheSourcePoint)
{
    const model::Rig source = source_of(1, 0);
    model::Rig target = rig_of(person(1.3f, 50));
    retarget::Options options = motion_at_keys();
    for (const auto &limb : limbs)
        for (const char *name : limb) {
            bool there = false;
            for (const retarget::JointPair &pair : options.joints) there |= pair.source == name;
            if (!there) options.joints.push_back({name, name, retarget::RestAlignment::align});
        }
    retarget::add_clips(target, source, options);
    for (uint32_t k = 0; k < 12; ++k) {
        const Posed s = posed(source, 0, k), t = posed(target, 0, k);
        for (const auto &limb : limbs) {
            if (std::string(limb[0]) == "hips") continue;  // three bones: no direction of its own
            const glm::dvec3 own = glm::normalize(t.of(target, limb[1]) - t.of(target, limb[0]));
            const glm::dvec3 other = glm::normalize(s.of(source, limb[1]) - s.of(source, limb[0]));
            EXPECT_LT(glm::distance(own, other), 1e-5) << limb[0] << " at key " << k;
        }
    }
}

TEST(Transfer, JointsThatKeepTheirRestTurnFromItAsTheSourceTurns)
{
    const model::Rig source = source_of(1, 0);
    model::Rig target = rig_of(person(1, 50));
    retarget::add_clips(target, source, motion_at_keys());
    for (uint32_t k = 0; k < 12; ++k) {
        const Posed s = posed(source, 0, k), t = posed(target, 0, k);
        for (uint32_t i = 0; i < target.node_count(); ++i)
            EXPECT_GT(std::fabs(glm::dot(s.turns[i], t.turns[i])), 1 - 1e-6) << target.node_names[i];
    }
}

TEST(Transfer, ASourceWithAnotherUpAxisIsRotated)
{
    const model::Rig source = source_of(1, 10);
    // The same rig with Z up and facing -Y, as other programs write it.
    std::vector<Bone> bones = person(1, 10);
    for (Bone &bone : bones) bone.offset = glm::vec3(bone.offset.x, -bone.offset.z, bone.offset.y);
    model::Rig lying = rig_of(bones);
    add_motion(lying, "dance", 12, 1);
    for (const model::Channel &c : lying.channels)
        for (uint32_t k = 0; k < c.key_count; ++k) {
            float *v = lying.values.data() + c.first_value + k * c.component_count;
            const float y = v[1];
            v[1] = -v[2], v[2] = y;
        }
    model::Rig upright = rig_of(person(1, 10)), stood_up = rig_of(person(1, 10));
    retarget::add_clips(upright, source, motion_at_keys());
    retarget::add_clips(stood_up, lying, motion_at_keys());
    for (uint32_t k = 0; k < 12; ++k)
        for (uint32_t i = 0; i < upright.node_count(); ++i)
            EXPECT_LT(glm::distance(posed(upright, 0, k).places[i], posed(stood_up, 0, k).places[i]), 1e-5);
}

TEST(Transfer, AxesAndScalesAboveTheTargetDoNotShow)
{
    const model::Rig source = source_of(1, 0);
    model::Rig plain = rig_of(person(1, 0));
    // Everything a hundred times smaller and lying, under a node that corrects it.
    std::vector<Bone> bones = {{"armature", "", {0, 0, 0}}};
    for (Bone bone : person(1, 0)) {
        bone.offset = glm::vec3(bone.offset.x, -bone.offset.z, bone.offset.y) * 0.01f;
        if (!*bone.parent) bone.parent = "armature";
        bones.push_back(bone);
    }
    model::Rig wrapped = rig_of(bones);
    wrapped.rest[0].rotation = axis_turn({1, 0, 0}, -1.57079633f);
    wrapped.rest[0].scale = glm::vec3(100);
    retarget::add_clips(plain, source, motion_at_keys());
    retarget::add_clips(wrapped, source, motion_at_keys());
    for (uint32_t k = 0; k < 12; ++k) {
        const Posed own = posed(plain, 0, k), other = posed(wrapped, 0, k);
        for (const char *name : {"hips", "head", "hand.l", "foot.r"})
            EXPECT_LT(glm::distance(own.of(plain, name), 100.0 * other.of(wrapped, name)), 2e-4) << name;
    }
}

namespace
{

// The same under a node on the ground, as exporters add it.
model::Rig in_armature(const model::Rig &body)
{
    model::Rig out(body, std::pmr::get_default_resource());
    out.parents.insert(out.parents.begin(), model::none);
    for (size_t i = 1; i < out.parents.size(); ++i)
        out.parents[i] = out.parents[i] == model::none ? 0 : out.parents[i] + 1;
    out.rest.insert(out.rest.begin(), math::Trs());
    out.node_names.emplace(out.node_names.begin(), "Armature");
    for (model::Channel &channel : out.channels) ++channel.node;
    return out;
}

}  // namespace

TEST(Transfer, AnArmatureOfEqualNamesDoesNotTakeTheHipsPath)
{
    const model::Rig source = in_armature(source_of(1, 0));
    std::vector<Bone> bones = person(2, 0);
    bones[1].offset.z += 0.1f;  // no copy
    model::Rig target = in_armature(rig_of(bones));
    EXPECT_EQ(retarget::add_clips(target, source, motion_at_keys()).joint_count, 15u);
    const auto path = [](const model::Rig &rig, uint32_t k) {
        return posed(rig, 0, k).of(rig, "hips") - posed(rig, 0, 0).of(rig, "hips");
    };
    for (uint32_t k = 0; k < 12; ++k) EXPECT_LT(glm::distance(path(target, k), 2.0 * path(source, k)), 1e-5);
}

TEST(Transfer, UnboundJointsRestAndHangOnWhatMoves)
{
    const model::Rig source = source_of(1, 0);
    std::vector<Bone> bones = person(1, 0);
    bones.push_back({"ring", "hand.l", {0.1f, 0, 0}});
    model::Rig target = rig_of(bones);
    const retarget::Report report = retarget::add_clips(target, source, motion_at_keys());
    EXPECT_EQ(report.joint_count, 15u);
    for (uint32_t k = 0; k < 12; ++k) {
        const Posed t = posed(target, 0, k);
        EXPECT_NEAR(glm::distance(t.of(target, "ring"), t.of(target, "hand.l")), 0.1, 1e-6);
    }
}

TEST(Transfer, ClothThatFollowsALegTurnsByItsShareOfTheLegsTurn)
{
    const model::Rig source = source_of(1, 0);
    std::vector<Bone> bones = person(1, 0);
    bones.push_back({"cloth", "hips", {0.1f, -0.1f, 0.1f}});
    for (const double share : {0.0, 0.5, 1.0}) {
        model::Rig target = rig_of(bones);
        retarget::Options options = motion_at_keys();
        options.followers = {{"cloth", "leg.l", share}};
        retarget::add_clips(target, source, options);
        const uint32_t cloth = target.find_node("cloth"), leg = target.find_node("leg.l");
        for (uint32_t k = 0; k < 12; ++k) {
            const Posed t = posed(target, 0, k);
            const glm::dquat hips = glm::conjugate(t.turns[0]);
            const double own = std::acos(std::fmin(1.0, std::fabs((hips * t.turns[cloth]).w)));
            const double legs = std::acos(std::fmin(1.0, std::fabs((hips * t.turns[leg]).w)));
            EXPECT_NEAR(own, share * legs, 2e-3);
        }
        options.followers = {{"leg.l", "cloth", share}};
        EXPECT_THROW(retarget::add_clips(target, source, options), base::Error);
    }
}

TEST(Transfer, FeetStandOnTheGroundOfTheCharacter)
{
    model::Rig source = rig_of(person(1, 0));
    add_motion(source, "stand", 12, 1, 0.03f);
    for (uint32_t k = 0; k < 12; ++k) source.values[source.channels[0].first_value + 3 * k + 1] += 7;  // in the air
    model::Rig target = rig_of(person(0.4f, 0));
    retarget::add_clips(target, source, motion_at_keys());
    double lowest = 1e9;
    for (uint32_t k = 0; k < 12; ++k)
        for (const char *foot : {"foot.l", "foot.r"})
            lowest = std::min(lowest, posed(target, 0, k).of(target, foot).y - 0.05 * 0.4);
    EXPECT_NEAR(lowest, 0, 0.01);
}

TEST(Transfer, InPlaceEndsOverItsStartAndKeepTravelsTheScaledDistance)
{
    const model::Rig source = source_of(1, 0);
    model::Rig target = rig_of(person(2, 0));
    retarget::Options options = motion_at_keys();
    retarget::add_clips(target, source, options);
    options.travel = retarget::RootTravel::in_place;
    retarget::add_clips(target, source, options);
    const glm::dvec3 goes = posed(target, 0, 11).places[0] - posed(target, 0, 0).places[0];
    EXPECT_NEAR(goes.z, 2 * 1.1, 1e-5);
    const glm::dvec3 stays = posed(target, 1, 11).places[0] - posed(target, 1, 0).places[0];
    EXPECT_NEAR(stays.z, 0, 1e-5);
    EXPECT_NEAR(stays.x, 0, 1e-5);
    EXPECT_EQ(target.clip_names[1], "dance.2");
}

TEST(Transfer, ALoopedClipEndsInItsFirstPoseAndBeginsUnchanged)
{
    const model::Rig source = source_of(1, 0, 31);
    model::Rig open = rig_of(person(1, 20)), closed = rig_of(person(1, 20));
    retarget::Options options = motion_at_keys();
    options.travel = retarget::RootTravel::in_place;
    retarget::add_clips(open, source, options);
    options.close_s = 1;
    retarget::add_clips(closed, source, options);
    for (uint32_t i = 0; i < open.node_count(); ++i) {
        EXPECT_LT(glm::distance(posed(closed, 0, 30).places[i], posed(closed, 0, 0).places[i]), 1e-5);
        EXPECT_LT(glm::distance(posed(closed, 0, 20).places[i], posed(open, 0, 20).places[i]), 1e-6);
    }
}

TEST(Transfer, PartOfAClipIsSampledAtTheRequestedRate)
{
    const model::Rig source = source_of(1, 0, 31);
    model::Rig target = rig_of(person(1, 0));
    retarget::Options options = motion_at_keys();
    options.start_s = 0.5, options.end_s = 2;
    options.rate_hz = 20;
    retarget::add_clips(target, source, options);
    EXPECT_FLOAT_EQ(target.clips[0].duration_s, 1.5f);
    EXPECT_EQ(target.channels[0].key_count, 31u);
    EXPECT_EQ(target.clips[0].start_s, 0);
}

}  // namespace claque::testing
