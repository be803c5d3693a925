// S0 4.2 step 3: places the Skeleton Roots of actors that passed phase 1 in the world, from Reference Point, root path
// and ground.
#include <algorithm>
#include <cmath>

#include "lib/frame/steps.h"

namespace claque::frame
{

bool follows_ground(const crowd::Crowd &crowd, uint32_t row)
{
    const crowd::Extra *extra = crowd.ground() ? crowd.extra_of(row) : nullptr;
    return extra && (extra->max_up != 0 || extra->max_down != 0) && crowd.group_of(row) == model::none;
}

namespace
{

// Host code: runs on the caller's thread, one call after the other.
void put_on_ground(const Given &given, uint32_t row, crowd::Transform &root)
{
    const crowd::Crowd &crowd = given.crowd;
    const crowd::Extra *extra = crowd.extra_of(row);
    const double at[3] = {root.position.x, root.position.y, root.position.z};
    double height = std::nan("");
    given.host_calls.run("the ground's height function", row + 1,
                         [&] { height = crowd.ground()(crowd.ground_user(), at); });
    const double step = height - root.position.y;
    // NaN: there is no ground here.
    if (step == step) root.position.y += std::clamp(step, -double(extra->max_down), double(extra->max_up));
}

}  // namespace

base::Status PlaceRoots::check() const
{
    for (const Candidate &candidate : candidates)
        if (candidate.row >= given.crowd.row_count())
            return base::Status::bad(CLQ_ARGUMENT, "a candidate in row %u of %u", candidate.row,
                                     given.crowd.row_count());
    return check_motions(given, motions);
}

void PlaceRoots::run() const
{
    const crowd::Crowd &crowd = given.crowd;
    given.for_slices(candidates.count, [&](uint32_t i) {
        const uint32_t row = candidates[i].row;
        crowd::Transform &root = candidates[i].root;
        const uint32_t follow_slot = crowd.follows().slot_of(row);
        root = follow_slot != model::none ? crowd::placed_on_track(motions[follow_slot], crowd.transform_of(row).scale)
                                          : crowd.world_transform_of(row);
        if (crowd.behaviours().has_root_path_play(row))
            root = composed(root, behave::root_transform_at(crowd, row, given.time_s));
    });
    if (crowd.ground())
        for (Candidate &candidate : candidates)
            if (follows_ground(crowd, candidate.row)) put_on_ground(given, candidate.row, candidate.root);
    stats.roots_placed = candidates.count;
}

}  // namespace claque::frame
