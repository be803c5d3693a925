#include "lib/stage/walk/movement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace claque::walk
{

namespace
{

constexpr double kept_pieces_s =
    1.2;  // of pieces behind the time decided: places are asked for up to a second before it
constexpr double moment_s = 1e-9;
constexpr double still_s = 0.6;  // of an agent that has settled, before its actor leaves its track

}  // namespace

Walking::Walking(clq_navigation &navigation, const clq_walkers_def &def, Locomotions locomotions)
    : navigation_(navigation),
      def_(def),
      locomotions_(std::move(locomotions)),
      walkers_(std::make_unique<Walkers>(navigation, def)),
      agent_of_(def.max_count)
{
}

Walking::~Walking() = default;

Walking::Person &Walking::person(stage::AgentIndex agent)
{
    if (agent >= people_.size() || people_[agent].is == Person::Is::away)
        fail(CLQ_ARGUMENT, "agent %u does not walk", agent);
    return people_[agent];
}

void Walking::add(stage::AgentIndex agent, const stage::Walker &walker, double at_s)
{
    double place[3];
    bool found = false;
    if (clq_navigation_find_nearest(&navigation_, walker.position, double(find_reach_m) / navigation_.metres_per_unit,
                                    place, &found) != CLQ_OK)
        fail(CLQ_ARGUMENT, "an agent that walks: %s", clq_last_error());
    if (!found)
        fail(CLQ_ARGUMENT, "there is no ground within %g m of %g, %g, %g for an agent that walks", double(find_reach_m),
             walker.position[0], walker.position[1], walker.position[2]);
    if (agent >= people_.size()) people_.resize(size_t(agent) + 1);
    Person &one = people_[agent];
    one = Person();
    one.walker = walker, one.at_s = at_s;
    one.is = Person::Is::coming;
    try {
        if (at_s <= walkers_->time_s() + moment_s) let_in(agent);
    } catch (...) {
        one = Person();
        throw;
    }
}

// An agent that goes on from where it has settled: it is led from there to the ground.
void Walking::unsettle(stage::AgentIndex agent, double at_s)
{
    Person &one = people_[agent];
    one.at_s = std::isfinite(one.leaves_s) ? one.leaves_s : at_s;
    one.settled_s = INFINITY;
    one.is = Person::Is::coming;
    one.rises = true;
    if (one.at_s <= walkers_->time_s() + moment_s) let_in(agent);
}

void Walking::let_in(stage::AgentIndex agent)
{
    Person &one = people_[agent];
    clq_walker_def def = clq_walker_def_init();
    def.locomotion = one.walker.locomotion;
    std::copy(one.walker.position, one.walker.position + 3, def.position);
    def.heading_rad = static_cast<float>(one.walker.heading_rad);
    def.radius_m = std::clamp(one.walker.radius_m, 0.05f, def_.max_radius_m);
    def.scale = one.walker.scale, def.seed = one.walker.seed;
    one.id = walkers_->add(def);
    one.is = Person::Is::here;
    agent_of_[one.id.index1 - 1] = agent;
    try {
        if (one.rises) walkers_->rise_from(one.id, one.walker.position);
        walkers_->stand_since(one.id, one.at_s);
        take_pieces();
    } catch (...) {
        walkers_->remove(one.id);
        throw;
    }
    if (one.goes) send(agent);
}

void Walking::remove(stage::AgentIndex agent, double)
{
    Person &one = person(agent);
    if (one.is == Person::Is::here) walkers_->remove(one.id);
    forget_answer(agent);
    one = Person();
}

void Walking::go(stage::AgentIndex agent, const stage::Goal &goal, double at_s)
{
    Person &one = person(agent);
    arrivals_.reserve(arrivals_.size() + 1);
    forget_answer(agent);
    one.goal = goal, one.goes = true;
    one.settled_s = INFINITY;
    if (one.is == Person::Is::here) send(agent);
    if (one.is == Person::Is::settled) unsettle(agent, at_s);
}

void Walking::send(stage::AgentIndex agent)
{
    Person &one = people_[agent];
    try {
        const float near_m = std::clamp(one.goal.near_m, 0.05f, 100.0f);
        walkers_->go(one.id, one.goal.position, near_m, std::clamp(one.goal.speed_m_s, 0.05f, 8.0f));
        walkers_->rest_at(one.id, static_cast<float>(one.goal.heading_rad));
    } catch (const stage::Error &) {  // there is no ground at the goal
        walkers_->stop(one.id);
        answer(agent, false);
    }
}

void Walking::stop(stage::AgentIndex agent, double)
{
    Person &one = person(agent);
    forget_answer(agent);
    one.goes = false;
    one.settled_s = INFINITY;
    if (one.is == Person::Is::here) walkers_->stop(one.id);
}

void Walking::answer(stage::AgentIndex agent, bool reached)
{
    arrivals_.push_back({agent, people_[agent].goal.request, walkers_->time_s(), reached});
    people_[agent].goes = false;
    if (reached && people_[agent].goal.settles) people_[agent].settled_s = walkers_->time_s();
}

// An agent that has been still for a while leaves the walkers where a piece ends; its actor then leaves its track.
void Walking::settle(stage::AgentIndex agent)
{
    Person &one = people_[agent];
    const double now_s = walkers_->time_s();
    const bool published = !one.pieces.empty() && one.pieces.back().end_s > now_s - moment_s;
    if (!published || now_s < one.settled_s + still_s) return;
    walkers_->remove(one.id);
    std::copy(one.goal.position, one.goal.position + 3, one.walker.position);
    one.walker.heading_rad = one.goal.heading_rad;
    one.is = Person::Is::settled;
    one.leaves_s = now_s;
}

void Walking::forget_answer(stage::AgentIndex agent)
{
    const auto of_it = [agent](const stage::Arrival &arrival) { return arrival.agent == agent; };
    arrivals_.erase(std::remove_if(arrivals_.begin(), arrivals_.end(), of_it), arrivals_.end());
}

void Walking::take_pieces()
{
    for (const clq_walker_piece &piece : walkers_->pieces()) {
        Person &one = people_[agent_of_[piece.walker.index1 - 1]];
        if (one.id.generation != piece.walker.generation) continue;  // of one that left in this tick
        std::vector<Shown> &pieces = one.pieces;
        if (!pieces.empty() && pieces.back().end_s >= piece.end_s) continue;  // it was taken before
        pieces.emplace_back();
        clq_track_hold(piece.track);
        pieces.back().track.reset(piece.track);
        pieces.back().begin_s = piece.begin_s, pieces.back().end_s = piece.end_s;
        pieces.back().rises = std::exchange(one.rises, false);
    }
}

void Walking::look_for_answers()
{
    for (stage::AgentIndex i = 0; i < people_.size(); ++i) {
        Person &one = people_[i];
        if (one.is == Person::Is::here && std::isfinite(one.settled_s)) settle(i);
        if (one.is != Person::Is::here || !one.goes) continue;
        clq_walker_info info = clq_walker_info_init();
        walkers_->get(one.id, info);
        if (info.state == CLQ_WALKER_ARRIVED && one.goal.settles && !walkers_->has_settled(one.id))
            walkers_->settle(one.id, one.goal.position);
        else if (info.state == CLQ_WALKER_ARRIVED) answer(i, true);
        if (info.state == CLQ_WALKER_BLOCKED) walkers_->stop(one.id), answer(i, false);
    }
}

void Walking::prune(double until_s)
{
    for (Person &one : people_)
        while (!one.pieces.empty() && one.pieces.front().given && one.pieces.front().end_s < until_s - kept_pieces_s)
            one.pieces.erase(one.pieces.begin());
}

void Walking::advance(double until_s, stage::Moved &out)
{
    const double horizon_s = until_s + def_.piece_ticks * def_.tick_s;
    for (;;) {
        take_pieces();  // also those of a call that ran out of memory
        look_for_answers();
        for (stage::AgentIndex i = 0; i < people_.size(); ++i)
            if (people_[i].is == Person::Is::coming && people_[i].at_s <= walkers_->time_s() + moment_s) let_in(i);
        if (walkers_->time_s() >= horizon_s - moment_s) break;
        walkers_->step();
    }
    size_t pieces = 0;
    for (const Person &one : people_) pieces += one.pieces.size() + 1;
    out.pieces.reserve(out.pieces.size() + pieces);
    out.arrivals.reserve(out.arrivals.size() + arrivals_.size());
    // Nothing below throws.
    for (stage::AgentIndex i = 0; i < people_.size(); ++i) {
        Person &one = people_[i];
        // Its last piece was given before, since it begins earlier.
        const bool leaves = one.leaves_s <= until_s + moment_s;
        if (leaves) out.pieces.push_back({i, std::exchange(one.leaves_s, INFINITY), 0, nullptr, false});
        for (Shown &piece : one.pieces) {
            if (piece.given || piece.begin_s > until_s + moment_s) continue;
            clq_track_hold(piece.track.get());
            out.pieces.push_back({i, piece.begin_s, 0, piece.track.get(), piece.rises});
            piece.given = true;
        }
    }
    const auto later = [&](const stage::Arrival &arrival) { return arrival.time_s > until_s + moment_s; };
    const auto due = std::stable_partition(arrivals_.begin(), arrivals_.end(), later);
    out.arrivals.insert(out.arrivals.end(), due, arrivals_.end());
    arrivals_.erase(due, arrivals_.end());
    prune(until_s);
}

stage::Place Walking::place(stage::AgentIndex agent, double time_s) const
{
    stage::Place out;
    if (agent >= people_.size()) return out;
    const Person &one = people_[agent];
    std::copy(one.walker.position, one.walker.position + 3, out.position);
    out.heading_rad = one.walker.heading_rad;
    const Shown *piece = nullptr;
    for (const Shown &each : one.pieces)
        if (!piece || each.begin_s <= time_s) piece = &each;
    clq_track_state state;
    if (!piece || clq_track_evaluate(piece->track.get(), time_s, &state) != CLQ_OK) return out;
    std::copy(state.position, state.position + 3, out.position);
    out.heading_rad = state.heading_rad, out.speed_m_s = state.speed_m_s;
    return out;
}

}  // namespace claque::walk

extern "C" clq_status clq_stage_set_navigation(clq_stage *stage, clq_navigation *navigation, const clq_walkers_def *def,
                                               const clq_locomotion *const *locomotions, uint32_t locomotion_count)
{
    using namespace claque;
    return walk::boundary("clq_stage_set_navigation", [&] {
        walk::require(stage && navigation, "stage or navigation is NULL");
        walk::require(locomotions || locomotion_count == 0, "locomotions is NULL");
        clq_walkers_def wanted = stage::read_def(def, clq_walkers_def_init, "clq_walkers_def_init");
        wanted.start_s = clq_stage_get_decided_s(stage);
        std::vector<const clq_locomotion *> all(locomotions, locomotions + locomotion_count);
        clq_stage_set_movement(stage, std::make_unique<walk::Walking>(*navigation, wanted, std::move(all)));
    });
}
