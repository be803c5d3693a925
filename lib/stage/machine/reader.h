// Reads a machine from its document, in the order: names, states, then what the states hold, then the checks of the
// whole. Its functions are spread over read_machine.cpp, read_states.cpp and read_actions.cpp.
#pragma once

#include <map>

#include "lib/stage/machine/document.h"
#include "lib/stage/machine/machine.h"

namespace claque::stage
{

class MachineReader : private Names
{
public:
    MachineReader(const Document &document, Machine &out, Vocabulary &shared)
        : doc_(document), out_(out), shared_(shared)
    {
    }
    void read();

    // Where the file has a state, a transition, a clip, a marker and a node of a mask.
    std::vector<const toml::node *> state_nodes, transition_nodes, clip_nodes, marker_nodes;
    std::vector<std::vector<const toml::node *>> mask_nodes;

private:
    // read_machine.cpp
    void read_names();
    void read_variables(const toml::table &from, std::vector<Variable> &out, uint32_t most, const char *what);
    void read_crowd(const toml::table &from);
    void read_events(const toml::table &from);
    void read_masks(const toml::table &from);
    Found variable(std::string_view name) const override;
    Found crowd_variable(std::string_view name) const override;
    uint32_t agent_class(std::string_view name) override { return shared_.add_class(name); }
    std::string near(std::string_view name) const override;

    // read_states.cpp
    void declare_states(const toml::node &from, uint32_t parent);
    void declare_state(const toml::key &key, const toml::node &from, uint32_t parent);
    uint32_t initial_of(uint32_t parent, const toml::node &from) const;
    void read_state(uint32_t state);
    void read_while(uint32_t state, const toml::node &from);
    void read_transition(uint32_t state, const toml::node &from);
    void read_trigger(const toml::table &from, Transition &made);
    void read_targets(const toml::table &from, Transition &made);
    void note_reads(State &state, const Transition &transition);
    uint32_t state_named(const std::string &name, const toml::node &at) const;

    // read_actions.cpp
    Range read_actions(const toml::node &from, const std::string &what);
    void read_action(const toml::table &from, Action &made);
    void read_play(const toml::table &from, Action &made);
    void read_gesture(const toml::table &from, Action &made);
    void read_set(const toml::table &from, Action &made);
    void read_send(const toml::table &from, Action &made);
    void read_look(const toml::table &from, Action &made);
    void read_go(const toml::table &from, Action &made);
    void read_call(const toml::table &from, Action &made);
    Range read_clips(const toml::node &from, const std::string &what);
    uint32_t number_of(std::vector<std::string> &names, std::vector<const toml::node *> &nodes, const std::string &name,
                       const toml::node &at, uint32_t most, const char *what);
    uint32_t event_named(const toml::node &from, const std::string &what) const;
    Quantity quantity(const toml::table &from, const char *key, double otherwise, double least, double most);
    Program expression(const toml::node &from, const std::string &what, Type wanted);
    Program guard(const toml::table &from);
    uint32_t next_purpose() { return 0x80000000u + purposes_++; }

    const Document &doc_;
    Machine &out_;
    Vocabulary &shared_;
    std::map<std::string, uint32_t, std::less<>> states_;
    std::map<std::string, const toml::node *, std::less<>> places_;
    std::vector<uint32_t> own_crowd_;  // variables of the crowd that this file declares
    uint32_t purposes_ = 0;
};

// The checks of the whole machine: states that nothing leads to, and instant transitions without end.
void check_machine(const Document &document, const Machine &machine, const std::vector<const toml::node *> &state_nodes,
                   const std::vector<const toml::node *> &transition_nodes);

}  // namespace claque::stage
