// The swimming motion of a dragon in the air: a wave that runs down its body, with rowing legs. One clip that loops
// without a seam.
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
    std::vector<std::vector<float>> turns_;  // for each node: quaternions
    std::vector<clq_channel_def> channels_;
};

}  // namespace scenes::hundred
