/* Five people who listen and talk. A bang startles those that are near, and they return by history to what they did.
 * Decisions run a second ahead of what is shown. */
#include <claque/assets.h>
#include <claque/stage.h>

#include "samples/examples/check.h"

enum { PEOPLE = 5 };

static const char machine_text[] =
    "machine = 'visitor'\n"
    "[variables]\n"
    "calm = 1.0\n"
    "[events]\n"
    "bang = 0\n" /* priority class 0: before everything else */
    "greet = 2\n"
    "[states.at_ease]\n"
    "initial = true\n"
    "transitions = [ { on = 'bang', to = 'startled', do = [ { set = 'calm', to = 'calm - 0.5' } ] } ]\n"
    "[states.at_ease.states.listens]\n"
    "initial = true\n"
    "enter = [ { play = ['sit_look', 'sit_lean'], fade = 0.4 } ]\n"
    "transitions = [ { on = 'greet', to = 'talks' }, { after = [2, 5], to = 'talks' } ]\n"
    "[states.at_ease.states.talks]\n"
    "enter = [ { play = 'sit_talk', fade = 0.4 }, { send = 'greet', radius = 1.5, delay = [1, 2] } ]\n"
    "transitions = [ { end = true, before = 0.4, to = 'listens' } ]\n"
    "[states.startled]\n"
    "enter = [ { play = 'rise', fade = 0.1 }, { call = 'gasp' } ]\n"
    "transitions = [ { after = 2, to = 'at_ease', history = 'deep' } ]\n";

static const char timetable[] = "[[event]]\nat = 6.5\nsend = 'bang'\nradius = 2.5\n";

/* Of the host: called when the gasp is shown. */
static void gasp(void *user, const clq_action_call *call) { *(double *)user = call->time_s; }

static bool is_in(const clq_stage *stage, clq_agent agent, const char *state)
{
    clq_agent_info info = clq_agent_info_init();
    check(clq_stage_get_agent(stage, agent, &info));
    return strcmp(info.state, state) == 0;
}

/* Tells the decisions which actors entered or left view in the last update: of the others nothing is asked. Here the
 * actor of people[i] has index1 i + 1. */
static void tell_view(clq_stage *stage, const clq_crowd *crowd, const clq_agent *people, double time_s)
{
    clq_view_change changes[PEOPLE];
    clq_agent agents[PEOPLE];
    bool in_view[PEOPLE];
    size_t count;
    check(clq_crowd_get_view_changes(crowd, changes, PEOPLE, &count));
    for (size_t i = 0; i < count; ++i) {
        agents[i] = people[changes[i].actor.index1 - 1];
        in_view[i] = changes[i].in_view;
    }
    check(clq_stage_tell_view(stage, agents, in_view, (uint32_t)count, time_s));
}

/* The two flows in turn, here on one thread. */
static void play(clq_stage *stage, clq_crowd *crowd, clq_view *view, const clq_agent *people, int first, int last)
{
    for (int frame = first; frame < last; ++frame) {
        check(clq_stage_step(stage, frame / 30.0 + 1.0));
        expect(clq_stage_get_decided_s(stage) > frame / 30.0, "decisions are ahead of what is shown");
        check(clq_stage_apply(stage, crowd, frame / 30.0, NULL));
        check(clq_crowd_update(crowd, frame / 30.0, &view, 1));
        tell_view(stage, crowd, people, frame / 30.0);
    }
}

int main(void)
{
    clq_context *context;
    clq_template *tmpl;
    clq_crowd *crowd;
    clq_view *view;
    clq_stage *stage;
    double gasped_s = 0, calm = 0;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "plebeian", &tmpl));
    check(clq_crowd_create(context, NULL, &crowd));
    check(clq_view_create(crowd, &view));
    clq_look_at_def look = clq_look_at_def_init();
    clq_camera camera;
    look.eye[0] = look.target[0] = 0.5, look.eye[1] = look.target[1] = 1, look.eye[2] = 4, look.target[2] = 0;
    look.fov_y_rad = 0.5f, look.aspect = 1;
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_set_camera(view, &camera));
    check(clq_stage_create(context, NULL, &stage));

    clq_action_def action = clq_action_def_init();
    action.name = "gasp", action.show = gasp, action.user = &gasped_s;
    check(clq_stage_add_action(stage, &action));
    const clq_template *const templates[] = {tmpl};
    clq_machine_def machine = clq_machine_def_init();
    machine.source.text = machine_text, machine.source.text_bytes = sizeof machine_text - 1;
    machine.template_count = 1, machine.templates = templates;
    clq_agent_def agent = clq_agent_def_init();
    check(clq_stage_add_machine(stage, &machine, &agent.machine));
    clq_actor_def actor = clq_actor_def_init();
    actor.tmpl = tmpl, agent.tmpl = tmpl;
    clq_agent people[PEOPLE];
    for (int i = 0; i < PEOPLE; ++i) {
        actor.transform.position[0] = agent.position[0] = i, actor.seed = agent.seed = (uint64_t)i;
        check(clq_actor_create(crowd, &actor, &agent.actor));
        check(clq_stage_add_agent(stage, &agent, &people[i]));
    }
    const clq_stage_text source = {NULL, timetable, sizeof timetable - 1, "timetable"};
    check(clq_stage_add_timetable(stage, &source, 0.0));
    play(stage, crowd, view, people, 0, 180); /* 6 s are shown, 7 s are decided */
    for (int i = 0; i < PEOPLE; ++i)
        expect(is_in(stage, people[i], "startled") == (i <= 2), "those within 2.5 m are startled");
    expect(gasped_s == 0, "though it is not yet shown");
    play(stage, crowd, view, people, 180, 300);
    expect(gasped_s == 6.5, "it was shown when it happened");
    for (int i = 0; i < PEOPLE; ++i)
        expect(is_in(stage, people[i], "listens") || is_in(stage, people[i], "talks"), "all have returned");
    check(clq_stage_get_variable(stage, people[1], "calm", &calm));
    expect(calm == 0.5, "a bang takes some calm");
    clq_agent_info near_one = clq_agent_info_init(), far_one = clq_agent_info_init();
    check(clq_stage_get_agent(stage, people[0], &near_one));
    check(clq_stage_get_agent(stage, people[4], &far_one));
    expect(near_one.in_view && !far_one.in_view, "the last one is out of view, and its tasks come later");
    clq_stage_info info = clq_stage_info_init();
    check(clq_stage_get_info(stage, &info));
    expect(info.agents == PEOPLE && info.runaways == 0 && info.classes[0].late == 0, "no decision was late");

    clq_stage_destroy(stage);
    clq_template_destroy(tmpl);
    clq_crowd_destroy(crowd);
    check(clq_context_destroy(context));
    return puts("startled, and back by history") < 0;
}
