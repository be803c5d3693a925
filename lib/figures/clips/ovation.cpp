// Applauding and cheering on one's feet for a while: out of `stand`, into the loops of applaud and cheer, and back.
#include <cmath>

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/stance.h"

namespace claque::figures
{

namespace
{

// Bone by bone, and on feet that stay where they are in `stand`.
Pose between_poses(const Pose &from, const Pose &to, float share, float heels_deg)
{
    Pose pose;
    for (int b = 0; b < bone_count; ++b) {
        const Bone bone = static_cast<Bone>(b);
        pose.set(bone, part(from.local(bone), to.local(bone), share));
        pose.set_shift(bone, from.shift(bone) + (to.shift(bone) - from.shift(bone)) * share);
    }
    for (const Side side : {Side::left, Side::right})
        stand_on(pose, side, {0.012f, side == Side::left ? 0.016f : -0.010f, share * heels_deg, 1, 0, 5});
    return pose;
}

float loop(float phase, int loops)
{
    return phase * static_cast<float>(loops) - std::floor(phase * static_cast<float>(loops));
}

}  // namespace

Pose stand_applaud_at(float phase)
{
    return between_poses(stand_at(phase), applaud_at(loop(phase, 2)), hold(phase, 0.02f, 0.18f, 0.82f, 0.98f), 0);
}

Pose stand_cheer_at(float phase)
{
    return between_poses(stand_at(phase), cheer_at(loop(phase, 2)), hold(phase, 0.02f, 0.22f, 0.78f, 0.98f),
                         cheer_heels_deg(loop(phase, 2)));
}

}  // namespace claque::figures
