#include "lib/pose/facing_in_clips.h"

#include <algorithm>

#include "lib/pose/pose.h"

namespace claque::pose
{

namespace
{

constexpr uint32_t most_clips = 32;

model::Facing facing_at(const model::Rig &rig, Workspace &work, uint32_t clip, double part)
{
    const model::Clip &of = rig.clips[clip];
    work.pose(clip, double(of.start_s) + part * double(of.duration_s));
    std::vector<math::Affine> globals(rig.node_count());
    for (uint32_t i = 0; i < rig.node_count(); ++i) globals[i] = work.global(i);
    return model::facing_of(rig, globals);
}

// The first way that it faces at five of seven moments: dancers turn, falls show no facing, and toes of runners swing.
model::Facing steady_facing(const model::Rig &rig, Workspace &work, uint32_t clip)
{
    if (!(rig.clips[clip].duration_s > 0)) return facing_at(rig, work, clip, 0.5);
    model::Facing first[4];
    uint32_t moments[4] = {0, 0, 0, 0};
    for (const double part : {0.5, 0.05, 0.2, 0.35, 0.65, 0.8, 0.95}) {
        const model::Facing facing = facing_at(rig, work, clip, part);
        if (!facing.seen) continue;
        const int quarter = model::quarter_of(facing.heading_deg);
        if (moments[quarter]++ == 0) first[quarter] = facing;
        if (moments[quarter] == 5) return first[quarter];
    }
    return {};
}

}  // namespace

model::Facing facing_in(const model::Rig &rig, const model::Motion *motion, uint32_t clip)
{
    Workspace work(rig, motion);
    return facing_at(rig, work, clip, 0.5);
}

model::Facing facing_in_clips(const model::Rig &rig)
{
    if (rig.clips.empty()) return model::facing_of(rig);
    Workspace work(rig);
    model::Facing first[4];
    uint32_t votes[4] = {0, 0, 0, 0};
    const uint32_t count = std::min(static_cast<uint32_t>(rig.clips.size()), most_clips);
    for (uint32_t clip = 0; clip < count; ++clip) {
        const model::Facing facing = steady_facing(rig, work, clip);
        if (!facing.seen) continue;
        const int quarter = model::quarter_of(facing.heading_deg);
        if (votes[quarter]++ == 0) first[quarter] = facing;
    }
    const int front = model::quarter_of(0), most = int(std::max_element(votes, votes + 4) - votes);
    return first[votes[front] == votes[most] ? front : most];
}

}  // namespace claque::pose
