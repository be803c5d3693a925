#include "meshsplit/motion_error.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "meshsplit/blend_reach.h"
#include "meshsplit/largest.h"
#include "meshsplit/reach_poses.h"

namespace claque::meshsplit
{

using math::Affine;
using model::none;

namespace
{

double square_sum(const Affine &a)
{
    double sum = 0;
    for (int i = 0; i < 9; ++i) sum += double(a.c[i]) * double(a.c[i]);
    return sum;
}

Affine minus(const Affine &a, const Affine &b)
{
    Affine out;
    for (int i = 0; i < 12; ++i) out.c[i] = a.c[i] - b.c[i];
    return out;
}

// Every 64th first, then those between, so that a poor rate is rejected early.
std::vector<uint32_t> coarse_first(size_t count)
{
    std::vector<uint32_t> out;
    out.reserve(count);
    for (uint32_t i = 0; i < count; i += 64) out.push_back(i);
    for (uint32_t step = 64; step > 1; step /= 2)
        for (uint32_t i = step / 2; i < count; i += step) out.push_back(i);
    return out;
}

void globals_of(const model::Rig &rig, base::Span<const math::Trs> locals, std::vector<Affine> &out)
{
    for (uint32_t n = 0; n < rig.node_count(); ++n) {
        const Affine own = math::affine_of(locals[n]);
        out[n] = rig.parents[n] == none ? own : math::mul(out[rig.parents[n]], own);
    }
}

}  // namespace

void MotionError::merge(const MotionError &other)
{
    metres = std::max(metres, other.metres);
    radians = std::max(radians, other.radians);
}

MotionMeter::MotionMeter(const model::Template &tmpl)
    : tmpl_(tmpl),
      exact_(tmpl.rig),
      sampled_(tmpl.rig, &tmpl.motion),
      morph_metres_(tmpl.rig.rest_weights.size()),
      exact_globals_(tmpl.rig.node_count()),
      sampled_globals_(tmpl.rig.node_count()),
      dofs_(tmpl.rig.dofs.size())
{
    accepted_.nodes.resize(tmpl.rig.node_count());
    now_.nodes.resize(tmpl.rig.node_count());
    begin();
    for (const model::PartSphere &sphere : tmpl.levels[0].part_spheres) {
        const model::PaletteEntry &entry = tmpl.rig.palette[sphere.entry];
        const double stretch = std::sqrt(square_sum(entry.inverse_bind) / 3) * (tmpl.similar_only ? 1.0 : 1.7321);
        balls_.push_back({entry.node, glm::dvec3(math::transform_point(entry.inverse_bind, sphere.bind.centre)),
                          double(sphere.bind.radius) * stretch});
    }
    // Nodes without vertices count by their origin, because something may be attached to it.
    std::vector<uint8_t> has_ball(tmpl.rig.node_count());
    for (const Ball &ball : balls_) has_ball[ball.node] = 1;
    for (uint32_t n = 0; n < tmpl.rig.node_count(); ++n)
        if (!has_ball[n]) balls_.push_back({n, glm::dvec3(0), 0});
    for (const model::MorphRange &range : tmpl.levels[0].morph_ranges)
        for (uint32_t i = range.first; i < range.first + range.count; ++i) {
            const float *p = tmpl.levels[0].morph_deltas[i].position;
            const double length = glm::length(glm::dvec3(p[0], p[1], p[2]));
            morph_metres_[range.weight] = std::max(morph_metres_[range.weight], length);
        }
}

double MotionMeter::rest_size() const
{
    std::vector<Affine> globals(tmpl_.rig.node_count());
    globals_of(tmpl_.rig, base::Span<const math::Trs>(tmpl_.rig.rest), globals);
    glm::dvec3 minimum(1e300), maximum(-1e300);
    for (const Ball &ball : balls_) {
        if (!(ball.radius > 0)) continue;
        const glm::dvec3 centre(math::transform_point(globals[ball.node], glm::vec3(ball.centre)));
        const double radius = ball.radius * std::sqrt(square_sum(globals[ball.node]) / 3);
        minimum = glm::min(minimum, centre - radius);
        maximum = glm::max(maximum, centre + radius);
    }
    return minimum.x <= maximum.x ? glm::length(maximum - minimum) / 2 : 0;
}

uint64_t MotionMeter::pose_transforms(uint32_t clip) const
{
    return 2ull * (tmpl_.rig.node_count() + tmpl_.rig.clips[clip].channel_count);
}

void MotionMeter::accept_reach_of(uint32_t clip)
{
    std::vector<NodeExtent> extents(accepted_.nodes.size());
    for (size_t n = 0; n < extents.size(); ++n) extents[n].scale = accepted_.nodes[n].scale;
    add_clip(tmpl_.rig, clip, extents);
    for (size_t n = 0; n < extents.size(); ++n) {
        accepted_.nodes[n].offset = std::max(accepted_.nodes[n].offset, extents[n].offset);
        accepted_.nodes[n].scale = std::max(accepted_.nodes[n].scale, extents[n].scale);
    }
}

MotionError MotionMeter::at(uint32_t clip, double time_s)
{
    count(pose_transforms(clip));
    for (pose::Workspace *w : {&exact_, &sampled_}) {
        pose::PoseJob job = w->job();
        job.clip = clip;
        job.time_s = time_s;
        job.dofs = dofs_.data();
        job.run_local_transforms();
    }
    globals_of(tmpl_.rig, exact_.locals(), exact_globals_);
    globals_of(tmpl_.rig, sampled_.locals(), sampled_globals_);
    double morphs = 0, stretch = 0;
    for (uint32_t w = 0; w < morph_metres_.size(); ++w)
        morphs += std::fabs(double(exact_.weights()[w]) - double(sampled_.weights()[w])) * morph_metres_[w];
    MotionError worst;
    for (const Ball &ball : balls_) {
        const Affine &exact = exact_globals_[ball.node];
        const Affine off = minus(sampled_globals_[ball.node], exact);
        const double spread = std::sqrt(square_sum(off)), size = std::sqrt(square_sum(exact));
        const double centre = glm::length(math::transform_point(off, glm::vec3(ball.centre)));
        worst.metres = std::max(worst.metres, centre + spread * ball.radius);
        stretch = std::max(stretch, size);
        // A rotation by a small angle changes the root of the sum of squares by sqrt(2) times the angle.
        if (size > 0) worst.radians = std::max(worst.radians, spread * std::sqrt(1.5) / size);
    }
    worst.metres += morphs * stretch;
    morphs_ = morphs;
    return worst;
}

MotionMeter::Local MotionMeter::difference(const math::Trs &exact, const math::Trs &sampled)
{
    Local out;
    out.shift = glm::length(glm::dvec3(exact.translation) - glm::dvec3(sampled.translation));
    double near = 0, far = 0;
    for (int k = 0; k < 4; ++k) {
        const double a = double(exact.rotation[k]), b = double(sampled.rotation[k]);
        near += (a - b) * (a - b), far += (a + b) * (a + b);
    }
    out.turn = 2.2215 * std::sqrt(std::min(near, far));  // see NodeMotionBound
    out.growth = largest(exact.scale - sampled.scale);
    out.offset = std::max(glm::length(glm::dvec3(exact.translation)), glm::length(glm::dvec3(sampled.translation)));
    out.scale = std::max(largest(exact.scale), largest(sampled.scale));
    return out;
}

void MotionMeter::Worst::merge(const Worst &other)
{
    morphs = std::max(morphs, other.morphs);
    for (size_t n = 0; n < nodes.size(); ++n) {
        Local &maximum = nodes[n];
        const Local &here = other.nodes[n];
        maximum.shift = std::max(maximum.shift, here.shift), maximum.turn = std::max(maximum.turn, here.turn);
        maximum.growth = std::max(maximum.growth, here.growth);
        maximum.offset = std::max(maximum.offset, here.offset), maximum.scale = std::max(maximum.scale, here.scale);
    }
}

void MotionMeter::take_locals()
{
    for (uint32_t n = 0; n < now_.nodes.size(); ++n)
        now_.nodes[n] = difference(exact_.locals()[n], sampled_.locals()[n]);
    now_.morphs = morphs_;
    measured_.merge(now_);
}

void MotionMeter::begin() { measured_.nodes.assign(accepted_.nodes.size(), Local()), measured_.morphs = 0; }

void MotionMeter::accept() { accepted_.merge(measured_); }

MotionError MotionMeter::measure(uint32_t clip, const std::vector<double> &times, const MotionError &maximum)
{
    MotionError worst;
    for (const uint32_t i : coarse_first(times.size())) {
        worst.merge(at(clip, times[i]));
        if (!worst.within(maximum)) return worst;
        take_locals();
    }
    return worst;
}

std::vector<uint8_t> MotionMeter::outliers(uint32_t clip, const std::vector<double> &times, const MotionError &maximum)
{
    const model::Rig &rig = tmpl_.rig;
    const model::Clip &of = rig.clips[clip];
    std::vector<uint8_t> out(of.channel_count);
    for (const double time : times) {
        at(clip, time);
        for (uint32_t i = 0; i < of.channel_count; ++i) {
            const model::Channel &channel = rig.channels[of.first_channel + i];
            if (channel.target == model::ChannelTarget::morph_weights) {
                const model::MorphSet &set = rig.morph_sets[channel.node];
                for (uint32_t w = set.first_weight; w < set.first_weight + set.target_count; ++w)
                    if (std::fabs(exact_.weights()[w] - sampled_.weights()[w]) * morph_metres_[w] > maximum.metres)
                        out[i] = 1;
                continue;
            }
            const Local off = difference(exact_.locals()[channel.node], sampled_.locals()[channel.node]);
            const double stretch = std::sqrt(
                std::max(square_sum(exact_globals_[channel.node]), square_sum(sampled_globals_[channel.node])));
            const bool outliers = channel.target == model::ChannelTarget::rotation ? off.turn > maximum.radians
                                  : channel.target == model::ChannelTarget::translation
                                      ? off.shift * stretch > maximum.metres
                                      : off.growth > maximum.radians;
            if (outliers) out[i] = 1;
        }
    }
    return out;
}

double MotionMeter::bound() const
{
    const model::Rig &rig = tmpl_.rig;
    const std::vector<double> shifts = max_shifts(rig);
    std::vector<double> reach(rig.node_count()), error(rig.node_count());  // in each node's own frame
    for (const Ball &ball : balls_)
        reach[ball.node] = std::max(reach[ball.node], glm::length(ball.centre) + ball.radius);
    double maximum = 0;
    for (uint32_t n = rig.node_count(); n-- > 0;) {
        const Local &own = accepted_.nodes[n];
        const double under = own.scale * reach[n] + shifts[n];
        const double off = own.shift + own.turn * under + own.growth * reach[n] + own.scale * error[n];
        if (rig.parents[n] == none) {
            maximum = std::max(maximum, off);
            continue;
        }
        reach[rig.parents[n]] = std::max(reach[rig.parents[n]], own.offset + under);
        error[rig.parents[n]] = std::max(error[rig.parents[n]], off);
    }
    double most_stretch = 1;
    std::vector<double> stretch(rig.node_count());  // of each node and all above it
    for (uint32_t n = 0; n < rig.node_count(); ++n) {
        const double above = rig.parents[n] == none ? 1 : stretch[rig.parents[n]];
        stretch[n] = above * (accepted_.nodes[n].scale > 0 ? accepted_.nodes[n].scale : 1);
        most_stretch = std::max(most_stretch, stretch[n]);
    }
    return maximum + accepted_.morphs * most_stretch;
}

}  // namespace claque::meshsplit
