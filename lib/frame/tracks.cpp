// Before the first cull phase: evaluates the tracks that actors follow. Tracks are scattered in memory, so each is read
// once in an update.
#include "lib/frame/steps.h"

namespace claque::frame
{

base::Status FollowTracks::check() const { return check_motions(given, {motions.data, motions.count}); }

base::Status check_motions(const Given &given, base::Span<const track::Motion> motions)
{
    if (motions.count < given.crowd.follows().slot_count())
        return base::Status::bad(CLQ_ARGUMENT, "%u motions for %u actors on tracks", motions.count,
                                 given.crowd.follows().slot_count());
    return base::Status::good();
}

void FollowTracks::run() const
{
    const crowd::Follows &follows = given.crowd.follows();
    if (follows.count() == 0) return;
    given.for_slices(tested.count, [&](uint32_t i) {
        const crowd::Follow *follow = follows.of(tested[i]);
        if (!follow) return;
        const double track_time_s = crowd::track_time(*follow, given.time_s);
        motions[follows.slot_of(tested[i])] = track::motion_at(crowd::piece_at(*follow, track_time_s), track_time_s);
    });
}

}  // namespace claque::frame
