// Machines, actions and agents.
#include <claque/agents.h>
#include <claque/template_info.h>

#include <algorithm>
#include <cmath>

#include "lib/base/near_names.h"
#include "lib/stage/api/boundary.h"
#include "lib/stage/api/stage_handle.h"

using namespace claque;
using stage::fail;

namespace
{

std::vector<stage::CastDef> casts_of(const clq_machine_def &def)
{
    stage::require(def.template_count > 0 && def.templates, "templates is NULL, or template_count is 0");
    std::vector<stage::CastDef> casts;
    for (uint32_t i = 0; i < def.template_count; ++i) {
        if (!def.templates[i]) fail(CLQ_ARGUMENT, "template %u is NULL", i);
        for (uint32_t k = 0; k < i; ++k)
            if (def.templates[k] == def.templates[i]) fail(CLQ_ARGUMENT, "templates %u and %u are the same", k, i);
        casts.push_back({def.templates[i], def.locomotions ? def.locomotions[i] : nullptr});
    }
    return casts;
}

stage::Agent agent_of(const stage::Director &director, const clq_agent_def &def)
{
    stage::Agent made;
    if (def.machine.index1 == 0 || def.machine.index1 > director.machines.size())
        fail(CLQ_ARGUMENT, "there is no machine %u", def.machine.index1);
    made.machine = def.machine.index1 - 1;
    const stage::Machine &machine = *director.machines[made.machine];
    const auto cast = std::find_if(machine.casts.begin(), machine.casts.end(),
                                   [&](const stage::Cast &one) { return one.tmpl == def.tmpl; });
    if (cast == machine.casts.end())
        fail(CLQ_ARGUMENT, "tmpl is none of the %zu templates of the machine '%s'", machine.casts.size(),
             machine.name.c_str());
    made.cast = static_cast<uint32_t>(cast - machine.casts.begin());
    stage::require_place(def.position);
    stage::require_finite(double(def.heading_rad), "heading_rad");
    stage::require_finite(def.start_s, "start_s");
    if (!(def.scale > 0 && std::isfinite(def.scale)))
        fail(CLQ_ARGUMENT, "scale is %g: above 0 is wanted", double(def.scale));
    made.actor = def.actor;
    made.seed = def.seed;
    made.gaze = def.gaze;
    made.scale = def.scale;
    made.heading_rad = double(def.heading_rad);
    std::copy(def.position, def.position + 3, made.position);
    made.is_walker = machine.goes && cast->locomotion && director.movement;
    return made;
}

}  // namespace

extern "C" {

clq_status clq_stage_add_action(clq_stage *stage, const clq_action_def *def)
{
    return stage::boundary("clq_stage_add_action", [&] {
        stage::require(stage && def, "stage or def is NULL");
        stage::require_size(*def, "clq_action_def_init");
        stage::require(def->decide || def->show, "decide and show are both NULL");
        auto made = std::make_unique<stage::HostAction>();
        made->name = stage::name_of(def->name);
        stage::require(!made->name.empty(), "the name is empty");
        made->def = *def;
        made->def.name = made->name.c_str();
        const stage::Deciding deciding(stage);
        for (const std::string &taken : stage->director.shared.actions)
            if (taken == made->name) fail(CLQ_ARGUMENT, "there is an action '%s' already", made->name.c_str());
        stage->director.add_action(std::move(made));
    });
}

clq_status clq_stage_add_machine(clq_stage *stage, const clq_machine_def *def, clq_machine *out)
{
    return stage::boundary("clq_stage_add_machine", [&] {
        stage::require(stage && def && out, "stage, def or out is NULL");
        stage::require_size(*def, "clq_machine_def_init");
        const std::vector<stage::CastDef> casts = casts_of(*def);
        const stage::Text text = stage::read_text(&def->source);
        const stage::Deciding deciding(stage);
        stage::Vocabulary shared = stage->director.shared;
        std::unique_ptr<stage::Machine> made = stage::read_machine(text.bytes, text.name, casts, shared);
        stage->director.add_machine(std::move(made), std::move(shared));
        *out = {static_cast<uint32_t>(stage->director.machines.size())};
    });
}

clq_status clq_stage_add_agent(clq_stage *stage, const clq_agent_def *def, clq_agent *out)
{
    return stage::boundary("clq_stage_add_agent", [&] {
        constexpr size_t most = size_t(1) << 24;
        stage::require(stage && def && out, "stage, def or out is NULL");
        stage::require_size(*def, "clq_agent_def_init");
        const stage::Deciding deciding(stage);
        if (stage->director.agents.size() >= most) fail(CLQ_LIMIT, "the stage has had %zu agents: no more fit", most);
        stage::Agent made = agent_of(stage->director, *def);
        *out = {stage->director.add_agent(std::move(made), stage::name_of(def->agent_class), def->start_s) + 1};
    });
}

clq_status clq_stage_remove_agent(clq_stage *stage, clq_agent agent)
{
    return stage::boundary("clq_stage_remove_agent", [&] {
        stage::require(stage != nullptr, "stage is NULL");
        const stage::Deciding deciding(stage);
        stage->director.remove_agent(stage::index_of(stage->director, agent));
    });
}

clq_status clq_stage_set_place(clq_stage *stage, clq_agent agent, const double position[3])
{
    return stage::boundary("clq_stage_set_place", [&] {
        stage::require(stage && position, "stage or position is NULL");
        stage::require_place(position);
        const stage::Deciding deciding(stage);
        stage->director.set_place(stage::index_of(stage->director, agent), position);
    });
}

clq_status clq_stage_get_agent(const clq_stage *stage, clq_agent agent, clq_agent_info *out)
{
    return stage::boundary("clq_stage_get_agent", [&] {
        stage::require(stage && out, "stage or out is NULL");
        stage::require_size(*out, "clq_agent_info_init");
        const stage::Director &director = stage->director;
        const stage::Agent &of = director.agents[stage::index_of(director, agent)];
        clq_agent_info info = clq_agent_info_init();
        const stage::Level *in = of.innermost();
        info.actor = of.actor;
        info.state = in ? director.machines[of.machine]->states[in->state].name.c_str() : "";
        info.depth = of.depth;
        info.entered_s = in ? in->entered_s : 0;
        info.transitions = of.transitions;
        std::copy(of.position, of.position + 3, info.position);
        info.in_view = of.in_view;
        info.walks = of.walking;
        *out = info;
    });
}

clq_status clq_stage_get_variable(const clq_stage *stage, clq_agent agent, const char *name, double *out)
{
    return stage::boundary("clq_stage_get_variable", [&] {
        stage::require(stage && name && out, "stage, name or out is NULL");
        const stage::Director &director = stage->director;
        const bool of_crowd = agent.index1 == 0;
        const stage::Agent *of = of_crowd ? nullptr : &director.agents[stage::index_of(director, agent)];
        const std::vector<stage::Variable> &all =
            of_crowd ? director.shared.crowd : director.machines[of->machine]->variables;
        for (size_t i = 0; i < all.size(); ++i) {
            if (all[i].name != name) continue;
            *out = of_crowd ? director.crowd[i] : i < of->variables.size() ? of->variables[i] : all[i].initial;
            return;
        }
        std::vector<std::string_view> names;
        for (const stage::Variable &one : all) names.emplace_back(one.name);
        fail(CLQ_ARGUMENT, "there is no variable '%s'%s", name, base::names_near(name, names).c_str());
    });
}

clq_status clq_stage_add_timetable(clq_stage *stage, const clq_stage_text *source, double offset_s)
{
    return stage::boundary("clq_stage_add_timetable", [&] {
        stage::require(stage && source, "stage or source is NULL");
        stage::require_finite(offset_s, "offset_s");
        const stage::Text text = stage::read_text(source);
        const stage::Deciding deciding(stage);
        stage::Vocabulary shared = stage->director.shared;
        std::vector<stage::Entry> made = stage::read_timetable(text, shared, offset_s);
        for (const std::string &agent_class : shared.classes)
            stage->director.inbox.change(
                [&](stage::Inbox::Directory &directory) { directory.shared.add_class(agent_class); });
        stage->director.add_entries(std::move(made));
        stage->director.shared = std::move(shared);
    });
}

}  // extern "C"
