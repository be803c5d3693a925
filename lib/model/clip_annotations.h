// What a rig knows of a clip besides its channels: markers and root motion.
#pragma once

#include <cstdint>

namespace claque::model
{

struct Rig;

// A named time of a clip, such as a foot contact. Its name is in Rig::marker_names.
struct Marker {
    uint32_t clip = 0;
    float time_s = 0;  // on the clip's own axis, within the clip
};

// The root motion that has been taken out of a clip's channels: samples at equal times from the clip's start to its
// end. Each is x, z and yaw about y in model space, relative to the first; linear in between.
struct RootCurve {
    uint32_t clip = 0;
    uint32_t first_sample = 0, sample_count = 0;  // of Rig::root_samples, three numbers each; at least 2
};

// Checks markers and root curves as check(Rig) does. Both are sorted by clip, the markers of a clip by time.
void check_annotations(const Rig &rig);

}  // namespace claque::model
