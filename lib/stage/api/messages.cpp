// What any thread may tell a stage.
#include <claque/agents.h>

#include <algorithm>
#include <cmath>

#include "lib/base/near_names.h"
#include "lib/stage/api/boundary.h"
#include "lib/stage/api/stage_handle.h"

using namespace claque;
using stage::fail;

namespace
{

using Directory = stage::Inbox::Directory;

uint32_t known_agent(const Directory &directory, clq_agent agent)
{
    const uint32_t index = agent.index1 - 1;
    if (agent.index1 == 0 || index >= directory.machine_of_agent.size() ||
        directory.machine_of_agent[index] == stage::none)
        fail(CLQ_STALE_ID, "there is no agent %u", agent.index1);
    return index;
}

void check_event(const clq_stage_event &event)
{
    stage::require_size(event, "clq_stage_event_init");
    stage::require(event.name != nullptr, "the event has no name");
    stage::require_finite(event.at_s, "at_s");
    stage::require_finite(event.value, "value");
    stage::require_place(event.position);
    if (!(event.radius_m >= 0 && std::isfinite(event.radius_m)))
        fail(CLQ_ARGUMENT, "radius_m is %g: 0 or more is wanted", double(event.radius_m));
    if (!(event.delay_s_per_m >= 0 && event.delay_s_per_m <= 1e6f))
        fail(CLQ_ARGUMENT, "delay_s_per_m is %g: 0 to 1e6 is wanted", double(event.delay_s_per_m));
}

void fill(const clq_stage_event &event, const Directory &directory, stage::Task &task)
{
    task.index = directory.shared.find_event(event.name);
    if (task.index == stage::none) fail(CLQ_ARGUMENT, "no machine declares an event '%s'", event.name);
    if (event.sender.index1) task.sender = known_agent(directory, event.sender);
    if (event.to.index1) {
        stage::require(!event.to_class && event.radius_m == 0, "an event has `to` and conditions besides");
        task.agent = known_agent(directory, event.to);
    } else if (event.to_class) {
        task.agent_class = directory.shared.find_class(event.to_class);
        if (task.agent_class == stage::none)
            fail(CLQ_ARGUMENT, "no agent and no machine has the class '%s'", event.to_class);
    }
    task.kind = event.to.index1 ? stage::TaskKind::event : stage::TaskKind::spread;
    task.due_s = event.at_s;
    task.priority = directory.shared.events[task.index].priority;
    task.value = event.value;
    task.radius_m = double(event.radius_m);
    task.per_m_s = double(event.delay_s_per_m);
    task.has_place = 1;
    std::copy(event.position, event.position + 3, task.place);
}

void find_variable(const Directory &directory, clq_agent agent, const char *name, double value, stage::Task &task)
{
    const std::vector<stage::Variable> *all = &directory.shared.crowd;
    if (agent.index1) {
        task.agent = known_agent(directory, agent);
        all = &directory.machines[directory.machine_of_agent[task.agent]]->variables;
    }
    const auto found =
        std::find_if(all->begin(), all->end(), [&](const stage::Variable &one) { return one.name == name; });
    if (found == all->end()) {
        std::vector<std::string_view> names;
        for (const stage::Variable &one : *all) names.emplace_back(one.name);
        fail(CLQ_ARGUMENT, "there is no variable '%s'%s", name, base::names_near(name, names).c_str());
    }
    if (found->type == stage::Type::truth && value != 0 && value != 1)
        fail(CLQ_ARGUMENT, "the variable '%s' is true or false: 0 or 1 is wanted, not %g", name, value);
    task.index = static_cast<uint32_t>(found - all->begin());
}

}  // namespace

extern "C" {

clq_status clq_stage_send(clq_stage *stage, const clq_stage_event *event)
{
    return stage::boundary("clq_stage_send", [&] {
        stage::require(stage && event, "stage or event is NULL");
        check_event(*event);
        stage->director.inbox.post(
            [&](const Directory &directory, stage::Task &task) { fill(*event, directory, task); });
    });
}

clq_status clq_stage_set_variable(clq_stage *stage, clq_agent agent, const char *name, double value, double at_s)
{
    return stage::boundary("clq_stage_set_variable", [&] {
        stage::require(stage && name, "stage or name is NULL");
        stage::require_finite(value, "value");
        stage::require_finite(at_s, "at_s");
        stage->director.inbox.post([&](const Directory &directory, stage::Task &task) {
            find_variable(directory, agent, name, value, task);
            task.kind = stage::TaskKind::set;
            task.due_s = at_s;
            task.value = value;
        });
    });
}

clq_status clq_stage_tell_view(clq_stage *stage, const clq_agent *agents, const bool *in_view, uint32_t count,
                               double at_s)
{
    return stage::boundary("clq_stage_tell_view", [&] {
        stage::require(stage && ((agents && in_view) || count == 0), "stage, agents or in_view is NULL");
        stage::require_finite(at_s, "at_s");
        stage->director.inbox.post_many(count, [&](const Directory &directory, uint32_t i, stage::Task &task) {
            task.agent = known_agent(directory, agents[i]);
            task.kind = stage::TaskKind::view;
            task.due_s = at_s;
            task.value = in_view[i];
        });
    });
}

}  // extern "C"
