// Root motion: moving the Reference Point by it gives the position that the clip alone has.
#include <array>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/api/small_template.h"

namespace
{

constexpr double pi = 3.14159265358979323846;

// Walks on a curve: hips go ahead, turn and bob; the tip is a foot.
struct Walker {
    explicit Walker(bool taken)
    {
        for (int k = 0; k <= 20; ++k) {
            const double t = 0.05 * k, yaw = 0.6 * t, half = 0.5 * yaw;
            times.push_back(static_cast<float>(t));
            for (const double x : {1.4 * t * std::sin(0.5 * yaw), 0.9 + 0.05 * std::sin(4 * pi * t), 1.4 * t})
                places.push_back(static_cast<float>(x));
            for (const double x : {0.0, std::sin(half), 0.0, std::cos(half)}) turns.push_back(static_cast<float>(x));
        }
        channels[0] = {0, CLQ_CHANNEL_TRANSLATION, CLQ_INTERPOLATION_LINEAR, 21, times.data(), places.data()};
        channels[1] = {0, CLQ_CHANNEL_ROTATION, CLQ_INTERPOLATION_LINEAR, 21, times.data(), turns.data()};
        small.clips[0] = {"walk", 2, channels};
        if (taken) small.def.root_motion_count = 1, small.def.root_motions = &wanted;
        EXPECT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
        EXPECT_EQ(clq_template_build(context, &small.def, &tmpl), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_create(context, nullptr, &crowd), CLQ_OK);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl, def.play.clip = 0;
        EXPECT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
    }
    ~Walker()
    {
        clq_crowd_destroy(crowd);
        clq_template_destroy(tmpl);
        clq_context_destroy(context);
    }
    // Of the tip, with the Reference Point at a position and turned.
    void tip(double t, double x, double z, double yaw, double out[3])
    {
        const clq_transform transform = {
            {x, 0, z}, {0, static_cast<float>(std::sin(yaw / 2)), 0, static_cast<float>(std::cos(yaw / 2))}, 1};
        ASSERT_EQ(clq_crowd_set_transforms(crowd, &actor, &transform, 1), CLQ_OK);
        double m[16];
        ASSERT_EQ(clq_actor_get_node(crowd, actor, 1, t, m), CLQ_OK);
        std::memcpy(out, m + 12, 3 * sizeof *out);
    }

    SmallTemplate small;
    std::vector<float> times, places, turns;
    clq_channel_def channels[2];
    clq_root_motion_def wanted = {0, 0};
    clq_context *context = nullptr;
    clq_template *tmpl = nullptr;
    clq_crowd *crowd = nullptr;
    clq_actor actor{};
};

TEST(RootMotion, ExtractedAndReappliedIsTheClip)
{
    Walker whole(false), taken(true);
    for (double t = 0; t < 0.999; t += 0.013) {
        double step[3], a[3], b[3];
        ASSERT_EQ(clq_template_get_root_motion(taken.tmpl, 0, 0, t, step), CLQ_OK);
        whole.tip(t, 0, 0, 0, a);
        taken.tip(t, step[0], step[1], step[2], b);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1.5e-3) << t;
    }
    clq_template_info with = clq_template_info_init(), without = clq_template_info_init();
    ASSERT_EQ(clq_template_get_info(taken.tmpl, &with), CLQ_OK);
    ASSERT_EQ(clq_template_get_info(whole.tmpl, &without), CLQ_OK);
    EXPECT_LT(with.sklsroot_radius, without.sklsroot_radius - 0.1f) << "the position stays";
}

TEST(RootMotion, StepsAddUpForAnyIntervalsAndAcrossLoops)
{
    Walker taken(true);
    const auto step = [&](double from, double to) {
        std::array<double, 3> out{};
        EXPECT_EQ(clq_template_get_root_motion(taken.tmpl, 0, from, to, out.data()), CLQ_OK);
        return out;
    };
    const auto joined = [](const std::array<double, 3> &a, const std::array<double, 3> &b) {
        const double c = std::cos(a[2]), s = std::sin(a[2]);
        return std::array<double, 3>{a[0] + c * b[0] + s * b[1], a[1] - s * b[0] + c * b[1], a[2] + b[2]};
    };
    for (const double last : {0.4, 1.0, 3.7, -2.2, 41.3}) {
        std::array<double, 3> sum{};
        for (int i = 0; i < 200; ++i)
            sum = joined(sum, step(0.3 + (last - 0.3) * i / 200, 0.3 + (last - 0.3) * (i + 1) / 200));
        const auto whole = step(0.3, last);
        for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(sum[k], whole[k], 1e-6) << last;
    }
    const auto there = step(0.3, 7.9), back = step(7.9, 0.3);
    for (const double x : joined(there, back)) EXPECT_NEAR(x, 0, 1e-9);
    EXPECT_NEAR(step(0, 10)[2], 6, 1e-4);
}

TEST(RootMotion, InvalidDefinitionsAreRefusedByName)
{
    SmallTemplate small;
    const clq_root_motion_def twice[2] = {{0, 1}, {0, 1}};
    small.def.root_motion_count = 2, small.def.root_motions = twice;
    clq_context *context;
    clq_template *tmpl;
    ASSERT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
    EXPECT_EQ(clq_template_build(context, &small.def, &tmpl), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("twice"), std::string::npos) << clq_last_error();
    const clq_root_motion_def none = {4, 0};
    small.def.root_motion_count = 1, small.def.root_motions = &none;
    EXPECT_EQ(clq_template_build(context, &small.def, &tmpl), CLQ_ARGUMENT);
    const clq_marker_def late = {0, 1.5f, "late"};
    small.def.root_motion_count = 0, small.def.marker_count = 1, small.def.markers = &late;
    EXPECT_EQ(clq_template_build(context, &small.def, &tmpl), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("late"), std::string::npos) << clq_last_error();
    clq_context_destroy(context);
}

}  // namespace
