#include "tests/api/walker.h"

#include <cmath>
#include <cstring>

Walker::Walker(SmallTemplate &small)
{
    std::memset(nodes_, 0, sizeof nodes_);
    nodes_[0] = small.nodes[0], nodes_[1] = small.nodes[1];
    const char *names[6] = {"thigh_l", "shin_l", "foot_l", "thigh_r", "shin_r", "foot_r"};
    for (uint32_t i = 0; i < 6; ++i) {
        clq_node_def &node = nodes_[2 + i];
        node.name = names[i];
        node.parent = i % 3 == 0 ? 0 : 1 + i;
        node.translation[0] = i == 0 ? 0.1f : i == 3 ? -0.1f : 0;
        node.translation[1] = i % 3 == 0 ? 1.0f : -0.5f;
    }
    const float times[3] = {0, 0.5f, 1};
    std::memcpy(times_, times, sizeof times);
    for (int leg = 0; leg < 2; ++leg)
        for (int key = 0; key < 3; ++key) {
            const float half = 0.2f * ((key == 1) == (leg == 0) ? 1.0f : -1.0f);
            const float rotation[4] = {std::sin(half), 0, 0, std::cos(half)};
            std::memcpy(values_[leg] + 4 * key, rotation, sizeof rotation);
        }
    channels_[0] = small.channels[0];
    channels_[1] = {2, CLQ_CHANNEL_ROTATION, CLQ_INTERPOLATION_LINEAR, 3, times_, values_[0]};
    channels_[2] = {5, CLQ_CHANNEL_ROTATION, CLQ_INTERPOLATION_LINEAR, 3, times_, values_[1]};
    clip_ = {"bend", 3, channels_};
    small.def.node_count = 8, small.def.nodes = nodes_;
    small.def.clip_count = 1, small.def.clips = &clip_;
}

clq_locomotion_def Walker::locomotion(const clq_template *tmpl, const uint32_t *clip)
{
    clq_locomotion_def def = clq_locomotion_def_init();
    def.tmpl = tmpl, def.walk = *clip;
    def.idle_count = 1, def.idles = clip;
    return def;
}

clq_status Walker::track(const clq_locomotion *locomotion, uint32_t seed, clq_track **out)
{
    clq_track_point points[60];
    double z = -1.0 - seed;
    for (int i = 0; i < 60; ++i) {
        z -= i > 20 && i < 32 ? 0 : 0.12;
        points[i] = {0.1 * i - 1, {0.5 * std::sin(0.1 * i + seed), 0, z}, NAN};
    }
    clq_track_def def = clq_track_def_init();
    const clq_track_passing passing = {2, {points[30].position[0] + 0.6, 0, points[30].position[2]}};
    def.point_count = 60, def.points = points, def.seed = seed;
    def.passing_count = 1, def.passings = &passing;
    return clq_track_create(locomotion, &def, out);
}
