// A crowd of one arm: three joints in a row that turn about z, with clips whose angles are easy to compute.
#pragma once

#include <claque/claque.h>

#include <vector>

#include <gtest/gtest.h>

#include "tests/api/small_template.h"

class Arm
{
public:
    enum Clip : uint32_t { slow, fast, bent, wave, clip_count };
    static constexpr double length_s[clip_count] = {2, 1, 1, 0.5};

    explicit Arm(const clq_crowd_def *def = nullptr);
    ~Arm();
    Arm(const Arm &) = delete;
    Arm &operator=(const Arm &) = delete;

    // The angle of a joint in a clip at a time on the clip's axis: radians about z.
    static double angle_in(uint32_t clip, uint32_t joint, double clip_time_s);
    // The shown angle of a joint relative to its parent.
    double angle(uint32_t joint, double time_s);
    clq_fade_def motion(uint32_t clip, double start_s) const;
    void fade(uint32_t clip, double at_s, float length_s, clq_curve curve = CLQ_CURVE_SMOOTH);
    clq_gait add_gait(uint32_t a, uint32_t b, const std::vector<float> &sync_a = {},
                      const std::vector<float> &sync_b = {});
    clq_mask add_mask(const char *node, uint32_t feather = 0);
    std::vector<clq_active_clip> shown(double time_s);
    std::vector<clq_event> events(double from_s, double to_s);

    clq_context *context = nullptr;
    clq_template *tmpl = nullptr;
    clq_crowd *crowd = nullptr;
    clq_actor actor{};

private:
    SmallTemplate base_;
    clq_node_def nodes_[3];
    std::vector<float> times_[clip_count], values_[clip_count][3];
    clq_channel_def channels_[clip_count][3];
    clq_clip_def clips_[clip_count];
    clq_marker_def markers_[3];
};
