// S0 4.2 step 3: the Skeleton Roots of who passed phase 1, in the world: the Reference Point, the way round it, the ground.
#include <algorithm>

#include "lib/frame/steps.h"

namespace claque::frame
{

void Update::place_root(Candidate &candidate) const
{
    const uint32_t row = candidate.row;
    candidate.root = crowd.world_transform_of(row);
    if (crowd.behaviours().has_root_path_play(row))
        candidate.root = composed(candidate.root, behave::root_transform_at(crowd, row, time_s));
}

bool Update::follows_ground(uint32_t row) const
{
    const crowd::Extra *extra = crowd.ground() ? crowd.extra_of(row) : nullptr;
    return extra && (extra->max_up != 0 || extra->max_down != 0) && crowd.group_of(row) == model::none;
}

namespace
{

// Host's code: on the caller's thread, one after the other.
void put_on_ground(const crowd::Crowd &crowd, uint32_t row, crowd::Transform &root)
{
    const crowd::Extra *extra = crowd.extra_of(row);
    const double at[3] = {root.position.x, root.position.y, root.position.z};
    const double step = crowd.ground()(crowd.ground_user(), at) - root.position.y;
    // Not a number: there is no ground here.
    if (step == step) root.position.y += std::clamp(step, -double(extra->max_down), double(extra->max_up));
}

}  // namespace

void Update::place_roots()
{
    const uint32_t count = static_cast<uint32_t>(frame.candidates_.size());
    for_slices(count, [this](uint32_t i) { place_root(frame.candidates_[i]); });
    if (crowd.ground())
        for (Candidate &candidate : frame.candidates_)
            if (follows_ground(candidate.row)) put_on_ground(crowd, candidate.row, candidate.root);
    frame.stats_.roots_placed = count;
}

}  // namespace claque::frame
