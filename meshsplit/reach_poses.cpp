#include "meshsplit/reach_poses.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/vector_double1.hpp>
#include <glm/geometric.hpp>

#include "meshsplit/spheres.h"

namespace claque::meshsplit
{

std::vector<PoseAt> poses_of(const model::Rig &rig)
{
    std::vector<PoseAt> poses(1);
    size_t count = 1;
    for (uint32_t clip = 0; clip < rig.clips.size(); ++clip) count += sample_count(rig, clip);
    poses.reserve(count);
    for (uint32_t clip = 0; clip < rig.clips.size(); ++clip)
        for (const double time : sample_times(rig, clip)) poses.push_back({clip, time});
    return poses;
}

bool is_continuous(const std::vector<PoseAt> &poses, size_t i)
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

void MotionBound::merge(const MotionBound &other)
{
    reach = std::max(reach, other.reach);
    speed = std::max(speed, other.speed);
    acceleration = std::max(acceleration, other.acceleration);
}

NodeMotionBound::NodeMotionBound(const math::Trs &from, const math::Trs &to)
{
    scale = 0;
    for (int k = 0; k < 3; ++k) {
        scale = std::max({scale, std::fabs(double(from.scale[k])), std::fabs(double(to.scale[k]))});
        growth = std::max(growth, std::fabs(double(to.scale[k]) - double(from.scale[k])));
    }
    // For unit quaternions at most a quarter turn apart (along the shorter arc) the chord c is 2 sin(angle / 4). The
    // angle is below 2.2215 c, because asin(x) / x grows up to x = sqrt(1 / 2), where it is 1.1107.
    double chord2 = 0, other2 = 0;
    for (int k = 0; k < 4; ++k) {
        const double a = double(from.rotation[k]), b = double(to.rotation[k]);
        chord2 += (a - b) * (a - b), other2 += (a + b) * (a + b);
    }
    turn = 2.2215 * std::sqrt(std::min(chord2, other2));
    offset = std::max(glm::length(glm::dvec3(from.translation)), glm::length(glm::dvec3(to.translation)));
    travel = glm::distance(glm::dvec3(from.translation), glm::dvec3(to.translation));
}

namespace
{

// A cubic polynomial's second derivative is linear. Values at 0, 1/3, 2/3 and 1 give it at both ends, and the larger
// one is the maximum. (Normalised cubic quaternion polynomials are cubic except for terms that vanish with the fourth
// power of the time between samples.)
template <class Vector>
double cubic_acceleration(const Vector &a, const Vector &b, const Vector &c, const Vector &d)
{
    const Vector start = (a * 2.0 - b * 5.0 + c * 4.0 - d) * 9.0, end = (d * 2.0 - c * 5.0 + b * 4.0 - a) * 9.0;
    return std::sqrt(std::max(glm::dot(start, start), glm::dot(end, end)));
}

glm::dvec4 near(const glm::quat &q, const glm::quat &other)
{
    const glm::dvec4 v(q.x, q.y, q.z, q.w), o(other.x, other.y, other.z, other.w);
    return glm::dot(v, o) < 0 ? -v : v;
}

}  // namespace

NodeMotionBound::NodeMotionBound(const math::Trs *const (&t)[4]) : NodeMotionBound(*t[0], *t[3])
{
    const auto acceleration_of = [&](const auto &part) {
        return cubic_acceleration(part(*t[0]), part(*t[1]), part(*t[2]), part(*t[3]));
    };
    travel_acceleration = acceleration_of([](const math::Trs &trs) { return glm::dvec3(trs.translation); });
    scale_acceleration = acceleration_of([](const math::Trs &trs) { return glm::dvec3(trs.scale); });
    // Angular velocity is twice the velocity of a unit quaternion, and so are the derivatives.
    turn_acceleration = 2 * acceleration_of([&](const math::Trs &trs) { return near(trs.rotation, t[0]->rotation); });
    // Speed differs from its mean by at most the second derivative, and position from the chord by at most an eighth of
    // it.
    travel += travel_acceleration, growth += scale_acceleration, turn += turn_acceleration;
    offset += travel_acceleration / 8, scale += scale_acceleration / 8;
}

// x = T + R D S y, by the product rule; D, the degrees of freedom, is constant.
MotionBound NodeMotionBound::of(const MotionBound &inner, double max_shift) const
{
    const double reach = scale * inner.reach + max_shift;
    const double speed = scale * inner.speed + growth * inner.reach;
    const double acceleration =
        scale * inner.acceleration + 2 * growth * inner.speed + scale_acceleration * inner.reach;
    return {offset + reach, travel + turn * reach + speed,
            travel_acceleration + (turn * turn + turn_acceleration) * reach + 2 * turn * speed + acceleration};
}

MotionMap::MotionMap(const MotionMap &above, const NodeMotionBound &node, double max_shift)
    : origin_(above.of(node.of({}, max_shift)))
{
    const double turns = node.turn * node.turn + node.turn_acceleration;
    const double speed = node.turn * node.scale + node.growth;
    const double acceleration = turns * node.scale + 2 * node.turn * node.growth + node.scale_acceleration;
    scale_ = above.scale_ * node.scale;
    reach_to_speed_ = above.scale_ * speed + above.reach_to_speed_ * node.scale;
    reach_to_acceleration_ =
        above.scale_ * acceleration + above.speed_to_acceleration_ * speed + above.reach_to_acceleration_ * node.scale;
    speed_to_acceleration_ = above.scale_ * 2 * speed + above.speed_to_acceleration_ * node.scale;
}

MotionBound MotionMap::of(const MotionBound &inner) const
{
    return {origin_.reach + scale_ * inner.reach, origin_.speed + scale_ * inner.speed + reach_to_speed_ * inner.reach,
            origin_.acceleration + scale_ * inner.acceleration + speed_to_acceleration_ * inner.speed +
                reach_to_acceleration_ * inner.reach};
}

namespace
{

// The largest total rotation and growth between two poses, in radians; larger segments are halved.
constexpr double max_segment_turn = 0.15;
constexpr int max_halvings = 6;

class Walk
{
public:
    Walk(const model::Rig &rig, const Visit &visit, uint64_t maximum)
        : rig_(rig), visit_(visit), left_(maximum), poser_(rig)
    {
        segment_.nodes.resize(rig.node_count());
        segment_.weights.resize(rig.rest_weights.size());
        segment_.weight_accelerations.resize(rig.rest_weights.size());
    }

    bool run()
    {
        const std::vector<PoseAt> poses = poses_of(rig_);
        Locals to;
        for (size_t i = 0; i < poses.size(); ++i) {
            if (left_ == 0) return false;
            poser_.pose(poses[i], to);
            if (i > 0 && is_continuous(poses, i - 1)) go(poses[i - 1].time_s, poses[i], to, 0);
            else visit(poses[i], to, nullptr);
            std::swap(from_, to);
        }
        return true;
    }

private:
    // From from_, a pose of the same clip at `start`.
    void go(double start, const PoseAt &end, const Locals &to, int halvings)
    {
        if (left_ == 0) return;
        find_segment(start, end, to);
        if (halvings < max_halvings && max_turn() > max_segment_turn) {
            const PoseAt middle = {end.clip, 0.5 * (start + end.time_s)};
            Locals between;
            poser_.pose(middle, between);
            go(start, middle, between, halvings + 1);
            std::swap(from_, between);
            go(middle.time_s, end, to, halvings + 1);
            return;
        }
        visit(end, to, &segment_);
    }

    void visit(const PoseAt &at, const Locals &locals, const PoseSegment *since)
    {
        if (left_ == 0) return;
        --left_;
        visit_(at, locals, since);
    }

    void find_segment(double start, const PoseAt &end, const Locals &to)
    {
        const bool cubic = is_cubic(end.clip);
        for (int k = 0; k < 2 && cubic; ++k)
            poser_.pose({end.clip, start + (end.time_s - start) * (k + 1) / 3}, thirds_[k]);
        for (uint32_t n = 0; n < rig_.node_count(); ++n)
            segment_.nodes[n] =
                cubic ? NodeMotionBound({&from_.nodes[n], &thirds_[0].nodes[n], &thirds_[1].nodes[n], &to.nodes[n]})
                      : NodeMotionBound(from_.nodes[n], to.nodes[n]);
        for (size_t w = 0; w < segment_.weights.size(); ++w) {
            const auto at = [w](const Locals &locals) { return glm::dvec1(double(locals.weights[w])); };
            segment_.weight_accelerations[w] =
                cubic ? cubic_acceleration(at(from_), at(thirds_[0]), at(thirds_[1]), at(to)) : 0;
            segment_.weights[w] = std::fabs(at(to).x - at(from_).x) + segment_.weight_accelerations[w];
        }
    }

    double max_turn() const
    {
        double maximum = 0;
        std::vector<double> sums(rig_.node_count());
        for (uint32_t n = 0; n < rig_.node_count(); ++n) {
            const NodeMotionBound &motion_bound = segment_.nodes[n];
            sums[n] = motion_bound.turn + motion_bound.growth / std::max(motion_bound.scale, 1e-30);
            if (rig_.parents[n] != model::none) sums[n] += sums[rig_.parents[n]];
            maximum = std::max(maximum, sums[n]);
        }
        return maximum;
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
    uint64_t left_;  // poses that may still be visited
    LocalPoser poser_;
    Locals from_, thirds_[2];
    PoseSegment segment_;
};

}  // namespace

bool walk_poses(const model::Rig &rig, const Visit &visit, uint64_t maximum) { return Walk(rig, visit, maximum).run(); }

std::vector<double> max_shifts(const model::Rig &rig)
{
    std::vector<double> out(rig.node_count());
    for (const model::Dof &dof : rig.dofs)
        if (dof.kind == model::DofKind::translation)
            out[dof.node] += 1.001 * std::max(std::fabs(double(dof.min)), std::fabs(double(dof.max)));
    return out;
}

}  // namespace claque::meshsplit
