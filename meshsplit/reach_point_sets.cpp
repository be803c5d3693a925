#include "meshsplit/reach_point_sets.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace claque::meshsplit
{

std::vector<uint8_t> free_nodes(const model::Rig &rig)
{
    std::vector<uint8_t> out(rig.node_count());
    for (const model::Dof &dof : rig.dofs)
        if (dof.kind != model::DofKind::morph) out[dof.node] = 1;
    for (uint32_t n = 0; n < rig.node_count(); ++n)
        if (rig.parents[n] != model::none && out[rig.parents[n]]) out[n] = 1;
    return out;
}

void PointSet::add(glm::vec3 bind_position) { points_.emplace_back(math::transform_point(bind_, bind_position)); }

void PointSet::add_delta(uint32_t weight, const float *delta)
{
    const glm::dvec3 move(math::transform_vector(bind_, glm::vec3(delta[0], delta[1], delta[2])));
    deltas_.push_back({static_cast<uint32_t>(points_.size() - 1), weight, move});
    auto longest = std::find_if(longest_.begin(), longest_.end(), [&](const Longest &l) { return l.weight == weight; });
    if (longest == longest_.end()) longest = longest_.insert(longest, {weight});
    longest->length = std::max(longest->length, glm::length(move));
}

void PointSet::close(const Ranges &ranges)
{
    glm::dvec3 low = points_[0], high = low;
    for (const glm::dvec3 &p : points_) low = glm::min(low, p), high = glm::max(high, p);
    centre_ = 0.5 * (low + high);
    for (const glm::dvec3 &p : points_) radius_ = std::max(radius_, glm::distance(p, centre_));
    for (Longest &l : longest_) l.freely = std::max(std::fabs(ranges[l.weight].low), std::fabs(ranges[l.weight].high));
}

double PointSet::morphed(const float *weights) const
{
    double sum = 0;
    for (const Longest &l : longest_) sum += (std::fabs(double(weights[l.weight])) + l.freely) * l.length;
    return sum;
}

MotionBound PointSet::motion_bound(const float *weights_from, const float *weights_to, const PoseSegment &segment) const
{
    MotionBound out;
    for (const Longest &l : longest_) {
        out.speed += segment.weights[l.weight] * l.length;
        out.acceleration += segment.weight_accelerations[l.weight] * l.length;
    }
    out.reach =
        glm::length(centre_) + radius_ + std::max(morphed(weights_from), morphed(weights_to)) + out.chord_deviation();
    return out;
}

void PointSet::support(const Directions &directions, const Ranges &ranges, const float *weights, Support &out) const
{
    out.assign(directions.count(), -std::numeric_limits<double>::infinity());
    std::vector<glm::dvec3> units(directions.count());
    for (size_t i = 0; i < units.size(); ++i) units[i] = directions[i];
    std::vector<double> along(units.size());
    const Delta *delta = deltas_.data(), *last = delta + deltas_.size();
    for (size_t p = 0; p < points_.size(); ++p) {
        glm::dvec3 at = points_[p];
        const Delta *first = delta;
        for (; delta < last && delta->point == p; ++delta) at += double(weights[delta->weight]) * delta->move;
        for (size_t i = 0; i < units.size(); ++i) along[i] = units[i].x * at.x + units[i].y * at.y + units[i].z * at.z;
        for (const Delta *d = first; d < delta; ++d) {
            const Range range = ranges[d->weight];
            if (range.low == 0 && range.high == 0) continue;
            for (size_t i = 0; i < units.size(); ++i) {
                const double step = glm::dot(units[i], d->move);
                along[i] += std::max(range.low * step, range.high * step);
            }
        }
        for (size_t i = 0; i < units.size(); ++i) out[i] = along[i] > out[i] ? along[i] : out[i];
    }
}

FreePointSets::FreePointSets(const model::Template &tmpl)
{
    const model::Rig &rig = tmpl.rig;
    find_ranges(rig);
    std::vector<PointSet> all;
    for (const model::PaletteEntry &entry : rig.palette) all.emplace_back(entry.node, entry);
    for (const model::Level &level : tmpl.levels) {
        find_moved(level, rig);
        std::vector<std::vector<const model::MorphDelta *>> deltas(level.morph_deltas.empty() ? 0 : level.source_count);
        std::vector<uint32_t> weight_of(level.morph_deltas.size());
        for (const model::MorphRange &range : level.morph_ranges)
            for (uint32_t i = range.first; i < range.first + range.count; ++i) {
                weight_of[i] = range.weight;
                deltas[level.morph_deltas[i].vertex].push_back(&level.morph_deltas[i]);
            }
        for (const model::InfluenceRun &run : level.runs)
            for (uint32_t k = 0; k < run.count * run.influences; ++k) {
                const uint32_t v = run.first + k / run.influences;
                if (!moved.back()[v]) continue;
                PointSet &point_set = all[level.joints[run.first_influence + k]];
                const float *p = level.positions.data() + 3 * size_t(v);
                point_set.add(glm::vec3(p[0], p[1], p[2]));
                if (deltas.empty()) continue;
                for (const model::MorphDelta *d : deltas[v])
                    point_set.add_delta(weight_of[size_t(d - level.morph_deltas.data())], d->position);
            }
    }
    for (PointSet &point_set : all) {
        if (point_set.empty()) continue;
        point_set.close(ranges);
        point_sets.push_back(std::move(point_set));
    }
}

void FreePointSets::find_ranges(const model::Rig &rig)
{
    ranges.resize(rig.rest_weights.size());
    for (const model::Dof &dof : rig.dofs) {
        if (dof.kind != model::DofKind::morph) continue;
        PointSet::Range &range = ranges[rig.morph_sets[dof.node].first_weight + dof.morph_target];
        range.low += double(dof.min), range.high += double(dof.max);
    }
}

void FreePointSets::find_moved(const model::Level &level, const model::Rig &rig)
{
    const std::vector<uint8_t> free = free_nodes(rig);
    std::vector<uint8_t> &marks = moved.emplace_back(level.source_count);
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t k = 0; k < run.count * run.influences; ++k)
            if (free[rig.palette[level.joints[run.first_influence + k]].node])
                marks[run.first + k / run.influences] = 1;
    for (const model::MorphRange &range : level.morph_ranges)
        if (ranges[range.weight].low != 0 || ranges[range.weight].high != 0)
            for (uint32_t i = range.first; i < range.first + range.count; ++i) marks[level.morph_deltas[i].vertex] = 1;
}

}  // namespace claque::meshsplit
