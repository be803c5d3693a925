// The Movement of a stage on a navigation (lib/stage/movement.h): walkers that are simulated one piece ahead of the
// time that is decided, so that the piece of each time is there when the time is decided.
#pragma once

#include <vector>

#include "lib/stage/movement.h"
#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

class Walking : public stage::Movement
{
public:
    // `locomotions`: of all agents that may be restored.
    Walking(clq_navigation &navigation, const clq_walkers_def &def, std::vector<const clq_locomotion *> locomotions);
    ~Walking() override;

    void add(stage::AgentIndex agent, const stage::Walker &walker, double at_s) override;
    void remove(stage::AgentIndex agent, double at_s) override;
    void go(stage::AgentIndex agent, const stage::Goal &goal, double at_s) override;
    void stop(stage::AgentIndex agent, double at_s) override;
    void advance(double until_s, stage::Moved &out) override;
    stage::Place place(stage::AgentIndex agent, double time_s) const override;
    uint32_t cost_of_go() const override { return 4; }
    void save(std::vector<uint8_t> &out) const override;
    void restore(const uint8_t *bytes, size_t size_bytes) override;

private:
    struct Shown {
        HeldTrack track;
        double begin_s = 0, end_s = 0;
        bool given = false, rises = false;
    };
    // An agent of the stage. It comes when the walkers' time reaches its own.
    struct Person {
        enum class Is : uint8_t { away, coming, here, settled };
        Is is = Is::away;
        stage::Walker walker;
        double at_s = 0;  // when it comes
        clq_walker id = {0, 0};
        bool goes = false;  // to `goal`, of which no answer is known yet
        stage::Goal goal;
        // It is where its goal is, beside the ground, since then; infinite: it is not.
        double settled_s = INFINITY;
        double leaves_s = INFINITY;  // when its actor leaves its track
        bool rises = false;          // it had settled; its next piece is the first one
        std::vector<Shown> pieces;
    };
    using Locomotions = std::vector<const clq_locomotion *>;

    Person &person(stage::AgentIndex agent);
    void let_in(stage::AgentIndex agent);
    void send(stage::AgentIndex agent);
    void answer(stage::AgentIndex agent, bool reached);
    void forget_answer(stage::AgentIndex agent);
    void take_pieces();
    void look_for_answers();
    void settle(stage::AgentIndex agent);
    void unsettle(stage::AgentIndex agent, double at_s);
    void prune(double until_s);
    template <class Archive>
    static void walk_person(Archive &archive, Person &person, const Locomotions &locomotions);
    static void walk_pieces(stage::SaveWriter &out, Person &person);
    static void walk_pieces(stage::SaveReader &in, Person &person);

    clq_navigation &navigation_;
    clq_walkers_def def_;
    std::vector<const clq_locomotion *> locomotions_;
    std::unique_ptr<Walkers> walkers_;
    std::vector<Person> people_;               // by agent
    std::vector<stage::AgentIndex> agent_of_;  // by walker
    std::vector<stage::Arrival> arrivals_;     // that are not given yet
};

}  // namespace claque::walk
