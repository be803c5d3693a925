#include "samples/scenes/everything/sway.h"

#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/everything/shapes.h"

namespace scenes::everything
{
namespace
{

constexpr int keys = 16;  // and the first again
constexpr double duration_s = 2.4;

double wave(int key, double lag) { return std::sin(two_pi * (static_cast<double>(key) / keys - lag)); }

}  // namespace

Sway::Sway()
{
    for (int key = 0; key <= keys; ++key) times_.push_back(static_cast<float>(duration_s * key / keys));
    for (uint32_t joint = 0; joint < spine_joints; ++joint) turn(spine + joint, 0.25, 1, 0.07, 0.06 * joint);
    turn(head, 1, 0.3, 0.22, 0.1);
    turn(right_arm, 1, 0.3, 0.5, 0.3);
    turn(lantern_node, 1, 0.4, 0.4, 0.5);
    turn(left_arm, 1, 0.3, 0.5, 0.8);

    std::vector<float> &scales = values(), &weights = values();
    for (int key = 0; key <= keys; ++key) {
        const double wide = 1 + 0.10 * wave(key, 0.2);
        for (const double scale : {wide, 1 / (wide * wide), wide}) scales.push_back(static_cast<float>(scale));
        weights.push_back(static_cast<float>(0.5 + 0.5 * wave(key, 0)));
        weights.push_back(static_cast<float>(0.5 - 0.5 * wave(key, 0.35)));
    }
    const uint32_t count = static_cast<uint32_t>(times_.size());
    channels_.push_back({spine + 2, CLQ_CHANNEL_SCALE, CLQ_INTERPOLATION_LINEAR, count, times_.data(), scales.data()});
    channels_.push_back(
        {root, CLQ_CHANNEL_MORPH_WEIGHTS, CLQ_INTERPOLATION_LINEAR, count, times_.data(), weights.data()});
    clip_.name = "sway";
    clip_.channel_count = static_cast<uint32_t>(channels_.size());
    clip_.channels = channels_.data();
}

std::vector<float> &Sway::values()
{
    values_.emplace_back();
    return values_.back();
}

void Sway::turn(uint32_t node, double axis_x, double axis_z, double angle, double lag)
{
    const double length = std::sqrt(axis_x * axis_x + axis_z * axis_z);
    std::vector<float> &rotations = values();
    for (int key = 0; key <= keys; ++key) {
        const double half = angle * wave(key, lag) / 2, s = std::sin(half) / length;
        for (const double q : {s * axis_x, 0.0, s * axis_z, std::cos(half)}) rotations.push_back(static_cast<float>(q));
    }
    channels_.push_back({node, CLQ_CHANNEL_ROTATION, CLQ_INTERPOLATION_LINEAR, static_cast<uint32_t>(times_.size()),
                         times_.data(), rotations.data()});
}

}  // namespace scenes::everything
