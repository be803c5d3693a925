/* A script tells a stage from outside what happens, as any thread may. In the middle of it the stage and the crowd are
 * saved; restored, they have the same future. */
#include <claque/assets.h>
#include <claque/stage.h>

#include "samples/examples/check.h"

enum { PEOPLE = 4 };

static const char machine_text[] =
    "machine = 'listener'\n"
    "[variables]\n"
    "heard = 0\n"
    "[crowd]\n"
    "quiet = true\n"
    "[events]\n"
    "call = 1\n"
    "[states.waits]\n"
    "initial = true\n"
    "enter = [ { play = 'sit_look' } ]\n"
    "transitions = [ { on = 'call', if = 'crowd.quiet', to = 'claps', do = [ { set = 'heard', to = 'heard + value' } ] "
    "} ]\n"
    "[states.claps]\n"
    "enter = [ { play = 'sit_applaud', speed = [0.9, 1.1] } ]\n"
    "transitions = [ { after = [1, 3], to = 'waits' } ]\n";

typedef struct bytes {
    char data[1 << 18];
    size_t size;
} bytes;

static int take(void *user, const void *data, size_t size)
{
    bytes *to = (bytes *)user;
    if (size > sizeof to->data - to->size) return 1;
    memcpy(to->data + to->size, data, size);
    to->size += size;
    return 0;
}

static void call_all(clq_stage *stage, double at_s, double value, float radius_m)
{
    clq_stage_event event = clq_stage_event_init();
    event.name = "call", event.at_s = at_s, event.value = value, event.radius_m = radius_m;
    check(clq_stage_send(stage, &event));
}

static double heard(const clq_stage *stage, clq_agent agent)
{
    double value;
    check(clq_stage_get_variable(stage, agent, "heard", &value));
    return value;
}

static uint64_t play_to(clq_stage *stage, clq_crowd *crowd, double time_s)
{
    clq_stage_info info = clq_stage_info_init();
    check(clq_stage_step(stage, time_s + 1));
    check(clq_stage_apply(stage, crowd, time_s, NULL));
    check(clq_stage_get_info(stage, &info));
    return info.hash;
}

int main(void)
{
    clq_context *context;
    clq_template *tmpl;
    clq_crowd *crowd;
    clq_stage *stage;
    static bytes saved, saved_crowd;
    clq_agent people[PEOPLE];
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "patrician", &tmpl));
    check(clq_crowd_create(context, NULL, &crowd));
    check(clq_stage_create(context, NULL, &stage));
    const clq_template *const templates[] = {tmpl};
    clq_machine_def machine = clq_machine_def_init();
    machine.source.text = machine_text, machine.source.text_bytes = sizeof machine_text - 1;
    machine.template_count = 1, machine.templates = templates;
    clq_agent_def agent = clq_agent_def_init();
    check(clq_stage_add_machine(stage, &machine, &agent.machine));
    clq_actor_def actor = clq_actor_def_init();
    actor.tmpl = tmpl, agent.tmpl = tmpl;
    for (int i = 0; i < PEOPLE; ++i) {
        agent.position[0] = i, agent.seed = (uint64_t)i;
        check(clq_actor_create(crowd, &actor, &agent.actor));
        check(clq_stage_add_agent(stage, &agent, &people[i]));
    }

    const double far_away[3] = {50, 0, 0};
    const bool is_seen = false;
    check(clq_stage_set_place(stage, people[1], far_away));
    check(clq_stage_tell_view(stage, &people[3], &is_seen, 1, 0.5)); /* its tasks now come later than the others' */
    call_all(stage, 1.0, 1, 2.5f);
    call_all(stage, 6.0, 10, 0);
    check(clq_stage_set_variable(stage, people[2], "heard", 100, 3));
    play_to(stage, crowd, 1);
    expect(heard(stage, people[0]) == 1 && heard(stage, people[1]) == 0, "within 2.5 m it is heard");
    check(clq_stage_save(stage, take, &saved));
    check(clq_crowd_save(crowd, take, &saved_crowd));
    const uint64_t first = play_to(stage, crowd, 9);
    expect(heard(stage, people[0]) == 11 && heard(stage, people[2]) == 110, "then all hear it, with what was set");

    check(clq_stage_restore(stage, crowd, saved.data, saved.size));
    check(clq_crowd_restore(crowd, saved_crowd.data, saved_crowd.size, &tmpl, 1));
    expect(heard(stage, people[0]) == 1, "back to the second second");
    expect(play_to(stage, crowd, 9) == first, "and the same future");

    check(clq_stage_set_variable(stage, (clq_agent){0}, "quiet", 0, 11));
    check(clq_stage_remove_agent(stage, people[3]));
    call_all(stage, 12, 1000, 0);
    play_to(stage, crowd, 12);
    expect(heard(stage, people[0]) == 11, "where it is not quiet, no one hears it");
    clq_stage_destroy(stage);
    clq_template_destroy(tmpl);
    clq_crowd_destroy(crowd);
    check(clq_context_destroy(context));
    return puts("heard, restored and heard again") < 0;
}
