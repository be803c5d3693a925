// Feet of synchronised gaits on the ground. When the Reference Point moves by the root motions of both clips, each
// weighted by its share, a planted foot stays in place up to the difference between blended angles and blended
// positions.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

// `carried`: part of the cycle in which a foot is planted
constexpr double limb_m = 0.45, hips_m = 0.78, carried = 0.6;

// Hips and two legs of two segments. Planted feet stand still in the world; the hips move ahead.
class Strider
{
public:
    enum Clip : uint32_t { slow, fast, clip_count };
    static constexpr double stride_m[clip_count] = {0.9, 1.3}, length_s[clip_count] = {1.1, 0.85};
    enum Node : uint32_t { hips, thigh_l, shin_l, foot_l, thigh_r, shin_r, foot_r, node_count };

    Strider()
    {
        static const char *const names[] = {"hips", "thigh_l", "shin_l", "foot_l", "thigh_r", "shin_r", "foot_r"};
        for (uint32_t n = 0; n < node_count; ++n) {
            nodes_[n] = small_.nodes[0];
            nodes_[n].name = names[n];
            nodes_[n].parent = n == hips ? CLQ_NONE : n == thigh_l || n == thigh_r ? uint32_t(hips) : n - 1;
            const bool is_thigh = n == thigh_l || n == thigh_r;
            nodes_[n].translation[0] = n == thigh_l ? 0.1f : n == thigh_r ? -0.1f : 0.0f;
            nodes_[n].translation[1] = static_cast<float>(n == hips ? hips_m : is_thigh ? 0 : -limb_m);
            nodes_[n].translation[2] = 0;
        }
        for (uint32_t clip = 0; clip < clip_count; ++clip) make_clip(clip);
        small_.def.node_count = node_count, small_.def.nodes = nodes_;
        small_.def.clip_count = clip_count, small_.def.clips = clips_;
        small_.def.root_motion_count = clip_count, small_.def.root_motions = ways_;
        EXPECT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
        EXPECT_EQ(clq_template_build(context, &small_.def, &tmpl), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_create(context, nullptr, &crowd), CLQ_OK);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl, def.play.clip = slow;
        EXPECT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
    }
    ~Strider()
    {
        clq_crowd_destroy(crowd);
        clq_template_destroy(tmpl);
        clq_context_destroy(context);
    }

    // Synchronised; or the left foot of one clip together with the right foot of the other.
    void go(float share, bool in_step)
    {
        const float at_a[] = {0}, at_b[] = {static_cast<float>(in_step ? 0 : 0.5 * length_s[fast])};
        clq_gait_def def = clq_gait_def_init();
        def.tmpl = tmpl, def.clip_a = slow, def.clip_b = fast;
        def.sync_count = 1, def.sync_a_s = at_a, def.sync_b_s = at_b;
        clq_fade_def motion = clq_fade_def_init();
        ASSERT_EQ(clq_crowd_add_gait(crowd, &def, &motion.gait), CLQ_OK) << clq_last_error();
        motion.play.speed = 1, motion.share = share;
        ASSERT_EQ(api_test::fade_to(crowd, actor, motion, 0, 0, CLQ_CURVE_SMOOTH), CLQ_OK) << clq_last_error();
    }

    struct Slide {
        double fastest = 0, mean = 0;  // speed of planted feet over the ground, m/s
        double way_m = 0;              // travelled by the Reference Point
    };
    Slide walk(double from_s, double to_s)
    {
        Slide out;
        double steps = 0, before[2][3] = {};
        bool planted_before[2] = {false, false};
        constexpr double step_s = 1.0 / 480;
        std::vector<clq_active_clip> last;
        for (double t = from_s; t < to_s; t += step_s) {
            const std::vector<clq_active_clip> now = shown(t);
            if (!last.empty()) advance(last, now);
            last = now;
            for (int side = 0; side < 2; ++side) {
                const double phase = now[0].clip_time_s / length_s[now[0].clip] + 0.5 * side;
                const double own = phase - std::floor(phase);
                // The whole cycle except the instants at which feet come down and lift.
                const bool planted = own > 0.02 && own < carried - 0.02;
                double m[16];
                EXPECT_EQ(clq_actor_get_node(crowd, actor, side == 0 ? foot_l : foot_r, t, m), CLQ_OK);
                if (planted && planted_before[side]) {
                    const double speed = std::hypot(m[12] - before[side][0], m[14] - before[side][2]) / step_s;
                    out.fastest = std::max(out.fastest, speed);
                    out.mean += speed, steps += 1;
                }
                planted_before[side] = planted;
                std::memcpy(before[side], m + 12, sizeof before[side]);
            }
        }
        out.mean /= steps;
        out.way_m = place_.position[2];
        return out;
    }

    clq_context *context = nullptr;
    clq_template *tmpl = nullptr;
    clq_crowd *crowd = nullptr;
    clq_actor actor{};

private:
    std::vector<clq_active_clip> shown(double t)
    {
        clq_active_clip clips[CLQ_ACTIVE_CLIP_MAX];
        uint32_t count = 0;
        EXPECT_EQ(clq_actor_get_active_clips(crowd, actor, t, clips, &count), CLQ_OK);
        return {clips, clips + count};
    }

    // By the root motion of the active clips: each replaces its share of those below it.
    void advance(const std::vector<clq_active_clip> &from, const std::vector<clq_active_clip> &to)
    {
        double way[3] = {0, 0, 0};
        for (const clq_active_clip &clip : to) {
            double first_s = clip.clip_time_s;
            for (const clq_active_clip &other : from)
                if (other.clip == clip.clip) first_s = other.clip_time_s;
            const double last_s = clip.clip_time_s + (clip.clip_time_s < first_s ? length_s[clip.clip] : 0);
            double own[3];
            ASSERT_EQ(clq_template_get_root_motion(tmpl, clip.clip, first_s, last_s, own), CLQ_OK);
            for (int k = 0; k < 3; ++k) way[k] += double(clip.weight) * (own[k] - way[k]);
        }
        place_.position[0] += way[0], place_.position[2] += way[1];
        ASSERT_EQ(clq_crowd_set_transforms(crowd, &actor, &place_, 1), CLQ_OK);
    }

    static void make_leg(double stride, double phase, double hips_z, float thigh[4], float shin[4])
    {
        const double round = std::floor(phase), own = phase - round;
        double z = stride * (round + 0.5 * carried), y = 0;
        if (own > carried) {
            const double x = (own - carried) / (1 - carried);
            z += stride * x * x * (3 - 2 * x), y = 0.3 * x * x * (1 - x);
        }
        const double dz = z - hips_z, down = hips_m - y, d = std::hypot(dz, down);
        const double lean = std::atan2(dz, down), bend = std::acos(d / (2 * limb_m));
        const double turns[2] = {-(lean + bend), 2 * bend};
        for (int k = 0; k < 2; ++k) {
            float *to = k == 0 ? thigh : shin;
            to[0] = static_cast<float>(std::sin(turns[k] / 2)), to[1] = to[2] = 0;
            to[3] = static_cast<float>(std::cos(turns[k] / 2));
        }
    }

    void make_clip(uint32_t clip)
    {
        constexpr int keys = 241;
        for (int k = 0; k < keys; ++k) {
            const double phase = double(k) / (keys - 1), z = stride_m[clip] * phase;
            times_[clip].push_back(static_cast<float>(length_s[clip] * phase));
            for (const double x : {0.0, hips_m, z}) places_[clip].push_back(static_cast<float>(x));
            for (int side = 0; side < 2; ++side) {
                float thigh[4], shin[4];
                // The right foot is half a cycle ahead and, for that, half a stride behind.
                make_leg(stride_m[clip], phase + 0.5 * side, z + 0.5 * side * stride_m[clip], thigh, shin);
                turns_[clip][2 * side].insert(turns_[clip][2 * side].end(), thigh, thigh + 4);
                turns_[clip][2 * side + 1].insert(turns_[clip][2 * side + 1].end(), shin, shin + 4);
            }
        }
        channels_[clip][0] = {hips, CLQ_CHANNEL_TRANSLATION, CLQ_INTERPOLATION_LINEAR,
                              keys, times_[clip].data(),     places_[clip].data()};
        static const uint32_t turning[4] = {thigh_l, shin_l, thigh_r, shin_r};
        for (int k = 0; k < 4; ++k)
            channels_[clip][k + 1] = {turning[k], CLQ_CHANNEL_ROTATION, CLQ_INTERPOLATION_LINEAR,
                                      keys,       times_[clip].data(),  turns_[clip][k].data()};
        clips_[clip] = {clip == slow ? "slow" : "fast", 5, channels_[clip]};
        ways_[clip] = {clip, hips};
    }

    SmallTemplate small_;
    clq_node_def nodes_[node_count];
    std::vector<float> times_[clip_count], places_[clip_count], turns_[clip_count][4];
    clq_channel_def channels_[clip_count][5];
    clq_clip_def clips_[clip_count];
    clq_root_motion_def ways_[clip_count];
    clq_transform place_ = {{0, 0, 0}, {0, 0, 0, 1}, 1};
};

// m/s; the slower clip goes 0.82, the faster one 1.53
constexpr double alone_bound = 0.02, blended_bound = 0.03;

TEST(GaitFeet, StandStillInEitherClipAlone)
{
    for (const float share : {0.0f, 1.0f}) {
        Strider strider;
        strider.go(share, true);
        const Strider::Slide slide = strider.walk(0, 4);
        EXPECT_LT(slide.fastest, alone_bound) << share;
        const double speed = share == 0 ? 0.9 / 1.1 : 1.3 / 0.85;
        EXPECT_NEAR(slide.way_m, 4 * speed, 0.02 * speed);
    }
}

TEST(GaitFeet, HardlySlideInSynchronisedBlends)
{
    for (const float share : {0.25f, 0.5f, 0.75f}) {
        Strider strider;
        strider.go(share, true);
        const Strider::Slide slide = strider.walk(0, 4);
        EXPECT_LT(slide.fastest, blended_bound) << share;
        RecordProperty("slide_at_" + std::to_string(share), std::to_string(slide.fastest));
    }
}

TEST(GaitFeet, HardlySlideWhileTheShareChanges)
{
    Strider strider;
    strider.go(0, true);
    ASSERT_EQ(clq_actor_set_gait_share(strider.crowd, strider.actor, 1, 1, 2), CLQ_OK);
    const Strider::Slide slide = strider.walk(0, 4);
    EXPECT_LT(slide.fastest, 0.15) << "a stride that grows takes planted feet along";
    EXPECT_LT(slide.mean, blended_bound);
    RecordProperty("slide", std::to_string(slide.fastest));
}

TEST(GaitFeet, SlideInUnsynchronisedBlends)
{
    Strider strider;
    strider.go(0.5f, false);
    const Strider::Slide slide = strider.walk(0, 4);
    EXPECT_GT(slide.mean, 10 * blended_bound) << "or the tests above could not tell";
}

}  // namespace
