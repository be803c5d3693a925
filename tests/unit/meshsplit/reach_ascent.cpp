#include "reach_ascent.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/base/hash.h"
#include "lib/math/trig.h"
#include "lib/pose/pose.h"

namespace claque::test
{

using model::DofKind;

namespace
{

double ascent_random(uint64_t start, uint64_t i)
{
    return double(base::unit(base::hash(start, i, base::Purpose::pick)));
}

glm::dmat3 turn_about(const glm::dvec3 &axis, double angle)
{
    const double s = std::sin(angle), c = std::cos(angle);
    glm::dmat3 out;
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 e(0);
        e[k] = 1;
        out[k] = e * c + glm::cross(axis, e) * s + axis * (axis[k] * (1 - c));
    }
    return out;
}

}  // namespace

std::vector<ClipTime> clip_times(const model::Rig &rig, double per_s)
{
    std::vector<ClipTime> out(1);
    for (uint32_t c = 0; c < rig.clips.size(); ++c) {
        const double start = double(rig.clips[c].start_s), length = double(rig.clips[c].duration_s);
        for (int i = 0; i / per_s < length; ++i) out.push_back({c, start + i / per_s});
        out.push_back({c, start + length});
    }
    return out;
}

Reacher::Reacher(const model::Template &tmpl) : tmpl_(tmpl)
{
    for (const model::Dof &dof : tmpl.rig.dofs) dofs.push_back(double(dof.rest));
    for (const model::Level &level : tmpl.levels) add_level(level);
    pose({});
}

void Reacher::add_level(const model::Level &level)
{
    const size_t first = vertices_.size();
    vertices_.resize(first + level.source_count);
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t v = 0; v < run.count; ++v) {
            Vertex &vertex = vertices_[first + run.first + v];
            for (int k = 0; k < 3; ++k) vertex.bind[k] = double(level.positions[3 * (run.first + v) + uint32_t(k)]);
            for (uint32_t i = 0; i < run.influences; ++i) {
                const uint32_t at = run.first_influence + v * run.influences + i;
                vertex.influences.emplace_back(level.joints[at], double(level.weights[at]));
            }
        }
    for (const model::MorphRange &range : level.morph_ranges)
        for (uint32_t i = range.first; i < range.first + range.count; ++i) {
            const model::MorphDelta &delta = level.morph_deltas[i];
            const glm::dvec3 move(delta.position[0], delta.position[1], delta.position[2]);
            vertices_[first + delta.vertex].morphs.emplace_back(range.weight, move);
        }
}

void Reacher::pose(const ClipTime &at)
{
    const model::Rig &rig = tmpl_.rig;
    const std::vector<float> none(rig.dofs.size());
    std::vector<math::Columns> globals(rig.node_count());
    std::vector<math::Affine> palette(rig.palette.size() + 1);
    locals_.resize(rig.node_count());
    weights_.resize(rig.rest_weights.size());
    pose::PoseJob job;
    job.rig = &rig, job.clip = at.clip, job.time_s = at.time_s, job.dofs = none.data();
    job.locals = base::Span<math::Trs>(locals_);
    job.globals = base::Span<math::Columns>(globals);
    job.palette = base::Span<math::Affine>(palette);
    job.weights = base::Span<float>(weights_);
    job.run();
}

void Reacher::shuffle(uint64_t start)
{
    for (size_t d = 0; d < dofs.size(); ++d) {
        const model::Dof &dof = tmpl_.rig.dofs[d];
        const double f = std::clamp(1.5 * ascent_random(start, d) - 0.25, 0.0, 1.0);
        dofs[d] = double(dof.min) + f * (double(dof.max) - double(dof.min));
    }
}

Reacher::Frame Reacher::local(uint32_t node) const
{
    const math::Trs &trs = locals_[node];
    Frame out{glm::mat3_cast(glm::dquat(trs.rotation)), glm::dvec3(trs.translation)};
    for (size_t d = 0; d < dofs.size(); ++d) {
        const model::Dof &dof = tmpl_.rig.dofs[d];
        if (dof.node != node || dof.kind == DofKind::morph) continue;
        if (dof.kind == DofKind::translation) out.move += out.turn * (glm::dvec3(dof.axis) * dofs[d]);
        else out.turn = out.turn * turn_about(glm::dvec3(dof.axis), dofs[d]);
    }
    for (int k = 0; k < 3; ++k) out.turn[k] *= double(trs.scale[k]);
    return out;
}

Reacher::Frame Reacher::frame(uint32_t node) const
{
    Frame out = local(node);
    for (uint32_t n = tmpl_.rig.parents[node]; n != model::none; n = tmpl_.rig.parents[n]) {
        const Frame above = local(n);
        out = {above.turn * out.turn, above.turn * out.move + above.move};
    }
    return out;
}

glm::dvec3 Reacher::shaped(const Vertex &vertex) const
{
    glm::dvec3 out = vertex.bind;
    for (const auto &[weight, move] : vertex.morphs) {
        double sum = double(weights_[weight]);
        for (size_t d = 0; d < dofs.size(); ++d) {
            const model::Dof &dof = tmpl_.rig.dofs[d];
            if (dof.kind != DofKind::morph) continue;
            if (tmpl_.rig.morph_sets[dof.node].first_weight + dof.morph_target == weight) sum += dofs[d];
        }
        out += sum * move;
    }
    return out;
}

double Reacher::farthest(const glm::dvec3 &centre)
{
    std::vector<Frame> palette;
    for (const model::PaletteEntry &entry : tmpl_.rig.palette) palette.push_back(frame(entry.node));
    double most = -1;
    for (size_t v = 0; v < vertices_.size(); ++v) {
        const glm::dvec3 bind = shaped(vertices_[v]);
        glm::dvec3 at(0);
        for (const auto &[entry, weight] : vertices_[v].influences) {
            const glm::dvec3 p(math::transform_point(tmpl_.rig.palette[entry].inverse_bind, glm::vec3(bind)));
            at += weight * (palette[entry].turn * p + palette[entry].move);
        }
        const double d = glm::distance(at, centre);
        if (d > most) most = d, farthest_ = v;
    }
    return most;
}

double Reacher::distance(const glm::dvec3 &centre) const
{
    const Vertex &vertex = vertices_[farthest_];
    const glm::dvec3 bind = shaped(vertex);
    glm::dvec3 at(0);
    for (const auto &[entry, weight] : vertex.influences) {
        const model::PaletteEntry &joint = tmpl_.rig.palette[entry];
        const Frame f = frame(joint.node);
        at += weight * (f.turn * glm::dvec3(math::transform_point(joint.inverse_bind, glm::vec3(bind))) + f.move);
    }
    return glm::distance(at, centre);
}

// With everything else fixed a vertex is P + Q cos + R sin of one angle, so its squared distance is a trigonometric
// polynomial of second degree (of first if nothing is blended or scaled unevenly): five samples determine it. Its
// maximum within the range is found in 64 steps, then by bisection.
double Reacher::best_turn(size_t d, const glm::dvec3 &centre)
{
    const double first = double(tmpl_.rig.dofs[d].min), last = double(tmpl_.rig.dofs[d].max);
    double mean = 0, c1 = 0, s1 = 0, c2 = 0, s2 = 0;
    for (int i = 0; i < 5; ++i) {
        const double angle = 2 * math::pi * i / 5;
        dofs[d] = angle;
        const double v = distance(centre) * distance(centre);
        mean += 0.2 * v;
        c1 += 0.4 * v * std::cos(angle), s1 += 0.4 * v * std::sin(angle);
        c2 += 0.4 * v * std::cos(2 * angle), s2 += 0.4 * v * std::sin(2 * angle);
    }
    const auto f = [&](double a) {
        return mean + c1 * std::cos(a) + s1 * std::sin(a) + c2 * std::cos(2 * a) + s2 * std::sin(2 * a);
    };
    double best = first;
    for (int i = 1; i <= 64; ++i) {
        const double angle = first + (last - first) * i / 64;
        if (f(angle) > f(best)) best = angle;
    }
    for (double step = (last - first) / 64; step > 1e-6; step /= 2)
        for (const double angle : {best - step, best + step})
            if (angle >= first && angle <= last && f(angle) > f(best)) best = angle;
    return best;
}

double Reacher::climb(const glm::dvec3 &centre)
{
    double most = farthest(centre);
    for (int round = 0; round < 20; ++round) {
        double before = most;
        for (size_t d = 0; d < dofs.size(); ++d) {
            const model::Dof &dof = tmpl_.rig.dofs[d];
            const double was = dofs[d];
            // Distance is convex along straight lines: the maximum is at an end.
            dofs[d] = double(dof.min);
            const double at_first = distance(centre);
            dofs[d] = double(dof.max);
            const double at_last = distance(centre);
            double value = at_first > at_last ? double(dof.min) : double(dof.max);
            if (dof.kind == DofKind::rotation) value = best_turn(d, centre);
            dofs[d] = value;
            if (distance(centre) > most) most = distance(centre);
            else dofs[d] = was;
        }
        most = farthest(centre);
        if (most < before * (1 + 1e-7)) break;
    }
    return most;
}

double found_reach(const model::Template &tmpl, const glm::dvec3 &centre)
{
    Reacher reacher(tmpl);
    const std::vector<ClipTime> times = clip_times(tmpl.rig, tmpl.rig.clips.size() > 3 ? 30 : 2000);
    std::vector<std::pair<double, size_t>> ranking;
    for (size_t i = 0; i < times.size(); ++i) {
        reacher.pose(times[i]);
        ranking.emplace_back(-reacher.farthest(centre), i);
    }
    std::sort(ranking.begin(), ranking.end());
    double most = -ranking[0].first;
    for (uint64_t start = 0; start < 100; ++start) {
        const bool ranked = start % 2 && start / 2 < ranking.size();
        const size_t any = size_t(ascent_random(start, 1000) * double(times.size()));
        reacher.pose(times[ranked ? ranking[start / 2].second : any]);
        reacher.shuffle(start);
        most = std::max(most, reacher.climb(centre));
    }
    return most;
}

}  // namespace claque::test
