#include "lib/frame/node_matrix.h"

#include "lib/behave/active_clips.h"
#include "lib/math/eye_transform.h"
#include "lib/pose/pose.h"

namespace claque::frame
{

namespace
{

struct Memory {
    Memory(const model::Rig &rig, const model::Motion &motion, std::pmr::memory_resource *resource)
        : locals(rig.node_count(), resource),
          globals(rig.node_count(), resource),
          palette(rig.palette.size() + 1, resource),
          weights(rig.rest_weights.size(), resource),
          dofs(rig.dofs.size(), resource),
          scratch(pose::scratch_floats(rig, &motion), resource)
    {
    }
    std::pmr::vector<math::Trs> locals;
    std::pmr::vector<math::Columns> globals;
    std::pmr::vector<math::Affine> palette;
    std::pmr::vector<float> weights, dofs, scratch;
};

// A query for a node's matrix must not run the host's mechanisms.
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

void node_world_matrix(const crowd::Crowd &crowd, const Frame &frame, uint32_t row, uint32_t node, double time_s,
                       double out_matrix[16])
{
    const model::Template &tmpl = crowd.template_of(row);
    const model::Rig &rig = tmpl.rig;
    const ActorVisibility visibility = frame.visibility(crowd, row);
    const bool shown = time_s != time_s;
    const double tick_s = !shown ? time_s : visibility.visible ? visibility.shown_s : frame.last_time_s();
    const model::Level &level = tmpl.levels[shown && visibility.visible ? visibility.level : 0];

    Memory memory(rig, tmpl.motion, crowd.memory());
    behave::EvaluationContext context;
    context.time_s = tick_s;
    context.level = &level;
    context.distance_m = visibility.distance * frame.settings().caches.metres_per_unit;
    context.levels =
        shown && visibility.visible ? frame.mechanism_levels(row) : behave::mechanism_levels(crowd, row, 0, level);
    context.levels = without_host(crowd, row, context.levels);
    behave::Counts uncounted;
    behave::run(crowd, row, context, base::Span<float>(memory.dofs), uncounted);

    behave::ActiveClips clips;
    behave::active_clips_at(crowd, row, tick_s, context.levels, clips);
    pose::PoseJob job;
    job.rig = &rig;
    job.motion = &tmpl.motion;
    job.clip = clips.clip;
    job.time_s = clips.clip_time_s;
    job.layers = {clips.layers, clips.count};
    job.scratch = base::Span<float>(memory.scratch);
    job.dofs = memory.dofs.data();
    job.locals = base::Span<math::Trs>(memory.locals);
    job.globals = base::Span<math::Columns>(memory.globals);
    job.palette = base::Span<math::Affine>(memory.palette);
    job.weights = base::Span<float>(memory.weights);
    job.feet = {clips.feet, clips.foot_count};
    job.upper = clips.upper;
    job.run();

    crowd::Transform root;
    if (!shown || !frame.root_of(crowd, row, root)) {
        root = crowd::reference_of(crowd, row, shown ? frame.last_time_s() : time_s);
        if (crowd.behaviours().has_root_path_play(row))
            root = composed(root, behave::root_transform_at(crowd, row, shown ? frame.last_time_s() : time_s));
    }
    const glm::dmat3 axes = math::rotation_of(root.orientation) * double(root.scale);
    for (int k = 0; k < 4; ++k) {
        const math::F4 &c = memory.globals[node].c[k];
        const glm::dvec3 column = axes * glm::dvec3(c[0], c[1], c[2]) + (k == 3 ? root.position : glm::dvec3(0));
        for (int i = 0; i < 3; ++i) out_matrix[4 * k + i] = column[i];
        out_matrix[4 * k + 3] = k == 3 ? 1 : 0;
    }
}

}  // namespace claque::frame
