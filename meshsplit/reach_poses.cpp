#include "meshsplit/reach_poses.h"

#include "meshsplit/spheres.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace claque::meshsplit
{

std::vector<PoseAt> poses_of(const model::Rig &rig)
{
    std::vector<PoseAt> poses(1);
    for (uint32_t clip = 0; clip < rig.clips.size(); ++clip)
        for (const double time : sample_times(rig, clip)) poses.push_back({clip, time});
    return poses;
}

bool leads(const std::vector<PoseAt> &poses, size_t i)
{
    return i + 1 < poses.size() && poses[i].clip == poses[i + 1].clip && poses[i].clip != model::none &&
           poses[i + 1].time_s - poses[i].time_s > 1e-5;
}

LocalPoser::LocalPoser(const model::Rig &rig)
    : rig_(&rig), dofs_(rig.dofs.size()), globals_(rig.node_count()), palette_(rig.palette.size() + 1)
{
}

void LocalPoser::pose(const PoseAt &at, Locals &out)
{
    out.nodes.resize(rig_->node_count());
    out.weights.resize(rig_->rest_weights.size());
    pose::PoseJob job;
    job.rig = rig_;
    job.clip = at.clip;
    job.time_s = at.time_s;
    job.dofs = dofs_.data();
    job.locals = base::Span<math::Trs>(out.nodes);
    job.globals = base::Span<math::Columns>(globals_);
    job.palette = base::Span<math::Affine>(palette_);
    job.weights = base::Span<float>(out.weights);
    job.run();
}

void Drift::take_in(const Drift &other)
{
    reach = std::max(reach, other.reach);
    speed = std::max(speed, other.speed);
    bend = std::max(bend, other.bend);
}

NodeDrift::NodeDrift(const math::Trs &from, const math::Trs &to)
{
    scale = 0;
    for (int k = 0; k < 3; ++k) {
        scale = std::max({scale, std::fabs(double(from.scale[k])), std::fabs(double(to.scale[k]))});
        growth = std::max(growth, std::fabs(double(to.scale[k]) - double(from.scale[k])));
    }
    // Of unit quaternions at most a quarter turn apart (the shorter arc) the chord c is 2 sin(turn / 4): turn is below
    // 2.2215 c, because asin(x) / x grows up to x = sqrt(1 / 2), where it is 1.1107.
    double chord2 = 0, other2 = 0;
    for (int k = 0; k < 4; ++k) {
        const double a = double(from.rotation[k]), b = double(to.rotation[k]);
        chord2 += (a - b) * (a - b), other2 += (a + b) * (a + b);
    }
    turn = 2.2215 * std::sqrt(std::min(chord2, other2));
    offset = std::max(glm::length(glm::dvec3(from.translation)), glm::length(glm::dvec3(to.translation)));
    travel = glm::distance(glm::dvec3(from.translation), glm::dvec3(to.translation));
}

// x = T + R D S y, by the product rule; D, what degrees of freedom do, stands still.
Drift NodeDrift::of(const Drift &inner, double most_shift) const
{
    const double reach = scale * inner.reach + most_shift;
    const double speed = scale * inner.speed + growth * inner.reach;
    const double bend = scale * inner.bend + 2 * growth * inner.speed;
    return {offset + reach, travel + turn * reach + speed, turn * turn * reach + 2 * turn * speed + bend};
}

namespace
{

// The most that anything turns and grows in all between two poses, in radians: from there on they are halved.
constexpr double much = 0.15;
constexpr int most_halvings = 6;

class Walk
{
public:
    Walk(const model::Rig &rig, const Visit &visit) : rig_(rig), visit_(visit), poser_(rig), drifts_(rig.node_count())
    {
    }

    void run()
    {
        const std::vector<PoseAt> poses = poses_of(rig_);
        Locals to;
        for (size_t i = 0; i < poses.size(); ++i) {
            poser_.pose(poses[i], to);
            if (i > 0 && leads(poses, i - 1)) go(poses[i - 1].time_s, poses[i], to, 0);
            else visit_(poses[i], to, nullptr);
            std::swap(from_, to);
        }
    }

private:
    // From from_, which is of the same clip at `start`.
    void go(double start, const PoseAt &end, const Locals &to, int halvings)
    {
        double most = 0;
        std::vector<double> sums(rig_.node_count());
        for (uint32_t n = 0; n < rig_.node_count(); ++n) {
            drifts_[n] = NodeDrift(from_.nodes[n], to.nodes[n]);
            sums[n] = drifts_[n].turn + drifts_[n].growth / std::max(drifts_[n].scale, 1e-30);
            if (rig_.parents[n] != model::none) sums[n] += sums[rig_.parents[n]];
            most = std::max(most, sums[n]);
        }
        // Within a piece of a cubic spline speed changes: such are looked at more closely whatever they do.
        const int least = is_cubic(end.clip) ? 2 : 0;
        if (halvings >= least && (most <= much || halvings >= most_halvings)) {
            visit_(end, to, &drifts_);
            return;
        }
        const PoseAt middle = {end.clip, 0.5 * (start + end.time_s)};
        Locals between;
        poser_.pose(middle, between);
        go(start, middle, between, halvings + 1);
        std::swap(from_, between);
        go(middle.time_s, end, to, halvings + 1);
    }

    bool is_cubic(uint32_t clip) const
    {
        const model::Channel *first = rig_.channels.data() + rig_.clips[clip].first_channel;
        return std::any_of(first, first + rig_.clips[clip].channel_count, [](const model::Channel &channel) {
            return channel.interpolation == model::Interpolation::cubic_spline;
        });
    }

    const model::Rig &rig_;
    const Visit &visit_;
    LocalPoser poser_;
    Locals from_;
    std::vector<NodeDrift> drifts_;
};

}  // namespace

void walk_poses(const model::Rig &rig, const Visit &visit) { Walk(rig, visit).run(); }

std::vector<double> most_shifts(const model::Rig &rig)
{
    std::vector<double> out(rig.node_count());
    for (const model::Dof &dof : rig.dofs)
        if (dof.kind == model::DofKind::translation)
            out[dof.node] += 1.001 * std::max(std::fabs(double(dof.first)), std::fabs(double(dof.last)));
    return out;
}

}  // namespace claque::meshsplit
