// State: the machine of a person that decides, with the state that it is in.
#include "samples/view/ground/ground_panels.h"

namespace view
{
namespace
{

constexpr size_t most_shown = 6;

// Decisions run ahead of what is shown: the state shown is the last one that was entered by now.
const Ground::Entered *shown_of(const std::deque<Ground::Entered> &entered, double time_s)
{
    const Ground::Entered *shown = nullptr;
    for (const Ground::Entered &one : entered)
        if (one.at_s <= time_s) shown = &one;
    return shown;
}

}  // namespace

void state_panel(Ui &ui, Model &model)
{
    const Ground &ground = model.ground;
    if (!ground.mind) return ui.faint("It runs no state machine: open a scenario with [stage].");
    const scenes::Mind &mind = *ground.mind;
    const Ground::Entered *shown = shown_of(ground.entered, model.clock.time_s);
    const size_t slash = mind.machine.rfind('/');
    ui.row("machine", slash == std::string::npos ? mind.machine : mind.machine.substr(slash + 1));
    if (shown) ui.row("state", shown->state + " for " + fixed(model.clock.time_s - shown->at_s, 1) + " s");
    ui.row("decided", fixed(mind.decided_s - model.clock.time_s, 2) +
                          " s ahead: " + (mind.state.empty() ? "nothing yet" : mind.state));
    ui.row("transitions", whole(mind.transitions) + (mind.walks ? ", on its way" : ""));
    ui.space();
    for (const std::string &state : mind.states) {
        const size_t dot = state.rfind('.');
        const std::string own = dot == std::string::npos ? state : state.substr(dot + 1);
        size_t depth = 0;
        for (const char c : state) depth += c == '.';
        const std::string words = std::string(2 * depth, ' ') + own;
        if (shown && shown->state == own) ui.warning("> " + words);
        else ui.faint("  " + words);
    }
    ui.space();
    size_t count = 0;
    for (auto one = ground.entered.rbegin(); one != ground.entered.rend() && count < most_shown; ++one)
        if (one->at_s <= model.clock.time_s) {
            ui.faint(fixed(one->at_s, 2) + " s: " + one->state);
            ++count;
        }
}

}  // namespace view
