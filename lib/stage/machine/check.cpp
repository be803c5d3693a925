// States that nothing leads to.
#include "lib/stage/machine/reader.h"

namespace claque::stage
{

void check_endless(const Document &document, const Machine &machine,
                   const std::vector<const toml::node *> &transition_nodes);

namespace
{

class Reached
{
public:
    explicit Reached(const Machine &machine) : machine_(machine), reached_(machine.states.size()) {}

    void enter(uint32_t state)
    {
        for (uint32_t up = state; up != none; up = machine_.states[up].parent) mark(up);
        for (uint32_t in = machine_.states[state].initial; in != none; in = machine_.states[in].initial) mark(in);
    }

    void follow()
    {
        while (!open_.empty()) {
            const State &state = machine_.states[open_.back()];
            open_.pop_back();
            for (uint32_t t = 0; t < state.transitions.count; ++t) {
                const Range &targets = machine_.transitions[state.transitions.first + t].targets;
                for (uint32_t i = 0; i < targets.count; ++i)
                    if (machine_.targets[targets.first + i].weight > 0)
                        enter(machine_.targets[targets.first + i].state);
            }
        }
    }

    bool has(uint32_t state) const { return reached_[state]; }

private:
    void mark(uint32_t state)
    {
        if (reached_[state]) return;
        reached_[state] = true;
        open_.push_back(state);
    }

    const Machine &machine_;
    std::vector<bool> reached_;
    std::vector<uint32_t> open_;
};

}  // namespace

void check_machine(const Document &document, const Machine &machine, const std::vector<const toml::node *> &state_nodes,
                   const std::vector<const toml::node *> &transition_nodes)
{
    Reached reached(machine);
    reached.enter(machine.initial);
    reached.follow();
    for (uint32_t i = 0; i < machine.states.size(); ++i)
        if (!reached.has(i))
            document.refuse(*state_nodes[i], "nothing leads to the state '" + machine.states[i].name + "'");
    check_endless(document, machine, transition_nodes);
}

}  // namespace claque::stage
