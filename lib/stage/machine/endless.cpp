// Instant transitions round which an agent would run for ever: a cycle of them whose conditions can hold together while
// nothing on the way changes what they read. Conditions are understood where they join comparisons of a variable with a
// number by `and`; others end the search, and the limit at run time remains.
#include <algorithm>
#include <cmath>
#include <map>

#include "lib/stage/error.h"
#include "lib/stage/machine/reader.h"

namespace claque::stage
{

namespace
{

constexpr uint32_t max_steps = 20000;  // of the whole search
constexpr size_t max_cycle = 12;

struct Interval {
    double low = -INFINITY, high = INFINITY;
    bool low_open = false, high_open = false;
    bool empty() const { return low > high || (low == high && (low_open || high_open)); }

    void at_least(double number, bool open)
    {
        if (number > low || (number == low && open)) low = number, low_open = open;
    }
    void at_most(double number, bool open)
    {
        if (number < high || (number == high && open)) high = number, high_open = open;
    }
};

using Key = std::pair<bool, uint32_t>;  // of the crowd, index
using Facts = std::map<Key, Interval>;

// Narrows what must hold by one comparison. False: it is not understood.
bool compare(Code code, double number, Interval &in)
{
    if (code != Code::less && code != Code::less_equal) in.at_least(number, code == Code::greater);
    if (code != Code::greater && code != Code::greater_equal) in.at_most(number, code == Code::less);
    return code >= Code::less && code <= Code::equal;
}

// Reads one part of a condition at `i`. False: it is not understood.
bool read_part(const std::vector<Op> &ops, uint32_t &i, uint32_t end, Facts &facts)
{
    const Op &first = ops[i++];
    if (first.code == Code::number && (i >= end || ops[i].code == Code::skip_if_false)) {
        if (first.number == 0) facts[{true, none}].at_least(INFINITY, true);
        return true;
    }
    if (first.code != Code::variable && first.code != Code::crowd) return false;
    Interval &in = facts[{first.code == Code::crowd, first.index}];
    if (i + 1 < end && ops[i].code == Code::number && ops[i + 1].code >= Code::less && ops[i + 1].code <= Code::equal) {
        i += 2;
        return compare(ops[i - 1].code, ops[i - 2].number, in);
    }
    const bool negated = i < end && ops[i].code == Code::negation;
    i += negated;
    return compare(Code::equal, negated ? 0 : 1, in);
}

bool read_guard(const std::vector<Op> &ops, Program guard, Facts &facts)
{
    for (uint32_t i = guard.first, end = guard.first + guard.count; i < end;) {
        if (!read_part(ops, i, end, facts)) return false;
        if (i < end && ops[i++].code != Code::skip_if_false) return false;
    }
    return true;
}

class Search
{
public:
    Search(const Document &document, const Machine &machine, const std::vector<const toml::node *> &nodes)
        : doc_(document), machine_(machine), nodes_(nodes)
    {
    }

    void from(uint32_t transition)
    {
        start_ = transition;
        step(transition, Facts());
    }

private:
    const Transition &at(uint32_t i) const { return machine_.transitions[i]; }

    bool is_inside(uint32_t state, uint32_t outer) const
    {
        while (state != none && state != outer) state = machine_.states[state].parent;
        return state == outer;
    }

    void step(uint32_t transition, Facts facts)
    {
        if (++steps_ > max_steps || way_.size() >= max_cycle) return;
        if (!read_guard(machine_.ops, at(transition).guard, facts)) return;
        for (const auto &[key, in] : facts)
            if (in.empty()) return;
        way_.push_back(transition);
        const Range &targets = at(transition).targets;
        if (targets.count == 0 && transition == start_) close(facts);
        for (uint32_t i = 0; i < targets.count; ++i) go_on(machine_.targets[targets.first + i].state, facts);
        way_.pop_back();
    }

    // With history an agent may be deeper than here; a cycle that needs it is left to the limit at run time.
    void go_on(uint32_t state, const Facts &facts)
    {
        while (machine_.states[state].initial != none) state = machine_.states[state].initial;
        for (uint32_t up = state; up != none; up = machine_.states[up].parent) {
            const Range &all = machine_.states[up].transitions;
            for (uint32_t next = all.first; next < all.first + all.count; ++next) {
                if (at(next).trigger != Trigger::instant) continue;
                if (next == start_) close(facts);
                else if (std::find(way_.begin(), way_.end(), next) == way_.end()) step(next, facts);
            }
        }
    }

    bool changes(Range actions, const Facts &facts) const
    {
        for (uint32_t i = 0; i < actions.count; ++i) {
            const Action &action = machine_.actions[actions.first + i];
            if (action.verb == Verb::set && facts.count({action.of_crowd, action.variable})) return true;
        }
        return false;
    }

    void close(const Facts &facts)
    {
        for (const uint32_t i : way_) {
            if (changes(at(i).actions, facts)) return;
            if (at(i).targets.count == 0) continue;
            // Too many states at worst: what sets a variable anywhere near is taken to change it.
            for (uint32_t state = 0; state < machine_.states.size(); ++state)
                if (is_inside(at(i).source, state) || is_inside(state, at(i).source))
                    if (changes(machine_.states[state].enter, facts) || changes(machine_.states[state].leave, facts))
                        return;
        }
        std::string lines;
        for (size_t i = 1; i < way_.size(); ++i) lines += text_of(", line %u", at(way_[i]).line);
        doc_.refuse(*nodes_[way_[0]], way_.size() == 1
                                          ? "this transition would be taken again and again without time passing"
                                          : "this transition and those in" + lines.substr(1) +
                                                " would be taken in turn for ever without time passing");
    }

    const Document &doc_;
    const Machine &machine_;
    const std::vector<const toml::node *> &nodes_;
    std::vector<uint32_t> way_;
    uint32_t start_ = 0, steps_ = 0;
};

}  // namespace

void check_endless(const Document &document, const Machine &machine,
                   const std::vector<const toml::node *> &transition_nodes)
{
    Search search(document, machine, transition_nodes);
    for (uint32_t i = 0; i < machine.transitions.size(); ++i)
        if (machine.transitions[i].trigger == Trigger::instant) search.from(i);
}

}  // namespace claque::stage
