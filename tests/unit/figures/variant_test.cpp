// 150 clips: the requirements of a character's own clips hold for their variants.
#include "lib/figures/clips/variant.h"

#include <cmath>
#include <cstring>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/figures/figure.h"

using namespace claque::figures;

namespace
{

constexpr uint32_t variants_a_clip = 8;

struct Extremes {
    float hands_apart = 1e9f;  // smallest distance from wrist to wrist
    float wrist_to_trunk = 1e9f;
    float foot_low = 1e9f, foot_high = -1e9f;
    float jerk = 0;  // largest change of a joint's step from one key to the next
};

float to_trunk(const Pose &pose, Bone bone)
{
    const glm::vec3 a = pose.joint(Bone::spine), b = pose.joint(Bone::neck), p = pose.joint(bone), line = b - a;
    const float t = std::fmin(1.0f, std::fmax(0.0f, glm::dot(p - a, line) / glm::dot(line, line)));
    return glm::distance(p, a + line * t);
}

Extremes extremes_of(const std::vector<Pose> &poses)
{
    Extremes e;
    for (size_t k = 0; k < poses.size(); ++k) {
        const Pose &pose = poses[k];
        e.hands_apart = std::fmin(e.hands_apart, glm::distance(pose.joint(Bone::hand), pose.joint(Bone::hand_r)));
        for (const Bone hand : {Bone::hand, Bone::hand_r})
            e.wrist_to_trunk = std::fmin(e.wrist_to_trunk, to_trunk(pose, hand));
        for (const Bone foot : {Bone::foot, Bone::foot_r, Bone::toes, Bone::toes_r}) {
            e.foot_low = std::fmin(e.foot_low, pose.joint(foot).y);
            e.foot_high = std::fmax(e.foot_high, pose.joint(foot).y);
        }
        if (k < 2) continue;
        for (int b = 0; b < bone_count; ++b) {
            const Bone bone = static_cast<Bone>(b);
            const glm::vec3 now = pose.joint(bone) - poses[k - 1].joint(bone);
            e.jerk = std::fmax(e.jerk, glm::distance(now, poses[k - 1].joint(bone) - poses[k - 2].joint(bone)));
        }
    }
    return e;
}

std::vector<Pose> own_poses(const ClipMaker &maker)
{
    std::vector<Pose> poses;
    for (int k = 0; k <= maker.frames; ++k) {
        const bool last = k == maker.frames && maker.ending == Ending::closed;
        poses.push_back(maker.pose_at(last ? 0.0f : static_cast<float>(k) / static_cast<float>(maker.frames)));
    }
    return poses;
}

float farthest(const Pose &a, const Pose &b)
{
    float most = 0;
    for (int k = 0; k < bone_count; ++k)
        most = std::fmax(most, glm::distance(a.joint(static_cast<Bone>(k)), b.joint(static_cast<Bone>(k))));
    return most;
}

bool is_shared(const char *name)
{
    return std::strncmp(name, "sit", 3) == 0 || std::strncmp(name, "stand", 5) == 0 || std::strcmp(name, "rise") == 0;
}

class Variants : public testing::TestWithParam<uint32_t>
{
};

}  // namespace

TEST_P(Variants, KeepTheLawsOfTheirClip)
{
    const ClipMaker &maker = figure_clips()[GetParam()];
    const Extremes own = extremes_of(own_poses(maker));
    for (uint32_t number = 1; number <= variants_a_clip; ++number) {
        const Variant v = variant_of(GetParam(), number);
        SCOPED_TRACE(name_of(v));
        const std::vector<Pose> poses = poses_of(v);
        ASSERT_EQ(poses.size(), static_cast<size_t>(v.frames) + 1);
        const Extremes e = extremes_of(poses);
        EXPECT_GT(e.foot_low, own.foot_low - 0.002f);
        EXPECT_LT(e.foot_high, own.foot_high + 0.002f);
        EXPECT_GT(e.wrist_to_trunk, own.wrist_to_trunk - 0.025f);
        // A faster clip has larger accelerations, by the square of its speed.
        const float faster = static_cast<float>(maker.frames) / static_cast<float>(v.frames) * (1 + std::fabs(v.lead));
        EXPECT_LT(e.jerk, 2 * own.jerk * std::fmax(1.0f, faster * faster) + 0.015f);
        if (own.hands_apart < 0.10f) {
            EXPECT_NEAR(e.hands_apart, own.hands_apart, 0.015f);
        }
        if (maker.ending == Ending::closed) {
            EXPECT_EQ(farthest(poses.front(), poses.back()), 0);
        }
        if (!is_shared(maker.name)) continue;
        EXPECT_LT(farthest(poses.front(), maker.pose_at(0)), 1e-4f);
        EXPECT_LT(farthest(poses.back(), maker.pose_at(maker.ending == Ending::closed ? 0.0f : 1.0f)), 1e-4f);
    }
}

TEST_P(Variants, DifferFromTheirClipAndFromEachOther)
{
    const ClipMaker &maker = figure_clips()[GetParam()];
    std::set<int> lengths;
    for (uint32_t number = 1; number <= variants_a_clip; ++number) {
        const Variant v = variant_of(GetParam(), number);
        lengths.insert(v.frames);
        const std::vector<Pose> poses = poses_of(v);
        float most = 0;
        for (const size_t quarter : {1u, 2u, 3u})
            most = std::fmax(most, farthest(maker.pose_at(0.25f * static_cast<float>(quarter)),
                                            poses[static_cast<size_t>(v.frames) * quarter / 4]));
        EXPECT_GT(most, 0.004f) << name_of(v);
        EXPECT_GE(v.frames, static_cast<int>(0.79f * static_cast<float>(maker.frames)));
        EXPECT_LE(v.frames, static_cast<int>(1.23f * static_cast<float>(maker.frames)) + 1);
    }
    EXPECT_GE(lengths.size(), variants_a_clip - 2);
}

INSTANTIATE_TEST_SUITE_P(Clips, Variants, testing::Range(0u, 23u),
                         [](const auto &test) { return std::string(figure_clips()[test.param].name); });

TEST(VariantNames, Make150ClipsWithNamesOfTheirOwnAndTheSameTwice)
{
    claque::model::Model model = claque::figures::citizen(), again = claque::figures::citizen();
    add_variants(model, 150);
    add_variants(again, 150);
    claque::model::check(model);
    ASSERT_EQ(model.rig.clips.size(), 150u);
    std::set<std::string> names;
    for (const auto &name : model.rig.clip_names) names.emplace(name.c_str());
    EXPECT_EQ(names.size(), 150u);
    EXPECT_EQ(model.rig.clip_names[23], "stand.01");
    EXPECT_EQ(0, std::memcmp(model.rig.values.data(), again.rig.values.data(), 4 * model.rig.values.size()));
    const claque::model::Model own = claque::figures::citizen();
    EXPECT_EQ(0, std::memcmp(model.rig.values.data(), own.rig.values.data(), 4 * own.rig.values.size()));
}
