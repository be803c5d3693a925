// Clips as rows at uniform rates, compared with a second evaluation of their channels in double.
#include "meshsplit/motion.h"

#include <cstring>

#include <gtest/gtest.h>

#include "layers_reference.h"
#include "lib/model/template_file.h"
#include "lib/pose/pose.h"
#include "random_rig.h"

namespace claque::pose
{

namespace
{

using test::clip_cubic;
using test::clip_linear;
using test::clip_steps;
using test::clip_still;

struct Sampled {
    explicit Sampled(float metres = 0.001f, uint32_t seed = 3)
        : tmpl(std::pmr::get_default_resource()), tolerance{metres, 0.01f}
    {
        tmpl.rig = test::RigMaker(seed).make();
        tmpl.levels.emplace_back(std::pmr::get_default_resource());
        for (uint32_t i = 0; i < tmpl.rig.node_count(); ++i)
            tmpl.levels[0].part_spheres.push_back({i, {tmpl.rig.rest[i].translation, 0.2f}});
        tmpl.similar_only = false;
    }
    void make() { meshsplit::inflate(meshsplit::make_motion(tolerance, tmpl), tmpl); }

    // Of points round every node, in double.
    double worst(uint32_t clip, double time_s)
    {
        Workspace workspace(tmpl.rig, &tmpl.motion);
        const auto palette = workspace.pose(clip, time_s);
        const reference::Pose expected = reference::evaluate(tmpl.rig, clip, time_s);
        double most = 0;
        for (uint32_t i = 0; i < palette.count; ++i)
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 at = tmpl.rig.rest[i].translation;
                const double p[4] = {at.x + (corner & 1 ? 0.1 : -0.1), at.y + (corner & 2 ? 0.1 : -0.1),
                                     at.z + (corner & 4 ? 0.1 : -0.1), 1};
                double square = 0;
                for (int r = 0; r < 3; ++r) {
                    double off = 0;
                    for (int c = 0; c < 4; ++c)
                        off += (double(palette[i].c[3 * c + r]) - expected.palette[i].m[4 * c + r]) * p[c];
                    square += off * off;
                }
                most = std::max(most, std::sqrt(square));
            }
        return most;
    }

    model::Template tmpl;
    meshsplit::MotionTolerance tolerance;
};

}  // namespace

TEST(Motion, FollowsTheChannelsWithinTheErrorItStates)
{
    for (const float metres : {0.01f, 0.001f}) {
        Sampled test_rig(metres);
        test_rig.make();
        for (uint32_t c = 0; c < test_rig.tmpl.rig.clips.size(); ++c) {
            const model::Clip &clip = test_rig.tmpl.rig.clips[c];
            const float stated = test_rig.tmpl.motion.clips[c].error_m;
            EXPECT_LE(stated, metres);
            for (int i = -10; i <= 1010; ++i) {
                const double time = clip.start_s + clip.duration_s * i / 1000.0;
                ASSERT_LE(test_rig.worst(c, time), stated * 1.05 + 2e-6) << "clip " << c << " at " << time;
            }
        }
    }
}

TEST(Motion, TakesTheLowestSufficientRate)
{
    Sampled coarse(0.01f), fine(0.0007f);
    coarse.make(), fine.make();
    EXPECT_LT(coarse.tmpl.motion.clips[clip_cubic].rate_hz, fine.tmpl.motion.clips[clip_cubic].rate_hz);
    EXPECT_LT(coarse.tmpl.motion.clips[clip_linear].rate_hz, 30.0f);
    // Its own keys are reproduced up to rounding.
    EXPECT_NEAR(fine.tmpl.motion.clips[clip_linear].rate_hz, 30.0f, 0.01f);
    EXPECT_EQ(fine.tmpl.motion.clips[clip_linear].exact_count, 0u);
    EXPECT_EQ(fine.tmpl.motion.clips[clip_still].rate_hz, 0.0f);
}

TEST(Motion, HonoursStepsToTheKey)
{
    Sampled test_rig;
    test_rig.make();
    const model::Rig &rig = test_rig.tmpl.rig;
    EXPECT_GT(test_rig.tmpl.motion.clips[clip_steps].exact_count, 0u);
    for (uint32_t k = 0; k < 9; ++k) {
        const double key = rig.times[rig.channels[rig.clips[clip_steps].first_channel].first_time + k];
        for (const double time : {key - 1e-9, key, key + 1e-9}) EXPECT_LE(test_rig.worst(clip_steps, time), 5e-6) << k;
    }
}

TEST(Motion, KeepsTheChannelOfACutAlone)
{
    Sampled test_rig;
    model::Rig &rig = test_rig.tmpl.rig;
    // Key 15 of one joint is 1.5 radians from its neighbours, a thirtieth of a second away: a rate of 30 Hz reproduces
    // it. No rate reproduces two keys a millisecond apart.
    model::Channel &channel = rig.channels[rig.clips[clip_linear].first_channel];
    channel.first_time = uint32_t(rig.times.size());
    for (uint32_t k = 0; k < channel.key_count; ++k)
        rig.times.push_back(k < 15    ? 0.25f + float(k) / 30
                            : k == 15 ? 0.25f + 14.0f / 30 + 0.001f
                                      : 0.25f + float(k) / 30);
    float *v = rig.values.data() + channel.first_value + 4 * 15;
    for (uint32_t k = 15; k < channel.key_count; ++k, v += 4) v[0] = 0.6f, v[1] = 0, v[2] = 0, v[3] = 0.8f;
    model::check(rig);
    test_rig.make();
    EXPECT_EQ(test_rig.tmpl.motion.clips[clip_linear].exact_count, 1u);
    EXPECT_GT(test_rig.tmpl.motion.clips[clip_linear].rate_hz, 0.0f);
    for (int i = 0; i < 50; ++i) EXPECT_LE(test_rig.worst(clip_linear, 0.25 + 14.0 / 30 - 0.0005 + i * 4e-5), 0.001);
}

TEST(Motion, MixesLayersLikeTheChannels)
{
    Sampled test_rig;
    test_rig.make();
    const std::vector<float> mask = test::upper_half(test_rig.tmpl.rig);
    Layer base, over, layer_clip;
    base.clip = clip_linear, base.time_s = 0.4;
    over.clip = clip_cubic, over.time_s = 0.8, over.weight = 0.4f, over.mask = mask.data();
    layer_clip.clip = clip_cubic, layer_clip.time_s = 1.1, layer_clip.weight = 0.6f, layer_clip.kind = LayerKind::add;
    layer_clip.reference_clip = clip_steps, layer_clip.reference_time_s = 0.9;
    for (const std::vector<Layer> &layers : {std::vector<Layer>{base},
                                             {base, over},
                                             {base, layer_clip},
                                             {over},
                                             {layer_clip, over},
                                             {over, layer_clip, base, over},
                                             {base, over, layer_clip}}) {
        const reference::Pose expected = reference::evaluate(test_rig.tmpl.rig, layers);
        Workspace workspace(test_rig.tmpl.rig, &test_rig.tmpl.motion);
        PoseJob job = workspace.job();
        job.layers = {layers.data(), uint32_t(layers.size())};
        ASSERT_TRUE(job.check().ok()) << job.check().text;
        job.run();
        for (uint32_t i = 0; i < job.palette.count; ++i)
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 3; ++r)
                    ASSERT_NEAR(job.palette[i].c[3 * c + r], expected.palette[i].m[4 * c + r], 0.004) << i;
        for (uint32_t i = 0; i < job.weights.count; ++i) ASSERT_NEAR(job.weights[i], expected.weights[i], 1e-3);
    }
}

TEST(Motion, AppliesDegreesOfFreedomAsTheChannelsDo)
{
    Sampled test_rig;
    model::Rig &rig = test_rig.tmpl.rig;
    model::Dof turn, shift;
    turn.node = 1, shift.node = 2, shift.kind = model::DofKind::translation, shift.axis = glm::vec3(1, 0, 0);
    turn.min = shift.min = -1, turn.max = shift.max = 1;
    rig.dofs.push_back(turn), rig.dofs.push_back(shift);
    test_rig.make();
    const float values[2] = {0.4f, 0.1f};
    Workspace rows(rig, &test_rig.tmpl.motion), channels(rig), rest(rig);
    PoseJob of_rows = rows.job(), of_channels = channels.job(), at_rest = rest.job();
    of_rows.clip = of_channels.clip = at_rest.clip = clip_linear;
    of_rows.time_s = of_channels.time_s = at_rest.time_s = 0.4;
    of_rows.dofs = of_channels.dofs = values;
    of_rows.run(), of_channels.run(), at_rest.run();
    float moved = 0;
    for (uint32_t i = 0; i < of_rows.palette.count; ++i)
        for (int k = 0; k < 12; ++k) {
            ASSERT_NEAR(of_rows.palette[i].c[k], of_channels.palette[i].c[k], 0.004) << i;
            moved = std::max(moved, std::fabs(of_channels.palette[i].c[k] - at_rest.palette[i].c[k]));
        }
    EXPECT_GT(moved, 0.05f);
}

TEST(Motion, GivesTheSameBitsOnEveryInstructionSet)
{
    Sampled test_rig;
    test_rig.make();
    Workspace a(test_rig.tmpl.rig, &test_rig.tmpl.motion), b(test_rig.tmpl.rig, &test_rig.tmpl.motion);
    PoseJob first = a.job(), second = b.job();
    for (const math::SimdLevel simd_level : {math::SimdLevel::simd128, math::SimdLevel::simd256})
        for (uint32_t clip = 0; clip < 4; ++clip)
            for (int i = 0; i < 50; ++i) {
                first.clip = second.clip = clip;
                first.time_s = second.time_s = i * 0.031;
                first.simd_level = math::SimdLevel::scalar, second.simd_level = simd_level;
                first.run(), second.run();
                ASSERT_EQ(0, std::memcmp(first.palette.data, second.palette.data, 48 * first.palette.count));
                ASSERT_EQ(0, std::memcmp(first.weights.data, second.weights.data, 4 * first.weights.count));
            }
}

TEST(Motion, LocalTransformsSayTheSameAsThePalette)
{
    Sampled test_rig;
    test_rig.make();
    Workspace workspace(test_rig.tmpl.rig, &test_rig.tmpl.motion);
    const auto palette = workspace.pose(clip_cubic, 0.777);
    PoseJob job = workspace.job();
    job.clip = clip_cubic, job.time_s = 0.777;
    std::vector<math::Affine> globals(test_rig.tmpl.rig.node_count()), kept(palette.begin(), palette.end());
    job.run_local_transforms();
    for (uint32_t n = 0; n < globals.size(); ++n) {
        const math::Affine own = math::affine_of(job.locals[n]);
        const uint32_t parent = test_rig.tmpl.rig.parents[n];
        globals[n] = parent == model::none ? own : math::mul(globals[parent], own);
        const math::Affine entry = math::mul(globals[n], test_rig.tmpl.rig.palette[n].inverse_bind);
        for (int k = 0; k < 12; ++k) ASSERT_NEAR(entry.c[k], kept[n].c[k], 5e-5) << n;
    }
}

TEST(Motion, ZeroToleranceMeansChannels)
{
    Sampled test_rig(0.0f);
    test_rig.make();
    EXPECT_TRUE(test_rig.tmpl.motion.empty());
    EXPECT_LE(test_rig.worst(clip_cubic, 0.6), 5e-6);
}

TEST(Motion, MakesTheSphereHoldItsMotion)
{
    Sampled test_rig(0.01f);
    test_rig.tmpl.sklsroot.radius = 1;
    test_rig.make();
    const float most =
        std::max(test_rig.tmpl.motion.clips[clip_linear].error_m, test_rig.tmpl.motion.clips[clip_cubic].error_m);
    EXPECT_GT(test_rig.tmpl.sklsroot.radius, 1 + most);
    EXPECT_LT(test_rig.tmpl.sklsroot.radius, 1.2f);
}

TEST(Motion, TakesLittleMemoryAndFoldsStillNodes)
{
    Sampled test_rig(0.01f);
    test_rig.make();
    const model::Motion &motion = test_rig.tmpl.motion;
    EXPECT_LT(motion_bytes(motion, test_rig.tmpl.rig, clip_still), 1000u);
    for (uint32_t b = 0; b < motion.block_count(); ++b)
        EXPECT_EQ(motion.blocks[clip_still * motion.block_count() + b].stride, 0u);
    EXPECT_LT(motion.joint_of[0], motion.nodes.size());
    EXPECT_EQ(motion.joint_of[test_rig.tmpl.rig.node_count() - 1], model::none);
}

}  // namespace claque::pose
