#include "samples/stage/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "samples/scenes/angles.h"
#include "samples/stage/door_leaves.h"

namespace staged
{

using namespace scenes;

namespace
{

constexpr uint32_t tries_at_once = 400, tries_in_a_tick = 8;

[[noreturn]] void refuse_crowd(const ScenarioAgents &of, size_t here)
{
    char text[200];
    std::snprintf(text, sizeof text,
                  "there is no room for %u people %g m apart where they appear; %zu people are there", of.count,
                  of.apart_m, here);
    throw Failure(of.at + ": " + text);
}

double clock_s(void *)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Not a sleep: it takes a core as a long decision does.
void work_for(double seconds)
{
    for (const double end_s = clock_s(nullptr) + seconds; clock_s(nullptr) < end_s;) continue;
}

}  // namespace

double heard_after_s(const Staging &stage) { return std::max(stage.lead_s, 2 * stage.tick_s) + stage.tick_s / 2; }

Run::Run(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario, const Setting &setting,
         const RunOptions &options)
    : described_(*scenario.stage),
      setting_(setting),
      seed_(crowd_options.seed),
      options_(options),
      people_(library, crowd_options, scenario, described_.ground.has_value()),
      flyers_(library, people_.crowd(), described_),
      path_(scenario.path),
      navigation_(make_navigation(setting, described_)),
      services_(make_services(scenario)),
      arrivals_(arrivals_of(described_, seed_)),
      agents_(people_.all().size())
{
    add_doors(people_.crowd(), described_.doors);
    if (path_) sights_.emplace(people_, heard_after_s(described_));
    make_stage(library, options);
    add_actions();
    machines_ = add_machines(stage_.get(), described_, people_);
    if (described_.timetable.empty()) return;
    clq_stage_text source = clq_stage_text_init();
    source.path = described_.timetable.c_str();
    check(clq_stage_add_timetable(stage_.get(), &source, 0), described_.timetable_at);
}

Run::~Run() = default;

std::vector<clq_template *> Run::templates() const
{
    std::vector<clq_template *> all = people_.templates();
    for (clq_template *flying : flyers_.templates())
        if (std::find(all.begin(), all.end(), flying) == all.end()) all.push_back(flying);
    return all;
}

void Run::make_stage(Library &library, const RunOptions &options)
{
    clq_stage_def def = clq_stage_def_init();
    def.mode = options.live ? CLQ_STAGE_LIVE : CLQ_STAGE_REPRODUCIBLE;
    def.seed = seed_, def.start_s = begin_s, def.tick_s = described_.tick_s;
    def.budget = described_.budget, def.budget_us = static_cast<float>(described_.budget_us);
    if (options.live) def.now_s = clock_s;
    clq_stage *made = nullptr;
    check(clq_stage_create(library.context(), &def, &made), described_.at);
    stage_.reset(made);
    if (!navigation_) return;
    clq_walkers_def walking = clq_walkers_def_init();
    walking.max_count = static_cast<uint32_t>(std::max<size_t>(1, people_.all().size()));
    walking.tick_s = described_.tick_s;
    walking.smooth_s = 0.2f;  // in a crowd tracks are to stay beside each other
    walking.max_radius_m = static_cast<float>(described_.ground->body_radius_m);
    if (described_.ground->time_gap_s) walking.time_gap_s = static_cast<float>(*described_.ground->time_gap_s);
    if (described_.ground->climbing) walking.climbing = static_cast<float>(*described_.ground->climbing);
    if (described_.ground->descending) walking.descending = static_cast<float>(*described_.ground->descending);
    const Setting::Stone stone = setting_.stone();
    walking.ground = stone.height, walking.ground_user = stone.user;
    std::vector<const clq_locomotion *> locomotions;
    for (const walkers::Member &member : people_.cast()) locomotions.push_back(member.locomotion.get());
    check(clq_stage_set_navigation(made, navigation_.get(), &walking, locomotions.data(),
                                   static_cast<uint32_t>(locomotions.size())),
          described_.ground->at);
}

void Run::called(void *user, const clq_action_call *call)
{
    const Hook &hook = *static_cast<const Hook *>(user);
    Run &run = *hook.run;
    run.calls_.push_back({hook, {run.person_of_[call->agent.index1 - 1], call->time_s, call->value}});
}

void Run::add_actions()
{
    for (size_t s = 0; s < services_.size(); ++s) {
        const std::vector<std::string> names = services_[s]->actions();
        for (size_t a = 0; a < names.size(); ++a) {
            hooks_.push_back(std::make_unique<Hook>(Hook{this, s, a}));
            clq_action_def def = clq_action_def_init();
            def.name = names[a].c_str(), def.decide = called, def.user = hooks_.back().get();
            check(clq_stage_add_action(stage_.get(), &def), described_.at);
        }
    }
}

void Run::decide(double until_s)
{
    while (end_of_tick() <= until_s + 1e-9) tick();
}

double Run::end_of_tick() const { return begin_s + static_cast<double>(ticks_ + 1) * described_.tick_s; }

void Run::tick()
{
    const double end_s = end_of_tick();
    for (const auto &service : services_) service->before_tick(*this, end_s);
    let_in();
    if (sights_) sights_->tell(stage_.get(), agents_, end_s);
    if (options_.stall_s > 0 &&
        std::floor(end_s / options_.stall_every_s) != std::floor((end_s - described_.tick_s) / options_.stall_every_s))
        work_for(options_.stall_s);
    check(clq_stage_step(stage_.get(), end_s));
    ++ticks_;
    serve();
}

void Run::serve()
{
    for (size_t i = 0; i < calls_.size(); ++i) {
        const auto [hook, call] = calls_[i];
        if (is_here(call.person)) services_[hook.service]->serve(*this, hook.action, call);
    }
    calls_.clear();
}

void Run::let_in()
{
    const double end_s = end_of_tick();
    for (; next_arrival_ < arrivals_.size() && arrivals_[next_arrival_].due_s < end_s; ++next_arrival_)
        waiting_.push_back(arrivals_[next_arrival_]);
    const auto is_in = [this](const Arrival &one) { return let_in(one.person, one.due_s); };
    waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_in), waiting_.end());
}

bool Run::let_in(uint32_t person, double due_s)
{
    const ScenarioAgents &of = agents_of(person);
    const Person &one = people_.all()[person];
    const OnGround on_ground = [&](std::array<double, 3> &point) {
        return put_on_ground(setting_, navigation_.get(), of, point);
    };
    const IsFree is_free = [this](const std::array<double, 3> &point, double apart_m) {
        return std::none_of(here_.begin(), here_.end(), [&](uint32_t other) {
            const std::array<double, 3> at = place_of(other);
            return std::hypot(at[0] - point[0], at[2] - point[2]) < apart_m && std::fabs(at[1] - point[1]) < 1;
        });
    };
    const bool at_once = ticks_ == 0 && of.per_minute == 0;
    const uint32_t tries = at_once ? tries_at_once : tries_in_a_tick;
    Spot spot{};
    bool found = false;
    for (uint32_t i = 0; i < tries && !found; ++i)
        found = find_spot(described_, of, one.seed, static_cast<uint32_t>(ticks_) * tries_in_a_tick + i, on_ground,
                          is_free, spot);
    if (!found && at_once) refuse_crowd(of, here_.size());
    if (!found) return false;
    const Machine &machine = machines_.at(of.machine);
    clq_agent_def def = clq_agent_def_init();
    def.machine = machine.id, def.actor = one.actor, def.tmpl = people_.member(one).tmpl;
    def.agent_class = of.name.c_str(), def.seed = one.seed, def.scale = one.scale;
    std::copy(spot.position.begin(), spot.position.end(), def.position);
    def.heading_rad = static_cast<float>(spot.heading_rad);
    def.gaze = one.gaze;
    def.start_s = std::max(due_s, decided_s() + described_.tick_s / 2);
    check(clq_stage_add_agent(stage_.get(), &def, &agents_[person]), of.at);
    person_of_.resize(agents_[person].index1);
    person_of_.back() = person;
    if (sights_) sights_->came(person);
    here_.insert(std::lower_bound(here_.begin(), here_.end(), person), person);
    if (!machine.goes || !navigation_) deed({Deed::Kind::appear, def.start_s, person, spot});
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.came;
    return true;
}

std::array<double, 3> Run::place_of(uint32_t person) const
{
    clq_agent_info info = clq_agent_info_init();
    check(clq_stage_get_agent(stage_.get(), agents_[person], &info));
    return {info.position[0], info.position[1], info.position[2]};
}

std::optional<Mind> Run::mind_of(uint32_t person) const
{
    if (!is_here(person)) return {};
    clq_agent_info info = clq_agent_info_init();
    check(clq_stage_get_agent(stage_.get(), agents_[person], &info));
    const std::string &file = agents_of(person).machine;
    return Mind{file,
                machines_.at(file).states,
                info.state ? info.state : "",
                info.entered_s,
                decided_s(),
                info.transitions,
                info.walks};
}

void Run::send(uint32_t person, const char *event, const double position[3], double value)
{
    clq_stage_event made = clq_stage_event_init();
    made.name = event, made.to = agents_[person], made.value = value;
    made.at_s = decided_s() + described_.tick_s / 2;
    std::copy(position, position + 3, made.position);
    check(clq_stage_send(stage_.get(), &made), agents_of(person).machine);
}

void Run::remove(uint32_t person)
{
    if (!is_here(person)) return;
    check(clq_stage_remove_agent(stage_.get(), agents_[person]));
    agents_[person] = {};
    here_.erase(std::lower_bound(here_.begin(), here_.end(), person));
    for (const auto &service : services_) service->gone(*this, person);
    deed({Deed::Kind::vanish, decided_s(), person, {}});
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.left;
}

void Run::set_door(uint32_t door, bool open, double at_s)
{
    check(clq_navigation_set_door(navigation_.get(), door, open), described_.doors[door].at);
    deed({open ? Deed::Kind::open : Deed::Kind::close, at_s, door, {}});
}

}  // namespace staged
