// Two legs for a character of two nodes (small_template.h), a clip that swings them, and tracks for it.
#pragma once

#include <claque/track.h>

#include "tests/api/small_template.h"

struct Walker {
    // Adds six nodes and two channels to `small` and its clip.
    explicit Walker(SmallTemplate &small);
    Walker(const Walker &) = delete;
    Walker &operator=(const Walker &) = delete;

    static clq_locomotion_def locomotion(const clq_template *tmpl, const uint32_t *clip);
    // A way of some seconds with a stand in it; `seed` changes it.
    static clq_status track(const clq_locomotion *locomotion, uint32_t seed, clq_track **out);

private:
    clq_node_def nodes_[8];
    clq_channel_def channels_[3];
    clq_clip_def clip_;
    float times_[3], values_[2][12];
};
