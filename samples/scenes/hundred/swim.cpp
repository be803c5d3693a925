#include "samples/scenes/hundred/swim.h"

#include <cmath>

#include "samples/scenes/hundred/dragon_plan.h"

namespace scenes::hundred
{
namespace
{

constexpr uint32_t steps = 14;

// A turn to the side and one up, each a sine over the clip's loop: amplitude [radians] and delay [loops].
struct Sway {
    uint32_t node;
    double yaw, pitch, late;
};

std::vector<Sway> sways()
{
    std::vector<Sway> out = {{heart, 0.03, 0.05, 0.0},   {chest, 0.05, 0.02, -0.06},   {shoulder, 0.06, 0.02, -0.12},
                             {neck1, 0.06, 0.02, -0.18}, {neck2, 0.05, 0.02, -0.24},   {neck3, 0.04, 0.02, -0.30},
                             {head, -0.08, 0.03, -0.2},  {loin, 0.05, 0.03, 0.08},     {hip, 0.07, 0.03, 0.16},
                             {fin, 0.20, 0.10, 1.15},    {whisker_l, 0.10, 0.12, 0.4}, {whisker_r, -0.10, 0.12, 0.5},
                             {crest, 0.0, 0.10, 0.35}};
    for (uint32_t k = 0; k < 10; ++k) out.push_back({tail1 + k, 0.09 + 0.012 * k, 0.03, 0.24 + 0.085 * k});
    for (uint32_t leg = 0; leg < 4; ++leg) {
        const double late = leg == 0 || leg == 3 ? 0 : 0.5;
        out.push_back({legs + 3 * leg, 0.0, 0.28, late});
        out.push_back({legs + 3 * leg + 1, 0.0, 0.20, late + 0.15});
        out.push_back({legs + 3 * leg + 2, 0.0, 0.25, late + 0.3});
    }
    return out;
}

}  // namespace

Swim::Swim()
{
    for (uint32_t k = 0; k <= steps; ++k) times_.push_back(duration_s * static_cast<float>(k) / steps);
    const std::vector<Sway> all = sways();
    turns_.reserve(all.size());
    for (const Sway &sway : all) {
        std::vector<float> turns;
        for (uint32_t k = 0; k <= steps; ++k) {
            const double round = 6.283185307179586 * (static_cast<double>(k % steps) / steps - sway.late);
            const double yaw = 0.5 * sway.yaw * std::sin(round), pitch = -0.5 * (sway.pitch * std::cos(round));
            const double cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
            // About y, then about the turned x.
            for (const double q : {cy * sp, sy * cp, -sy * sp, cy * cp}) turns.push_back(static_cast<float>(q));
        }
        turns_.push_back(std::move(turns));
        clq_channel_def channel = {};
        channel.node = sway.node;
        channel.target = CLQ_CHANNEL_ROTATION;
        channel.interpolation = CLQ_INTERPOLATION_LINEAR;
        channel.key_count = steps + 1;
        channel.times_s = times_.data();
        channel.values = turns_.back().data();
        channels_.push_back(channel);
    }
    clip.name = "swim";
    clip.channel_count = static_cast<uint32_t>(channels_.size());
    clip.channels = channels_.data();
}

}  // namespace scenes::hundred
