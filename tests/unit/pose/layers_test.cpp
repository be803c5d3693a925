// Layers: fades, masks, additive layers and invalid jobs.
#include <random>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "layers_reference.h"
#include "lib/pose/blend.h"
#include "lib/pose/pose.h"
#include "random_rig.h"

namespace claque::pose
{

namespace
{

using test::clip_cubic;
using test::clip_linear;
using test::clip_steps;

struct TestRig {
    model::Rig rig = test::RigMaker(7).make();
    std::vector<float> mask = test::upper_half(rig);
    Workspace workspace{rig};

    void expect_like_reference(const std::vector<Layer> &layers, const char *what)
    {
        const reference::Pose expected = reference::evaluate(rig, layers);
        PoseJob job = workspace.job();
        job.layers = {layers.data(), uint32_t(layers.size())};
        ASSERT_TRUE(job.check().ok()) << job.check().text;
        job.run();
        for (uint32_t i = 0; i < job.palette.count; ++i)
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 3; ++r)
                    ASSERT_NEAR(job.palette[i].c[3 * c + r], expected.palette[i].m[4 * c + r], 1e-5)
                        << what << " " << i;
        for (size_t i = 0; i < expected.weights.size(); ++i)
            ASSERT_NEAR(job.weights[uint32_t(i)], expected.weights[i], 1e-6) << what;
    }
};

Layer layer(uint32_t clip, double time_s, float weight, LayerKind kind = LayerKind::replace)
{
    Layer out;
    out.clip = clip, out.time_s = time_s, out.weight = weight, out.kind = kind;
    return out;
}

}  // namespace

TEST(Layers, FadeFromOneClipToAnotherByTheShorterArc)
{
    TestRig test_rig;
    for (const float weight : {0.0f, 0.25f, 0.5f, 0.99f, 1.0f})
        test_rig.expect_like_reference({layer(clip_linear, 0.6, 1), layer(clip_cubic, 0.9, weight)}, "fade");
}

TEST(Layers, BlendARotationAlikeWhicheverOfItsQuaternionsIsGiven)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-1, 1);
    const auto rotation = [&] { return glm::normalize(glm::quat(any(random), any(random), any(random), any(random))); };
    for (int i = 0; i < 1000; ++i) {
        const glm::quat a = rotation(), b = rotation();
        const glm::quat one = pose::nlerp(a, b, 0.3f), other = pose::nlerp(a, -b, 0.3f);
        EXPECT_EQ(one, other);
        EXPECT_GE(glm::dot(one, a), 0.7f) << "nearer to the first of two that are 90 degrees apart at most";
    }
}

TEST(Layers, AreMaskedJointByJointAndMorphWeightsWithTheirNode)
{
    TestRig test_rig;
    Layer upper = layer(clip_cubic, 1.1, 0.8f);
    upper.mask = test_rig.mask.data();
    test_rig.expect_like_reference({layer(clip_linear, 0.3, 1), upper}, "mask");
}

TEST(Layers, AddTheDifferenceFromAReferencePoseWithAnyWeight)
{
    TestRig test_rig;
    for (const float weight : {-0.5f, 0.0f, 0.4f, 1.0f, 1.7f}) {
        Layer layer_clip = layer(clip_cubic, 1.2, weight, LayerKind::add);
        test_rig.expect_like_reference({layer(clip_linear, 0.5, 1), layer_clip}, "against the rest pose");
        layer_clip.reference_clip = clip_cubic, layer_clip.reference_time_s = 0.25;
        layer_clip.mask = test_rig.mask.data();
        test_rig.expect_like_reference({layer(clip_linear, 0.5, 1), layer_clip}, "against a pose");
    }
}

TEST(Layers, LieOnTheRestPoseInTheOrderGiven)
{
    TestRig test_rig;
    test_rig.expect_like_reference({layer(clip_linear, 0.5, 0.5f)}, "half a clip");
    test_rig.expect_like_reference({layer(model::none, 0, 1), layer(clip_steps, 0.7, 0.3f), layer(clip_linear, 1, 0.5f),
                                    layer(clip_cubic, 0.5, 0.2f, LayerKind::add)},
                                   "many");
}

TEST(Layers, OneOfFullWeightIsTheClipToTheBit)
{
    TestRig test_rig;
    const std::vector<Layer> layers = {layer(clip_linear, 0.77, 1)};
    PoseJob job = test_rig.workspace.job();
    job.layers = {layers.data(), 1};
    job.run();
    Workspace plain(test_rig.rig);
    const auto expected = plain.pose(clip_linear, 0.77);
    for (uint32_t i = 0; i < expected.count; ++i)
        for (int k = 0; k < 12; ++k) EXPECT_EQ(job.palette[i].c[k], expected[i].c[k]);
}

TEST(Layers, NeedScratchAndClipsThatExist)
{
    TestRig test_rig;
    std::vector<Layer> layers = {layer(99, 0, 1)};
    PoseJob job = test_rig.workspace.job();
    job.layers = {layers.data(), 1};
    EXPECT_NE(std::string(job.check().text).find("clip 99"), std::string::npos) << job.check().text;
    layers[0] = layer(0, 0, NAN);
    EXPECT_NE(std::string(job.check().text).find("not finite"), std::string::npos) << job.check().text;
    layers[0] = layer(0, 0, 1);
    EXPECT_TRUE(job.check().ok());
    job.scratch.count = 3;
    EXPECT_NE(std::string(job.check().text).find("3 of"), std::string::npos) << job.check().text;
}

}  // namespace claque::pose
