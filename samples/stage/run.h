// A run of a scenario whose people decide: the stage, the crowd that shows it, the ground, and what the host does in
// between. Two flows: decide() and what it calls on one thread, show() and the crowd on another; or both on one.
#pragma once

#include <array>
#include <deque>
#include <mutex>

#include "samples/stage/arrivals.h"
#include "samples/stage/flyers.h"
#include "samples/stage/ground.h"
#include "samples/stage/machines.h"
#include "samples/stage/people.h"
#include "samples/stage/services.h"
#include "samples/stage/sights.h"

namespace staged
{

struct RunOptions {
    bool live = false;  // the budget counts microseconds, and the record is what happened
    // For measuring: a decision at work for so long, whenever this much of the run's time has passed; 0: none.
    double stall_s = 0, stall_every_s = 5;
};

struct RunCounts {
    uint64_t came = 0, left = 0;     // people
    uint64_t commands = 0;           // that the crowd got
    uint64_t refused = 0, late = 0;  // of these
};

// What comes from outside while a time is shown is heard so long afterwards: in the first tick that cannot be decided
// yet.
double heard_after_s(const scenes::Staging &stage);

class Run
{
public:
    // Throws Failure with the place in the scenario.
    Run(scenes::Library &library, const scenes::CrowdOptions &crowd_options, const scenes::Scenario &scenario,
        const Setting &setting, const RunOptions &options);
    ~Run();
    Run(const Run &) = delete;
    Run &operator=(const Run &) = delete;

    // The flow of decisions: all ticks that end at or before a time, one by one.
    void decide(double until_s);
    void tick();
    double end_of_tick() const;  // of the next one

    // The flow that draws: gives the crowd what is due. clq_crowd_update with the same time follows.
    void show(double time_s);

    // In a run with a camera path: shows the times before time_s at which it looks for agents in view of that camera.
    // `reach` is called with each of them before.
    void look(double time_s, const std::function<void(double)> &reach);

    // The state of the run, its stage and its crowd; no flow may be at work meanwhile. A run of the same scenario, seed
    // and characters that takes it goes on as this one does. restore() throws Failure on anything else; the run is then
    // of no more use.
    std::vector<uint8_t> save() const;
    void restore(const std::vector<uint8_t> &bytes);
    double shown_s() const { return shown_s_; }  // the time of the last show()

    clq_crowd *crowd() const { return people_.crowd(); }
    const People &people() const { return people_; }
    std::vector<clq_template *> templates() const;  // of people and of what flies over them
    const scenes::Staging &stage() const { return described_; }
    double decided_s() const { return clq_stage_get_decided_s(stage_.get()); }
    clq_stage_info info() const;
    RunCounts counts() const;
    std::vector<DoorCount> doors() const;  // in the flow of decisions, or while that rests

    // For services, in the flow of decisions.
    clq_navigation *navigation() const { return navigation_.get(); }
    clq_stage *handle() const { return stage_.get(); }
    uint64_t seed() const { return seed_; }
    const scenes::ScenarioAgents &agents_of(uint32_t person) const
    {
        return described_.agents[people_.all()[person].agents];
    }
    const std::vector<uint32_t> &here() const { return here_; }  // people, ascending
    bool is_here(uint32_t person) const { return agents_[person].index1 != 0; }
    clq_agent agent_of(uint32_t person) const { return agents_[person]; }
    std::array<double, 3> place_of(uint32_t person) const;
    // Likewise; none: it is not here.
    std::optional<scenes::Mind> mind_of(uint32_t person) const;
    // An event for one person in the next tick, with a place: `go = "sender"` leads there.
    void send(uint32_t person, const char *event, const double position[3], double value = 0);
    // In the flow that draws: an event for all, after the lead. Throws Failure where no machine has it.
    void send_all(const std::string &event, double value);
    void remove(uint32_t person);
    void set_door(uint32_t door, bool open, double at_s);

private:
    // What the flow that draws does besides the stage's commands.
    struct Deed {
        enum class Kind : uint8_t { appear, vanish, open, close };
        Kind kind;
        double at_s;
        uint32_t what;  // person or door
        Spot spot;
    };
    struct Hook {
        Run *run;
        size_t service, action;
    };

    void make_stage(scenes::Library &library, const RunOptions &options);
    void add_actions();
    void let_in();
    bool let_in(uint32_t person, double due_s);
    void serve();
    void deed(const Deed &one);
    void appear(const Deed &one);
    void put_state(BytesOut &out) const;
    void take_state(BytesIn &in);
    static void called(void *user, const clq_action_call *call);

    scenes::Staging described_;
    const Setting &setting_;
    uint64_t seed_;
    RunOptions options_;
    People people_;
    Flyers flyers_;
    std::optional<scenes::CameraPath> path_;  // of the camera that looks
    std::optional<Sights> sights_;
    OwnNavigation navigation_;
    OwnStage stage_;
    std::vector<std::unique_ptr<Service>> services_;
    std::vector<std::unique_ptr<Hook>> hooks_;
    std::map<std::string, Machine> machines_;

    std::vector<Arrival> arrivals_;
    size_t next_arrival_ = 0;
    std::vector<Arrival> waiting_;     // that found no room
    std::vector<clq_agent> agents_;    // by person; {0}: not here
    std::vector<uint32_t> person_of_;  // by agent
    std::vector<uint32_t> here_;       // people, ascending
    std::vector<std::pair<Hook, Call>> calls_;
    uint64_t ticks_ = 0;

    double shown_s_ = begin_s;
    mutable std::mutex mutex_;
    std::deque<Deed> deeds_;  // by time
    RunCounts counts_;
};

}  // namespace staged
