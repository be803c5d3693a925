// The memory of pose jobs for start-up code and tests (pose.h).
#include "lib/pose/pose.h"

namespace claque::pose
{

using math::Columns;

Workspace::Workspace(const model::Rig &rig, const model::Motion *motion)
    : rig_(&rig),
      motion_(motion),
      locals_(rig.node_count()),
      globals_(rig.node_count()),
      palette_(rig.palette.size() + 1),
      weights_(rig.rest_weights.size()),
      scratch_(scratch_floats(rig, motion))
{
}

PoseJob Workspace::job()
{
    PoseJob job;
    job.rig = rig_;
    job.motion = motion_;
    job.locals = base::Span<math::Trs>(locals_);
    job.globals = base::Span<Columns>(globals_);
    job.scratch = base::Span<float>(scratch_);
    job.palette = base::Span<math::Affine>(palette_.data(), static_cast<uint32_t>(rig_->palette.size()));
    job.weights = base::Span<float>(weights_);
    return job;
}

base::Span<const math::Affine> Workspace::pose(uint32_t clip, double time_s)
{
    PoseJob now = job();
    now.clip = clip;
    now.time_s = time_s;
    now.run();
    return {palette_.data(), static_cast<uint32_t>(rig_->palette.size())};
}

math::Affine Workspace::global(uint32_t node) const
{
    math::Affine out;
    for (int k = 0; k < 4; ++k) math::store3(out.c + 3 * k, globals_[node].c[k]);
    return out;
}

}  // namespace claque::pose
