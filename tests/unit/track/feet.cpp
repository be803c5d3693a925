#include "tests/unit/track/feet.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace claque::test
{

namespace
{

constexpr double contact_m = 0.012;

std::vector<uint32_t> vertices_of(const model::Template &tmpl, const model::Array<uint32_t> &nodes)
{
    std::vector<bool> inside(tmpl.rig.node_count(), false);
    for (const uint32_t node : nodes) inside[node] = true;
    const model::Level &level = tmpl.levels[0];
    std::vector<uint32_t> out;
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t i = 0; i < run.count; ++i) {
            float weight = 0;
            for (uint32_t k = 0; k < run.influences; ++k) {
                const uint32_t at = run.first_influence + i * run.influences + k;
                if (inside[tmpl.rig.palette[level.joints[at]].node]) weight += level.weights[at];
            }
            if (weight > 0.6f) out.push_back(run.first + i);
        }
    return out;
}

glm::dvec3 skinned(const model::Template &tmpl, uint32_t vertex, const math::Affine *palette)
{
    const model::Level &level = tmpl.levels[0];
    const float *p = level.positions.data() + 3 * size_t(vertex);
    glm::dvec3 sum(0);
    for (const model::InfluenceRun &run : level.runs) {
        if (vertex < run.first || vertex >= run.first + run.count) continue;
        for (uint32_t k = 0; k < run.influences; ++k) {
            const uint32_t at = run.first_influence + (vertex - run.first) * run.influences + k;
            const glm::dvec3 moved(math::transform_point(palette[level.joints[at]], glm::vec3(p[0], p[1], p[2])));
            sum += moved * double(level.weights[at]);
        }
    }
    return sum;
}

glm::dvec3 world_of(const track::Track &track, const track::State &state, const glm::dvec3 &p)
{
    const double c = std::cos(state.heading_rad), s = std::sin(state.heading_rad);
    const glm::dvec3 m = p * track.scale;
    return state.position * track.metres_per_unit + glm::dvec3(m.x * c + m.z * s, m.y, -m.x * s + m.z * c);
}

}  // namespace

SolesInWorld soles_at(Soles &soles, const track::Track &track, int foot, double time_s, bool held)
{
    const track::State state = track::state_at(track, time_s);
    SolesInWorld step;
    step.ground = state.position.y * track.metres_per_unit;
    for (const glm::dvec3 &p : soles.at(track, time_s, held).points[foot])
        step.points.push_back(world_of(track, state, p));
    return step;
}

Soles::Soles(const track::Locomotion &locomotion)
    : locomotion_(&locomotion), work_(locomotion.tmpl->rig, &locomotion.tmpl->motion)
{
    for (int f = 0; f < 2; ++f) vertices_[f] = vertices_of(*locomotion.tmpl, locomotion.legs[f].foot_nodes);
}

const Soles::Posed &Soles::at(const track::Track &track, double time_s, bool held)
{
    const track::State state = track::state_at(track, time_s);
    pose::Layer layers[3];
    pose::PoseJob job = work_.job();
    job.layers = {layers,
                  track::layers_of(*locomotion_, state.gait, state.turn, state.phase, state.idle, time_s, layers)};
    const pose::FootTarget feet[] = {track::foot_at(track, state, 0, time_s), track::foot_at(track, state, 1, time_s)};
    if (held) job.feet = {feet, 2};
    job.run();
    for (int f = 0; f < 2; ++f) {
        posed_.points[f].clear();
        for (const uint32_t v : vertices_[f]) posed_.points[f].push_back(skinned(tmpl(), v, job.palette.data));
    }
    return posed_;
}

double FootDrift::mean() const
{
    double sum = 0;
    for (const double d : each) sum += d;
    return each.empty() ? 0 : sum / double(each.size());
}

double FootDrift::at_share(double share) const
{
    if (each.empty()) return 0;
    std::vector<double> sorted = each;
    std::sort(sorted.begin(), sorted.end());
    return sorted[std::min(sorted.size() - 1, static_cast<size_t>(share * double(sorted.size())))];
}

FootDrift drift_of(Soles &soles, const track::Track &track, double step_s, bool held)
{
    FootDrift out;
    for (int f = 0; f < 2; ++f)
        for (const track::Plant &plant : track.plants[f]) {
            glm::dvec3 sum(0);
            double worst = 0;
            SolesInWorld before;
            for (double t = double(plant.begin_s); t <= double(plant.end_s); t += step_s) {
                SolesInWorld now = soles_at(soles, track, f, track.start_s + t, held);
                glm::dvec3 moved(0);
                int touching = 0;
                for (size_t i = 0; i < before.points.size(); ++i) {
                    const bool low = before.points[i].y - before.ground < contact_m * track.scale &&
                                     now.points[i].y - now.ground < contact_m * track.scale;
                    if (low) moved += now.points[i] - before.points[i], ++touching;
                }
                if (touching > 0) sum += moved / double(touching);
                worst = std::max(worst, std::sqrt(sum.x * sum.x + sum.z * sum.z));
                before = std::move(now);
            }
            out.each.push_back(worst);
        }
    return out;
}

void Swings::add(const Swings &other)
{
    seconds += other.seconds, moving_s += other.moving_s, flying_s += other.flying_s;
    deepest_m = std::max(deepest_m, other.deepest_m);
}

Swings swings_of(Soles &soles, const track::Track &track, double step_s)
{
    Swings out;
    glm::dvec3 before = track::state_at(track, track.start_s).position;
    for (double t = step_s; t <= track.length_s; t += step_s) {
        const double at = track.start_s + t;
        const glm::dvec3 here = track::state_at(track, at).position;
        const bool moves = glm::length(here - before) * track.metres_per_unit > 0.3 * step_s;
        before = here;
        int standing = 0;
        for (int f = 0; f < 2; ++f) {
            const bool stands = std::any_of(track.plants[f].begin(), track.plants[f].end(), [&](const track::Plant &p) {
                return double(p.begin_s) <= t && t <= double(p.end_s);
            });
            standing += stands;
            if (stands) continue;
            const SolesInWorld now = soles_at(soles, track, f, at, true);
            for (const glm::dvec3 &p : now.points) out.deepest_m = std::max(out.deepest_m, now.ground - p.y);
        }
        out.seconds += step_s;
        if (moves) out.moving_s += step_s;
        if (moves && standing == 0) out.flying_s += step_s;
    }
    return out;
}

double lift_of(Soles &soles, const track::Track &track, double step_s)
{
    double highest = 0;
    for (int f = 0; f < 2; ++f)
        for (const track::Plant &plant : track.plants[f])
            for (double t = double(plant.begin_s) + 0.1; t <= double(plant.end_s) - 0.1; t += step_s) {
                const SolesInWorld now = soles_at(soles, track, f, track.start_s + t, true);
                double low = 1e9;
                for (const glm::dvec3 &p : now.points) low = std::min(low, p.y - now.ground);
                highest = std::max(highest, std::fabs(low));
            }
    return highest;
}

}  // namespace claque::test
