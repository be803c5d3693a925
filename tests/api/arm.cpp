#include "tests/api/arm.h"

#include <cmath>
#include <cstring>

#include "tests/api/calls.h"

double Arm::angle_in(uint32_t clip, uint32_t joint, double t)
{
    const double round = 2 * 3.14159265358979323846 * t / length_s[clip];
    switch (clip) {
        case slow:
        case fast:
            return 0.3 * std::sin(round + 0.5 * joint);
        case bent:
            return 1.1 - 0.2 * joint;
        default:
            return joint == 2 ? 0.8 * std::sin(round) : 0.0;
    }
}

Arm::Arm(const clq_crowd_def *def)
{
    std::memcpy(nodes_, base_.nodes, sizeof base_.nodes);
    nodes_[2] = nodes_[1];
    nodes_[0].name = "shoulder", nodes_[1].name = "elbow", nodes_[2].name = "hand";
    nodes_[2].parent = 1;
    for (uint32_t c = 0; c < clip_count; ++c) {
        constexpr int keys = 129;
        for (int k = 0; k < keys; ++k) times_[c].push_back(static_cast<float>(length_s[c] * k / (keys - 1)));
        for (uint32_t joint = 0; joint < 3; ++joint) {
            for (const float t : times_[c]) {
                const double half = 0.5 * angle_in(c, joint, static_cast<double>(t));
                for (const double x : {0.0, 0.0, std::sin(half), std::cos(half)})
                    values_[c][joint].push_back(static_cast<float>(x));
            }
            channels_[c][joint] = {joint, CLQ_CHANNEL_ROTATION, CLQ_INTERPOLATION_LINEAR,
                                   keys,  times_[c].data(),     values_[c][joint].data()};
        }
        static const char *const names[] = {"slow", "fast", "bent", "wave"};
        clips_[c] = {names[c], 3, channels_[c]};
    }
    markers_[0] = {slow, 0.5f, "down"}, markers_[1] = {slow, 1.25f, "down"}, markers_[2] = {fast, 0.25f, "down"};
    base_.def.node_count = 3, base_.def.nodes = nodes_;
    base_.def.clip_count = clip_count, base_.def.clips = clips_;
    base_.def.marker_count = 3, base_.def.markers = markers_;
    EXPECT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
    EXPECT_EQ(clq_template_build(context, &base_.def, &tmpl), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_create(context, def, &crowd), CLQ_OK);
    clq_actor_def actor_def = clq_actor_def_init();
    actor_def.tmpl = tmpl;
    actor_def.play.clip = slow;
    actor_def.seed = 5;
    EXPECT_EQ(clq_actor_create(crowd, &actor_def, &actor), CLQ_OK) << clq_last_error();
}

Arm::~Arm()
{
    clq_crowd_destroy(crowd);
    clq_template_destroy(tmpl);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK) << clq_last_error();
}

double Arm::angle(uint32_t joint, double time_s)
{
    double m[16];
    double before = 0, turned = 0;
    for (uint32_t j = 0; j <= joint; ++j) {
        EXPECT_EQ(clq_actor_get_node(crowd, actor, j, time_s, m), CLQ_OK) << clq_last_error();
        before = turned;
        turned = std::atan2(m[1], m[0]);
    }
    const double pi = 3.14159265358979323846;
    double own = turned - before;
    while (own > pi) own -= 2 * pi;
    while (own < -pi) own += 2 * pi;
    return own;
}

clq_fade_def Arm::motion(uint32_t clip, double start_s) const
{
    clq_fade_def out = clq_fade_def_init();
    out.play.clip = clip, out.play.start_s = start_s, out.play.speed = 1;
    return out;
}

void Arm::fade(uint32_t clip, double at_s, float length, clq_curve curve)
{
    const clq_fade_def to = motion(clip, at_s);
    EXPECT_EQ(api_test::fade_to(crowd, actor, to, at_s, length, curve), CLQ_OK) << clq_last_error();
}

clq_gait Arm::add_gait(uint32_t a, uint32_t b, const std::vector<float> &sync_a, const std::vector<float> &sync_b)
{
    clq_gait_def def = clq_gait_def_init();
    def.tmpl = tmpl, def.clip_a = a, def.clip_b = b;
    def.sync_count = static_cast<uint32_t>(sync_a.size());
    def.sync_a_s = sync_a.data(), def.sync_b_s = sync_b.data();
    clq_gait out{};
    EXPECT_EQ(clq_crowd_add_gait(crowd, &def, &out), CLQ_OK) << clq_last_error();
    return out;
}

clq_mask Arm::add_mask(const char *node, uint32_t feather)
{
    clq_mask_def def = clq_mask_def_init();
    def.tmpl = tmpl, def.node_count = 1, def.nodes = &node, def.feather = feather;
    clq_mask out{};
    EXPECT_EQ(clq_crowd_add_mask(crowd, &def, &out), CLQ_OK) << clq_last_error();
    return out;
}

std::vector<clq_active_clip> Arm::shown(double time_s)
{
    clq_active_clip clips[CLQ_ACTIVE_CLIP_MAX];
    uint32_t count = 0;
    EXPECT_EQ(clq_actor_get_active_clips(crowd, actor, time_s, clips, &count), CLQ_OK) << clq_last_error();
    return {clips, clips + count};
}

std::vector<clq_event> Arm::events(double from_s, double to_s)
{
    size_t count = 0;
    EXPECT_EQ(api_test::get_events(crowd, from_s, to_s, nullptr, 0, &count), CLQ_OK) << clq_last_error();
    std::vector<clq_event> out(count);
    EXPECT_EQ(api_test::get_events(crowd, from_s, to_s, out.data(), count, &count), CLQ_OK) << clq_last_error();
    return out;
}
