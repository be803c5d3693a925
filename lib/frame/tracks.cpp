// Before the first cull phase: where tracks have the actors that follow one. Tracks lie all over the memory, so each is
// read once in an update.
#include "lib/frame/steps.h"

namespace claque::frame
{

base::Status FollowTracks::check() const
{
    if (given.crowd.follows().count() > 0 && motions.count < tested.count)
        return base::Status::bad(CLQ_ARGUMENT, "no room for the motions of all that are tested");
    return base::Status::good();
}

base::Status check_motions(const Given &given, base::Span<const Candidate> candidates,
                           base::Span<const track::Motion> motions)
{
    if (given.crowd.follows().count() == 0) return base::Status::good();
    for (const Candidate &candidate : candidates)
        if (candidate.tested >= motions.count)
            return base::Status::bad(CLQ_ARGUMENT, "a candidate of motion %u of %u", candidate.tested,
                                     static_cast<uint32_t>(motions.count));
    return base::Status::good();
}

void FollowTracks::run() const
{
    const crowd::Follows &follows = given.crowd.follows();
    if (follows.count() == 0) return;
    given.for_slices(tested.count, [&](uint32_t i) {
        if (const crowd::Follow *follow = follows.of(tested[i])) {
            const double track_time_s = crowd::track_time(*follow, given.time_s);
            motions[i] = track::motion_at(crowd::piece_at(*follow, track_time_s), track_time_s);
        } else {
            motions[i] = track::Motion();
            motions[i].present = true;
        }
    });
}

}  // namespace claque::frame
