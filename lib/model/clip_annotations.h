// What is known of a clip beside its channels: moments with names, and the way that was taken out of its poses.
#pragma once

#include <cstdint>

namespace claque::model
{

struct Rig;

// A named moment of a clip: a foot touches the ground, a hand lets go. Its name stands in Rig::marker_names.
struct Marker {
    uint32_t clip = 0;
    float time_s = 0;  // on the clip's own axis, within it
};

// The way of a clip's root over the ground, which its channels do not hold (any more): samples at equal times from the
// clip's start to its end, each x, z and yaw about y in model space, against the first one; straight in between.
struct RootCurve {
    uint32_t clip = 0;
    uint32_t first_sample = 0, sample_count = 0;  // of Rig::root_samples, three numbers each; at least 2
};

// As check(Rig), of these. Markers and tracks stand in the order of their clips, markers of a clip in that of time.
void check_annotations(const Rig &rig);

}  // namespace claque::model
