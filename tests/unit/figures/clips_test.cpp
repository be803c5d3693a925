// Clips of the built-in characters: loops, smoothness, joint limits and feet on the ground.
#include <algorithm>

#include <gtest/gtest.h>

#include "puppet.h"

using puppet::citizen;
using puppet::clip;
using puppet::frame_s;
using puppet::frames;
using puppet::node;
using puppet::pose;
using puppet::Posed;

namespace
{

// The bend of a limb at the joint of `middle` and its side: the cosine of the bend, and the hinge axis.
struct Bend {
    float degrees;
    glm::vec3 hinge;  // in the upper bone's axes
};
Bend bend(const Posed &p, const char *upper, const char *middle, const char *end)
{
    const glm::vec3 a = glm::normalize(p.joints[node(middle)] - p.joints[node(upper)]);
    const glm::vec3 b = glm::normalize(p.joints[node(end)] - p.joints[node(middle)]);
    return {puppet::degrees(std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f))),
            glm::conjugate(p.world[node(upper)]) * glm::cross(a, b)};
}

float lowest(const Posed &p)
{
    float y = 1e9f;
    for (const glm::vec3 v : p.vertices) y = std::min(y, v.y);
    return y;
}

class Clip : public testing::TestWithParam<const char *>
{
};

}  // namespace

TEST_P(Clip, HasThirtyKeysASecondAndADecentLength)
{
    const uint32_t c = clip(GetParam());
    ASSERT_NE(c, claque::model::none);
    const auto &rig = citizen().rig;
    for (uint32_t i = 0; i < rig.clips[c].channel_count; ++i) {
        const auto &channel = rig.channels[rig.clips[c].first_channel + i];
        EXPECT_EQ(int(channel.key_count), frames(c) + 1);
        for (uint32_t k = 0; k < channel.key_count; ++k)
            EXPECT_NEAR(rig.times[channel.first_time + k], float(k) * frame_s, 1e-5f);
    }
    EXPECT_GT(rig.clips[c].duration_s, 0.7f);
}

TEST_P(Clip, EndsAsItBeginsAndAsFast)
{
    for (const char *way : puppet::ways)
        if (std::string(way) == GetParam()) return;  // seat_test.cpp: such clips do not loop
    const uint32_t c = clip(GetParam());
    const int n = frames(c);
    const Posed first = pose(c, 0), last = pose(c, float(n) * frame_s);
    const Posed after = pose(c, frame_s), before = pose(c, float(n - 1) * frame_s);
    const float some = std::string(GetParam()) == "jog" ? 0.006f : 0.004f;
    const Posed second = pose(c, 2 * frame_s), earlier = pose(c, float(n - 2) * frame_s);
    for (size_t v = 0; v < first.vertices.size(); ++v) {
        EXPECT_LT(glm::distance(first.vertices[v], last.vertices[v]), 1e-5f);
        const glm::vec3 in = first.vertices[v] - before.vertices[v], out = after.vertices[v] - first.vertices[v];
        const glm::vec3 next = second.vertices[v] - after.vertices[v], past = before.vertices[v] - earlier.vertices[v];
        // At the loop's seam the speed changes no more than beside it; a running foot comes down in one frame.
        const float usual = std::max(glm::distance(past, in), glm::distance(out, next));
        EXPECT_LT(glm::distance(in, out), some + 1.5f * usual) << "vertex " << v;
    }
}

TEST_P(Clip, MovesWithoutJerks)
{
    const uint32_t c = clip(GetParam());
    // Metres by which the step from one frame to the next may change; runners move their feet fast.
    const float most = std::string(GetParam()) == "jog" ? 0.085f : 0.042f;
    Posed a = pose(c, 0), b = pose(c, frame_s);
    for (int k = 2; k <= frames(c); ++k) {
        const Posed d = pose(c, float(k) * frame_s);
        for (size_t j = 0; j < d.joints.size(); ++j)
            EXPECT_LT(glm::distance(d.joints[j] - b.joints[j], b.joints[j] - a.joints[j]), most)
                << "joint " << citizen().rig.node_names[j] << " at frame " << k;
        a = b, b = d;
    }
}

TEST_P(Clip, BendsElbowsAndKneesAsPeopleCan)
{
    const uint32_t c = clip(GetParam());
    for (int k = 0; k <= frames(c); ++k) {
        const Posed p = pose(c, float(k) * frame_s);
        for (const bool left : {true, false}) {
            const Bend knee = left ? bend(p, "thigh_l", "shin_l", "foot_l") : bend(p, "thigh_r", "shin_r", "foot_r");
            EXPECT_LT(knee.degrees, 140);
            if (knee.degrees > 6) {
                EXPECT_GT(knee.hinge.x, 0.9f * glm::length(knee.hinge)) << "knees bend backwards only";
            }
            const Bend elbow =
                left ? bend(p, "upper_arm_l", "forearm_l", "hand_l") : bend(p, "upper_arm_r", "forearm_r", "hand_r");
            EXPECT_LT(elbow.degrees, 150);
            const glm::vec3 hinge = glm::normalize(glm::vec3(left ? -1 : -1, left ? -1 : 1, 0));
            if (elbow.degrees > 6) {
                EXPECT_GT(glm::dot(elbow.hinge, hinge) * 1.0f, 0.9f * glm::length(elbow.hinge)) << "frame " << k;
            }
        }
    }
}

TEST_P(Clip, KeepsOtherJointsInsideHumanLimits)
{
    struct Limit {
        const char *name;
        float degrees;
    };
    const Limit limits[] = {{"pelvis", 20},    {"spine", 15},     {"spine_upper", 15},   {"chest", 15},
                            {"neck", 25},      {"head", 30},      {"clavicle_l", 30},    {"clavicle_r", 30},
                            {"hand_l", 75},    {"hand_r", 75},    {"thigh_l", 115},      {"thigh_r", 115},
                            {"foot_l", 50},    {"foot_r", 50},    {"toes_l", 60},        {"toes_r", 60},
                            {"fingers_l", 90}, {"fingers_r", 90}, {"fingertips_l", 130}, {"fingertips_r", 130},
                            {"thumb_l", 60},   {"thumb_r", 60}};
    const uint32_t c = clip(GetParam());
    for (int k = 0; k <= frames(c); ++k) {
        const Posed p = pose(c, float(k) * frame_s);
        for (const Limit &limit : limits)
            EXPECT_LT(puppet::angle(p.local[node(limit.name)]), limit.degrees) << limit.name << " at frame " << k;
    }
}

TEST_P(Clip, StandsOnTheGroundAllTheTime)
{
    const uint32_t c = clip(GetParam());
    for (int k = 0; k < 2 * frames(c); ++k)  // between the keys too
        EXPECT_NEAR(lowest(pose(c, float(k) * frame_s / 2)), 0, 0.015f) << "at half frame " << k;
}

INSTANTIATE_TEST_SUITE_P(Citizen, Clip, testing::ValuesIn(puppet::clip_names),
                         [](const auto &clip_info) { return std::string(clip_info.param); });

TEST(Clips, AreTheSameInEveryCharacter)
{
    for (const auto &builtin : claque::figures::people()) {
        const auto figure = builtin.make();
        ASSERT_EQ(figure.rig.clips.size(), std::size(puppet::clip_names)) << builtin.name;
        for (uint32_t c = 0; c < figure.rig.clips.size(); ++c) {
            EXPECT_EQ(figure.rig.clip_names[c], puppet::clip_names[c]) << builtin.name;
            EXPECT_EQ(figure.rig.clips[c].duration_s, citizen().rig.clips[c].duration_s) << builtin.name;
        }
    }
}

// In clips on the spot the balls of the feet stay in place.
TEST(Feet, DoNotSlideWhileStanding)
{
    for (const char *name : puppet::standing_clips) {
        const uint32_t c = clip(name);
        const Posed first = pose(c, 0);
        for (int k = 1; k <= 2 * frames(c); ++k) {
            const Posed p = pose(c, float(k) * frame_s / 2);
            for (const char *bone : {"toes_l", "toes_r"}) {
                const glm::vec3 d = p.joints[node(bone)] - first.joints[node(bone)];
                EXPECT_LT(std::hypot(d.x, d.z), 0.010f) << name << ' ' << bone << " at half frame " << k;
            }
        }
    }
}

// On a treadmill the ground moves back at one speed, and whatever touches it moves with it.
TEST(Feet, GoBackWithTheGroundWhileWalking)
{
    const uint32_t c = clip("walk");
    const int n = frames(c);
    // The speed of a sole that lies flat, in the middle of its time on the ground.
    const auto z = [&](const char *bone, int k) { return pose(c, float(k % n) * frame_s).joints[node(bone)].z; };
    const float speed = (z("foot_l", 9) - z("foot_l", 6)) / 3;
    EXPECT_LT(speed * 30, -0.8f);
    EXPECT_GT(speed * 30, -1.6f);
    int carried = 0;
    for (int k = 0; k < n; ++k) {
        const Posed now = pose(c, float(k) * frame_s), next = pose(c, float(k + 1) * frame_s);
        for (size_t v = 0; v < now.vertices.size(); ++v) {
            if (now.vertices[v].y > 0.002f || next.vertices[v].y > 0.002f) continue;
            const glm::vec3 d = next.vertices[v] - now.vertices[v];
            EXPECT_NEAR(d.z, speed, 0.010f) << "vertex " << v << " at frame " << k;
            EXPECT_NEAR(d.x, 0, 0.006f);
            ++carried;
        }
    }
    EXPECT_GT(carried, n * 4);
}

TEST(Feet, AlternateInAWalk)
{
    const uint32_t c = clip("walk");
    for (int k = 0; k < frames(c); ++k) {
        const Posed a = pose(c, float(k) * frame_s);
        const Posed b = pose(c, std::fmod(float(k) * frame_s + 0.55f, 1.1f));
        EXPECT_NEAR(a.joints[node("foot_l")].z, b.joints[node("foot_r")].z, 0.01f);
        EXPECT_NEAR(a.joints[node("foot_l")].x, -b.joints[node("foot_r")].x, 0.01f);
    }
}
