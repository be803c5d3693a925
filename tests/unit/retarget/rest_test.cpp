// Files of clips that rest in no T-pose: in the first pose of a clip, or with all bones along one axis. Where the
// character's joints go is told by forward kinematics in double precision, or by angles that the motion is made of.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/asset/bvh.h"
#include "lib/asset/file.h"
#include "lib/base/error.h"
#include "lib/figures/figure.h"
#include "lib/retarget/retarget.h"
#include "resting_rigs.h"
#include "tests/support/collected_file.h"

namespace claque::testing
{
namespace
{

const std::string cases = CLAQUE_ASSETS_DIR "/../cases/characters/";

// The angle of a bone from straight down, in degrees.
double from_down(const Posed &pose, const model::Rig &rig, const char *upper, const char *lower)
{
    const glm::dvec3 way = glm::normalize(pose.of(rig, lower) - pose.of(rig, upper));
    return std::acos(std::fmin(1.0, -way.y)) * 57.29577951308232;
}

// The angle between two bones below their joints, in degrees.
double between(const Posed &pose, const model::Rig &rig, const char *upper, const char *lower, const char *other_upper,
               const char *other_lower)
{
    const glm::dvec3 a = glm::normalize(pose.of(rig, lower) - pose.of(rig, upper));
    const glm::dvec3 b = glm::normalize(pose.of(rig, other_lower) - pose.of(rig, other_upper));
    return std::acos(std::fmin(1.0, glm::dot(a, b))) * 57.29577951308232;
}

bool says(const retarget::Report &report, const std::string &words)
{
    for (const std::string &warning : report.warnings)
        if (warning.find(words) != std::string::npos) return true;
    return false;
}

std::string all(const retarget::Report &report)
{
    std::string out;
    for (const std::string &warning : report.warnings) out += warning + "\n";
    return out;
}

retarget::Options resting(retarget::SourceRest rest)
{
    retarget::Options options;
    options.rest = rest;
    options.travel = retarget::RootTravel::keep;
    options.rate_hz = 10;  // the rate of the keys
    return options;
}

}  // namespace

TEST(Rest, OfTheFirstPoseDoesNotShowWhereOffsetsAreEqual)
{
    const model::Rig source = in_first_pose(rig_with_motion(person(1, 0)));
    model::Rig target = rig_of(person(1, 0));
    const retarget::Report report = retarget::add_clips(target, source, {});
    EXPECT_EQ(report.mode, retarget::Mode::channels);
    EXPECT_TRUE(report.warnings.empty()) << all(report);
    for (uint32_t k = 0; k < 12; ++k)
        for (uint32_t i = 0; i < target.node_count(); ++i)
            EXPECT_LT(glm::distance(posed(source, 0, k).places[i], posed(target, 0, k).places[i]), 1e-6);
}

TEST(Rest, OfTheFirstPoseDoesNotShowOnACharacterOfAnotherSize)
{
    const model::Rig source = in_first_pose(rig_with_motion(person(1, 0)));
    model::Rig target = rig_of(person(1.7f, 0));
    const retarget::Report report = retarget::add_clips(target, source, resting(retarget::SourceRest::automatic));
    EXPECT_EQ(report.mode, retarget::Mode::motion);
    for (uint32_t k = 0; k < 12; ++k) {
        const Posed s = posed(source, 0, k), t = posed(target, 0, k);
        for (uint32_t i = 0; i < target.node_count(); ++i)
            EXPECT_LT(glm::distance(t.places[i] - t.places[0], 1.7 * (s.places[i] - s.places[0])), 1e-5)
                << target.node_names[i] << " at key " << k;
    }
}

TEST(Rest, OfJointsThatNoChannelTurnsIsPartOfThePose)
{
    model::Rig source = rig_with_motion(person(1, 0));
    const uint32_t elbow = source.find_node("elbow.l");
    source.rest[elbow].rotation = axis_turn({0, 1, 0}, -1.2f);
    for (uint32_t c = 0; c < source.channels.size(); ++c)
        if (source.channels[c].node == elbow) {
            source.channels.erase(source.channels.begin() + c);
            --source.clips[0].channel_count;
            break;
        }
    model::Rig target = rig_of(person(1, 0));
    ASSERT_EQ(retarget::add_clips(target, source, {}).mode, retarget::Mode::channels);
    model::check(target);
    for (uint32_t k = 0; k < 12; ++k)
        EXPECT_LT(glm::distance(posed(source, 0, k).of(source, "hand.l"), posed(target, 0, k).of(target, "hand.l")),
                  1e-6);
}

TEST(Rest, DoesNotCountWhereOffsetsDifferByLessThanAHundredthOfTheLimb)
{
    // From the fork at the spine to the hand: 0.36 + 0.3 + 0.25 m.
    for (const float further : {0.0085f, 0.0095f}) {
        const model::Rig source = in_first_pose(rig_with_motion(person(1, 0)));
        std::vector<Bone> bones = person(1, 0);
        for (Bone &bone : bones)
            if (std::string(bone.name) == "hand.l") bone.offset.z += further;
        model::Rig target = rig_of(bones);
        EXPECT_EQ(retarget::add_clips(target, source, {}).mode,
                  further < 0.009f ? retarget::Mode::channels : retarget::Mode::motion)
            << further;
    }
}

TEST(Rest, OfOneKindOfSkeletonIsTheCharactersWhereTheProportionsDiffer)
{
    const model::Rig source = in_first_pose(rig_with_motion(person(1, 0), 1.3f));
    std::vector<Bone> bones = person(1, 0);
    for (Bone &bone : bones)
        if (std::string(bone.name).substr(0, 4) == "knee") bone.offset *= 1.3f;
    model::Rig target = rig_of(bones);
    const retarget::Report report = retarget::add_clips(target, source, resting(retarget::SourceRest::automatic));
    EXPECT_TRUE(says(report, "they are copied. rest = \"file\"")) << all(report);
    for (uint32_t k = 0; k < 12; ++k) {
        const Posed s = posed(source, 0, k), t = posed(target, 0, k);
        for (uint32_t i = 0; i < target.node_count(); ++i)
            EXPECT_GT(std::fabs(glm::dot(s.turns[i], t.turns[i])), 1 - 1e-6) << target.node_names[i];
    }
}

TEST(Rest, OfASkeletonAlongOneAxisComesFromThePosesOfItsClip)
{
    const model::Rig source = rig_along_x(walker(12), 0);
    model::Rig target = rig_of(person(1, 0));
    const retarget::Report report = retarget::add_clips(target, source, resting(retarget::SourceRest::automatic));
    EXPECT_TRUE(says(report, "lie along x. Frame 0 of 'walk' takes its place; rest = \"frame:N\"")) << all(report);
    EXPECT_EQ(report.warnings.size(), 1u) << all(report);
    for (uint32_t k = 0; k < 12; ++k) {
        const Posed t = posed(target, 0, k);
        const double swing = leg_swing_deg(k);
        EXPECT_NEAR(from_down(t, target, "leg.l", "knee.l"), std::fabs(swing), 0.01);
        EXPECT_NEAR(between(t, target, "leg.l", "foot.l", "leg.r", "foot.r"), 2 * std::fabs(swing), 0.02);
        EXPECT_NEAR((t.of(target, "knee.l").z - t.of(target, "leg.l").z) / 0.4, std::sin(swing / 57.29577951308232),
                    1e-4);
        EXPECT_NEAR(from_down(t, target, "arm.l", "hand.l"), 15, 0.01);
        EXPECT_GT(t.of(target, "hand.l").x, t.of(target, "arm.l").x) << "outside of the body";
        EXPECT_NEAR(t.of(target, "head").y - t.of(target, "hips").y, 0.6, 1e-4);
        EXPECT_NEAR(t.of(target, "hips").y, 1, 0.03);
    }
}

TEST(Rest, OfASkeletonAlongOneAxisFacesTheCharactersWayWhereverTheClipFaces)
{
    for (const float away_deg : {37.0f, 120.0f, -170.0f}) {
        const model::Rig source = rig_along_x(walker(12), away_deg);
        model::Rig target = rig_of(person(1, 0));
        retarget::add_clips(target, source, resting(retarget::SourceRest::automatic));
        for (uint32_t k = 0; k < 12; ++k) {
            const Posed t = posed(target, 0, k);
            const glm::dvec3 across = t.of(target, "leg.l") - t.of(target, "leg.r");
            EXPECT_LT(glm::distance(across, glm::dvec3(0.2, 0, 0)), 1e-3) << away_deg;
            EXPECT_NEAR(t.of(target, "hips").z - posed(target, 0, 0).of(target, "hips").z, 0.1 * k, 0.01) << "ahead";
        }
    }
}

TEST(Rest, OfASkeletonAlongOneAxisLeavesATrunkThatStandsItsPosture)
{
    const auto with_neck = [](float lean) {
        std::vector<Bone> bones = person(1, 0);
        bones[2] = {"neck", "spine", {0, 0.2f, 0}};
        bones.insert(bones.begin() + 3, {"head", "neck", {0, 0.2f, lean}});
        return bones;
    };
    const model::Rig source = rig_along_x(walker(12), 0, with_neck(0));
    for (const float lean : {0.05f, 0.2f}) {  // 14 and 45 degrees
        model::Rig target = rig_of(with_neck(lean));
        retarget::add_clips(target, source, resting(retarget::SourceRest::bones));
        const glm::dvec3 head = posed(target, 0, 0).of(target, "head") - posed(target, 0, 0).of(target, "neck");
        const double length = std::sqrt(0.04 + lean * lean);
        EXPECT_LT(glm::distance(head, lean < 0.1f ? glm::dvec3(0, 0.2, lean) : glm::dvec3(0, length, 0)), 1e-4) << lean;
    }
}

TEST(Rest, OfAFrameIsThePoseOfThatFrame)
{
    const model::Rig source = rig_along_x(walker(12), 0);
    for (const uint32_t frame : {0u, 3u}) {
        retarget::Options options = resting(retarget::SourceRest::frame);
        options.rest_frame = frame;
        model::Rig target = rig_of(person(1, 0));
        const retarget::Report report = retarget::add_clips(target, source, options);
        EXPECT_TRUE(report.warnings.empty()) << all(report);
        for (uint32_t k = 0; k < 12; ++k) {
            // No joint is aligned: in that frame the character stands as it rests, with its arms out.
            const Posed t = posed(target, 0, k);
            const double swing = leg_swing_deg(k) - leg_swing_deg(frame);
            EXPECT_NEAR(from_down(t, target, "leg.l", "knee.l"), std::fabs(swing), 0.01) << frame;
            EXPECT_NEAR(from_down(t, target, "arm.l", "elbow.l"), 90, 0.01);
        }
    }
    retarget::Options late = resting(retarget::SourceRest::frame);
    late.rest_frame = 12;
    model::Rig target = rig_of(person(1, 0));
    try {
        retarget::add_clips(target, source, late);
        FAIL() << "there are twelve";
    } catch (const base::Error &error) {
        EXPECT_NE(std::string(error.what()).find("frame 12, and clip 'walk' has the frames 0 to 11"), std::string::npos)
            << error.what();
    }
}

TEST(Rest, OfSnakesAlongOneAxisIsAPose)
{
    std::vector<Bone> bones = {{"a", "", {0, 0, 0}}};
    const char *const names[] = {"a", "b", "c", "d", "e"};
    for (int i = 1; i < 5; ++i) bones.push_back({names[i], names[i - 1], {0, 0, 0.3f}});
    model::Rig source = rig_with_motion(bones), target = rig_of(bones);
    for (math::Trs &rest : target.rest) rest.translation *= 1.5f;
    const retarget::Report report = retarget::add_clips(target, source, {});
    EXPECT_TRUE(report.warnings.empty()) << all(report);
}

TEST(Rest, OfWrittenCasesIsRight)
{
    CLAQUE_NEEDS_FILE(cases + "same_bones_walk.glb");
    const auto load = [](const std::string &name) {
        const std::vector<uint8_t> bytes = asset::read_file(cases + name, 1u << 30);
        return name.find(".bvh") == std::string::npos ? asset::load_gltf(bytes.data(), bytes.size(), {})
                                                      : asset::load_bvh(bytes.data(), bytes.size(), {});
    };
    model::Model target = load("same_bones_char.glb");
    const model::Model walk = load("same_bones_walk.glb");
    EXPECT_EQ(retarget::add_clips(target.rig, walk.rig, {}).mode, retarget::Mode::channels);
    double ahead[2];
    for (const uint32_t key : {0u, 1u}) {
        const Posed t = posed(target.rig, 0, key);
        for (const char *side : {"Left", "Right"}) {
            const std::string arm = std::string(side) + "Arm", hand = std::string(side) + "Hand";
            EXPECT_NEAR(90 - from_down(t, target.rig, arm.c_str(), hand.c_str()), 75, 0.01);
        }
        EXPECT_NEAR(between(t, target.rig, "LeftUpLeg", "LeftLeg", "RightUpLeg", "RightLeg"), 50, 0.01);
        ahead[key] = t.of(target.rig, "LeftLeg").z - t.of(target.rig, "LeftUpLeg").z;
    }
    EXPECT_NEAR(ahead[0], -ahead[1], 1e-5);
    EXPECT_GT(std::fabs(ahead[0]), 0.1);
}

TEST(Rest, OfACaseAlongOneAxisMovesABuiltInPerson)
{
    CLAQUE_NEEDS_FILE(cases + "bones_along_x.bvh");
    const std::vector<uint8_t> bytes = asset::read_file(cases + "bones_along_x.bvh", 1u << 30);
    const model::Model motion = asset::load_bvh(bytes.data(), bytes.size(), {});
    model::Model citizen = figures::citizen();
    const uint32_t clip = static_cast<uint32_t>(citizen.rig.clips.size());
    const retarget::Report report = retarget::add_clips(citizen.rig, motion.rig, {});
    EXPECT_TRUE(says(report, "lie along x")) << all(report);
    EXPECT_EQ(report.joint_count, 21u);
    EXPECT_FALSE(says(report, "without a map")) << all(report);
    EXPECT_FALSE(says(report, "clip '")) << all(report);
    for (uint32_t k = 0; k < 31; ++k) {
        const Posed t = posed(citizen.rig, clip, k);
        EXPECT_NEAR(t.of(citizen.rig, "pelvis").y, 0.95, 0.05);
        EXPECT_NEAR(t.of(citizen.rig, "head").y, 1.545, 0.07);
        EXPECT_NEAR(std::min(t.of(citizen.rig, "toes_l").y, t.of(citizen.rig, "toes_r").y), 0.02, 0.04);
        EXPECT_NEAR(from_down(t, citizen.rig, "thigh_l", "shin_l"), std::fabs(20 * std::sin(k * 0.2094395102393195)),
                    0.1);
        EXPECT_GT(t.of(citizen.rig, "hand_l").x, 0.17);
        EXPECT_LT(t.of(citizen.rig, "hand_r").x, -0.17);
    }
}

}  // namespace claque::testing
