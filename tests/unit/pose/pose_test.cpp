// Poses, compared with a second evaluation in double.
#include "lib/pose/pose.h"

#include <cmath>

#include <gtest/gtest.h>

#include "reference.h"
#include "tests/law/support/figure.h"

namespace claque::pose
{

using namespace testing_support;

namespace
{

void expect_like_reference(const model::Rig &rig, Workspace &workspace, uint32_t clip, double time_s)
{
    const reference::Pose expected = reference::evaluate(rig, clip, time_s);
    const auto palette = workspace.pose(clip, time_s);
    ASSERT_EQ(palette.count, expected.palette.size());
    for (uint32_t i = 0; i < palette.count; ++i)
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 3; ++r)
                ASSERT_NEAR(palette[i].c[3 * c + r], expected.palette[i].m[4 * c + r], 3e-6)
                    << "clip " << clip << " at " << time_s << " entry " << i;
    for (size_t i = 0; i < expected.weights.size(); ++i)
        ASSERT_NEAR(workspace.weights()[uint32_t(i)], expected.weights[i], 1e-6) << "clip " << clip << " at " << time_s;
}

}  // namespace

TEST(Pose, AgreesWithASecondEvaluationInDoubleForEveryKindOfKey)
{
    for (const Shape shape : {Shape::similar, Shape::sheared}) {
        FigureDef def;
        def.shape = shape;
        const auto figure = make_figure(def);
        Workspace workspace(figure->rig);
        expect_like_reference(figure->rig, workspace, model::none, 0);
        for (uint32_t clip = 0; clip < figure->rig.clips.size(); ++clip) {
            for (int i = -20; i <= 240; ++i) expect_like_reference(figure->rig, workspace, clip, i * 0.01013);
            for (const float key : figure->rig.times) expect_like_reference(figure->rig, workspace, clip, key);
        }
    }
}

TEST(Pose, ChannelsMayShareKeyTimesAndEndAtDifferentOnes)
{
    const auto figure = make_figure();
    model::Rig &rig = figure->rig;
    for (uint32_t i = 1; i < 6; ++i) {
        rig.channels[i].first_time = rig.channels[0].first_time;
        rig.channels[i].key_count = i % 2 ? 10 : 34;
    }
    model::check(rig);
    Workspace workspace(rig);
    for (int i = -2; i < 60; ++i) expect_like_reference(rig, workspace, clip_walk, i * 0.0203);
}

TEST(Pose, IsIndependentOfEarlierCalls)
{
    const auto figure = make_figure();
    Workspace a(figure->rig), b(figure->rig);
    for (const double time : {0.9, 0.1, 0.55, 0.1, 1.0}) a.pose(clip_walk, time);
    a.pose(clip_sway, 0.4);
    const auto first = a.pose(clip_walk, 0.37), second = b.pose(clip_walk, 0.37);
    for (uint32_t i = 0; i < first.count; ++i)
        for (int k = 0; k < 12; ++k) EXPECT_EQ(first[i].c[k], second[i].c[k]);
}

TEST(Pose, ReturnsGlobalsInModelSpace)
{
    const auto figure = make_figure();
    Workspace workspace(figure->rig);
    const auto palette = workspace.pose(clip_walk, 0.5);
    for (uint32_t i = 0; i < palette.count; ++i) {
        const math::Affine expected = math::mul(workspace.global(i), figure->rig.palette[i].inverse_bind);
        for (int k = 0; k < 12; ++k) EXPECT_FLOAT_EQ(palette[i].c[k], expected.c[k]);
    }
}

TEST(Pose, NamesTheFirstBrokenRuleOfAJob)
{
    const auto figure = make_figure();
    PoseJob job;
    EXPECT_EQ(job.check().code, CLQ_ARGUMENT);
    job.rig = &figure->rig;
    job.clip = 99;
    EXPECT_STREQ(job.check().text, "a pose job asks for clip 99 of 4");
    job.clip = 0;
    job.time_s = NAN;
    EXPECT_STREQ(job.check().text, "a pose job's time is not finite");
    job.time_s = 0;
    EXPECT_NE(std::string(job.check().text).find("of 9 nodes"), std::string::npos);
    std::vector<math::Trs> locals(9);
    std::vector<math::Columns> globals(9);
    std::vector<math::Affine> palette(10);
    std::vector<float> weights(2);
    job.locals = base::Span<math::Trs>(locals);
    job.globals = base::Span<math::Columns>(globals);
    EXPECT_NE(std::string(job.check().text).find("of 9 matrices"), std::string::npos);
    job.palette = {palette.data(), 9};
    job.weights = base::Span<float>(weights);
    EXPECT_TRUE(job.check().ok());
}

}  // namespace claque::pose
