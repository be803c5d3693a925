// How a dragon swims through the air: a wave that runs down its body, its legs rowing. One clip, without a seam.
#pragma once

#include <claque/template.h>

#include <vector>

namespace scenes::hundred
{

struct Swim {
    Swim();
    Swim(const Swim &) = delete;
    Swim &operator=(const Swim &) = delete;

    static constexpr float duration_s = 2.8f;
    clq_clip_def clip = {};

private:
    std::vector<float> times_;
    std::vector<std::vector<float>> turns_;  // a node: quaternions
    std::vector<clq_channel_def> channels_;
};

}  // namespace scenes::hundred
