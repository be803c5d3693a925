#include "lib/frame/posed_at.h"

#include "lib/behave/active_clips.h"
#include "lib/pose/pose.h"
#include "lib/skin/skin.h"

namespace claque::frame
{

namespace
{

// The mechanisms' levels without the host's mechanisms, which only updates may run.
behave::MechanismLevels without_host(const crowd::Crowd &crowd, uint32_t row, behave::MechanismLevels levels)
{
    const crowd::Behaviours &behaviours = crowd.behaviours();
    uint32_t k = 0;
    for (uint32_t i = behaviours.first_attachment(row); i != model::none; i = behaviours.attachment_at(i).next, ++k)
        if (std::holds_alternative<crowd::HostMechanism>(
                behaviours.mechanism(behaviours.attachment_at(i).mechanism).kind))
            levels |= behave::MechanismLevels(behave::off) << (4 * k);
    return levels;
}

}  // namespace

crowd::Transform root_at(const crowd::Crowd &crowd, uint32_t row, double time_s)
{
    const crowd::Transform root = crowd::reference_of(crowd, row, time_s);
    if (!crowd.behaviours().has_root_path_play(row)) return root;
    return composed(root, behave::root_transform_at(crowd, row, time_s));
}

PosedAt::PosedAt(const model::Template &tmpl, std::pmr::memory_resource *memory)
    : tmpl_(tmpl),
      locals_(tmpl.rig.node_count(), memory),
      globals_(tmpl.rig.node_count(), memory),
      palette_(tmpl.rig.palette.size() + 1, memory),
      weights_(tmpl.rig.rest_weights.size(), memory),
      dofs_(tmpl.rig.dofs.size(), memory),
      scratch_(pose::scratch_floats(tmpl.rig, &tmpl.motion), memory),
      skinning_(memory),
      positions_(memory)
{
}

void PosedAt::pose(const crowd::Crowd &crowd, uint32_t row, const model::Level &level, behave::MechanismLevels levels,
                   double time_s, float distance_m)
{
    behave::EvaluationContext context;
    context.time_s = time_s;
    context.level = &level;
    context.distance_m = distance_m;
    context.levels = without_host(crowd, row, levels);
    behave::Counts uncounted;
    behave::run(crowd, row, context, base::Span<float>(dofs_), uncounted);

    behave::ActiveClips clips;
    behave::active_clips_at(crowd, row, time_s, context.levels, clips);
    pose::PoseJob job;
    job.rig = &tmpl_.rig;
    job.motion = &tmpl_.motion;
    job.clip = clips.clip;
    job.time_s = clips.clip_time_s;
    job.layers = {clips.layers, clips.count};
    job.scratch = base::Span<float>(scratch_);
    job.dofs = dofs_.data();
    job.locals = base::Span<math::Trs>(locals_);
    job.globals = base::Span<math::Columns>(globals_);
    job.palette = base::Span<math::Affine>(palette_);
    job.weights = base::Span<float>(weights_);
    job.feet = {clips.feet, clips.foot_count};
    job.upper = clips.upper;
    job.run();
}

const float *PosedAt::skin(const model::Level &level)
{
    const uint32_t entries = static_cast<uint32_t>(tmpl_.rig.palette.size()), count = level.vertex_count;
    skin::SkinJob job;
    job.level = &level;
    job.palette = {palette_.data(), entries};
    job.morph_weights = {weights_.data(), static_cast<uint32_t>(weights_.size())};
    job.normals = skin::normals_of(tmpl_);
    skinning_.resize(skin::scratch_floats(level, entries, job.normals));
    positions_.resize(6 * size_t(count));
    job.scratch = base::Span<float>(skinning_);
    job.out_positions = {positions_.data(), 3 * count};
    job.out_normals = {positions_.data() + 3 * size_t(count), 3 * count};
    job.run();
    return positions_.data();
}

}  // namespace claque::frame
