#include "meshsplit/reach_fill.h"
#include "meshsplit/largest.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace claque::meshsplit
{

using model::none;

namespace
{

constexpr double nothing = -std::numeric_limits<double>::infinity();

Map placed(const math::Trs &trs)
{
    return {glm::dmat3(glm::mat3_cast(glm::dquat(trs.rotation))), glm::dvec3(trs.translation)};
}

Map scaled(const Map &map, const glm::vec3 &scale)
{
    Map out = map;
    for (int k = 0; k < 3; ++k) out.turn[k] *= double(scale[k]);
    return out;
}

glm::dvec3 moved(const Map &map, const glm::dvec3 &p) { return map.turn * p + map.move; }

}  // namespace

Grain::Grain(int splits, const model::Rig &rig) : directions(splits)
{
    for (const model::Dof &dof : rig.dofs) freedoms.emplace_back(directions, dof);
}

Fill::Fill(const model::Rig &rig)
    : rig_(rig), station_of_(rig.node_count(), none), to_station_(rig.node_count()), stretch_(rig.node_count(), 1)
{
    const std::vector<double> shifts = most_shifts(rig);
    for (uint32_t n = 0; n < rig.node_count(); ++n) {
        const uint32_t above = rig.parents[n] == none ? none : station_of_[rig.parents[n]];
        Station station;
        station.node = n, station.above = above, station.shift = shifts[n];
        for (uint32_t d = static_cast<uint32_t>(rig.dofs.size()); d-- > 0;)
            if (rig.dofs[d].kind != model::DofKind::morph && rig.dofs[d].node == n) station.dofs.push_back(d);
        station_of_[n] = station.dofs.empty() ? above : static_cast<uint32_t>(stations_.size());
        if (!station.dofs.empty()) stations_.push_back(station);
    }
    reach_.resize(stations_.size());
    busy_.resize(stations_.size());
    sets_.resize(stations_.size());
}

void Fill::take(const Locals &locals)
{
    uint32_t next = 0;
    for (uint32_t n = 0; n < rig_.node_count(); ++n) {
        const math::Trs &trs = locals.nodes[n];
        const uint32_t parent = rig_.parents[n];
        Map map = placed(trs);
        double stretch = largest(trs.scale);
        if (parent != none) map = after(to_station_[parent], map);
        if (next < stations_.size() && stations_[next].node == n) {
            stations_[next].lift = map;
            stations_[next].lift_stretch = parent == none ? 1 : stretch_[parent];
            map = Map();
            ++next;
        } else if (parent != none) {
            stretch *= stretch_[parent];
        }
        to_station_[n] = scaled(map, trs.scale);
        stretch_[n] = stretch;
    }
}

double Fill::ball(const std::vector<Body> &bodies, const float *weights, const glm::dvec3 &centre)
{
    double most = 0;
    std::fill(reach_.begin(), reach_.end(), nothing);
    for (const Body &body : bodies) {
        const uint32_t n = body.node(), s = station_of_[n];
        const glm::dvec3 at = moved(to_station_[n], body.centre());
        const double radius = stretch_[n] * body.radius(weights);
        if (s == none) most = std::max(most, glm::distance(at, centre) + radius);
        else reach_[s] = std::max(reach_[s], glm::length(at) + radius);
    }
    for (size_t s = stations_.size(); s-- > 0;) {
        const Station &station = stations_[s];
        if (reach_[s] == nothing) continue;
        reach_[s] += station.shift;
        const double radius = station.lift_stretch * reach_[s];
        if (station.above == none) most = std::max(most, glm::distance(station.lift.move, centre) + radius);
        else reach_[station.above] = std::max(reach_[station.above], glm::length(station.lift.move) + radius);
    }
    return most;
}

// What hangs on a station, to the frame in which its own place and turn are given.
void Fill::spread(const Grain &grain, const Station &station, double reach, Support &set)
{
    const double tight = grain.directions.most_weight() * *std::max_element(set.begin(), set.end()) + station.shift;
    for (const uint32_t d : station.dofs) grain.freedoms[d].spread(std::min(reach, tight), set, scratch_);
}

double Fill::support(const Grain &grain, const std::vector<Body> &bodies, const float *weights,
                     const std::vector<Support> &own, const Enough &enough, Support &out)
{
    double left_out = 0;
    const auto add = [&](const Support &set, const Map &map, uint32_t to) {
        Support &target = to == none ? out : sets_[to];
        if (to != none && !busy_[to]) target.assign(out.size(), nothing), busy_[to] = 1;
        take_in(grain.directions, set, map, target);
    };
    out.assign(grain.directions.count(), nothing);
    std::fill(busy_.begin(), busy_.end(), uint8_t(0));
    for (size_t b = 0; b < bodies.size(); ++b) {
        const uint32_t n = bodies[b].node();
        const double bound = ball_of(n, bodies[b].centre(), bodies[b].radius(weights), enough.centre);
        if (bound <= enough.distance) left_out = std::max(left_out, bound);
        else add(own[b], to_station_[n], station_of_[n]);
    }
    for (size_t s = stations_.size(); s-- > 0;) {
        if (!busy_[s]) continue;
        spread(grain, stations_[s], reach_[s], sets_[s]);
        add(sets_[s], stations_[s].lift, stations_[s].above);
    }
    return left_out;
}

// Of a ball in a node's frame: stations turn it anyhow about themselves.
double Fill::ball_of(uint32_t node, const glm::dvec3 &p, double radius, const glm::dvec3 &centre) const
{
    glm::dvec3 at = moved(to_station_[node], p);
    radius *= stretch_[node];
    for (uint32_t s = station_of_[node]; s != none; s = stations_[s].above) {
        radius = stations_[s].lift_stretch * (radius + glm::length(at) + stations_[s].shift);
        at = stations_[s].lift.move;
    }
    return glm::distance(at, centre) + radius;
}

double Fill::origin_ball(uint32_t node, const glm::dvec3 &centre) const
{
    return ball_of(node, glm::dvec3(0), 0, centre);
}

void Fill::origin_support(const Grain &grain, uint32_t node, Support &out)
{
    const auto at_point = [&](const glm::dvec3 &p) {
        for (size_t i = 0; i < out.size(); ++i) out[i] = glm::dot(grain.directions[i], p);
    };
    out.resize(grain.directions.count());
    at_point(to_station_[node].move);
    double reach = glm::length(to_station_[node].move);
    for (uint32_t s = station_of_[node]; s != none; s = stations_[s].above) {
        reach += stations_[s].shift;
        spread(grain, stations_[s], reach, out);
        Support &lifted = sets_[s];
        lifted.assign(out.size(), nothing);
        take_in(grain.directions, out, stations_[s].lift, lifted);
        out.swap(lifted);
        reach = glm::length(stations_[s].lift.move) + stations_[s].lift_stretch * reach;
    }
}

}  // namespace claque::meshsplit
