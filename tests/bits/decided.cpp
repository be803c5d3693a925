// Agents of a stage that walk to each other's places through a door, wait, and talk.
#include <claque/navigation.h>

#include "tests/bits/bits.h"

namespace bits
{

namespace
{

const char machine_text[] =
    "machine = 'visitor'\n"
    "[variables]\nheard = 0\n"
    "[events]\ncall = 1\n"
    "[states.walks]\ninitial = true\n"
    "enter = [ { go = [-3, 0, 3], speed = 1.4, near = 0.8 } ]\n"
    "transitions = [ { on = 'arrived', to = 'talks' }, { on = 'blocked', to = 'talks' },"
    " { on = 'call', to = 'returns' } ]\n"
    "[states.talks]\n"
    "enter = [ { play = ['stand_look', 'stand_wave'], speed = [0.8, 1.2], fade = 0.3 },"
    " { send = 'call', radius = 2, delay = [1, 3] } ]\n"
    "transitions = [ { on = 'call', to = 'returns', do = [ { set = 'heard', to = 'heard + 1' } ] },"
    " { after = [2, 6], to = 'returns' } ]\n"
    "[states.returns]\n"
    "enter = [ { go = [-3, 0, -3], near = 0.5, heading = 120 } ]\n"
    "transitions = [ { on = 'arrived', to = 'walks' }, { after = 20, to = 'walks' } ]\n";

// A floor of 10 m by 10 m round the origin, and a wall across it with a door of 1 m at its right end.
clq_navigation *room()
{
    static const double floor[] = {-5, 0, -5, -5, 0, 5, 5, 0, 5, 5, 0, -5};
    static const uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
    static const double wall[] = {-5, -0.2, 3.8, -0.2, 3.8, 0.2, -5, 0.2},
                        door[] = {3.8, -0.2, 5, -0.2, 5, 0.2, 3.8, 0.2};
    const clq_prism hole = {4, wall, -1, 3}, opening = {4, door, -1, 3};
    clq_navigation_def def = clq_navigation_def_init();
    clq_navigation *out;
    def.vertex_count = 4, def.vertices = floor, def.triangle_count = 2, def.triangles = triangles;
    def.hole_count = 1, def.holes = &hole, def.door_count = 1, def.doors = &opening;
    check(clq_navigation_create(&def, &out));
    return out;
}

void print_ways(const clq_navigation *navigation)
{
    Hash ways;
    for (int i = 0; i < 20; ++i) {
        const double from[3] = {-4 + 0.4 * i, 0, -4 + 0.17 * i}, to[3] = {4.4 - 0.42 * i, 0, 4 - 0.13 * i};
        double corners[3 * 16];
        clq_way found = clq_way_init();
        check(clq_navigation_find_way(navigation, from, to, 16, corners, &found));
        ways.add(corners, 3 * sizeof(double) * found.point_count);
        ways.add(&found.length, sizeof found.length);
    }
    print("ways", ways);
}

}  // namespace

void stage(clq_context *context)
{
    clq_template *citizen = built(context, "citizen");
    clq_locomotion_def clips = clq_locomotion_def_init();
    clips.tmpl = citizen, clips.walk = clq_template_find_clip(citizen, "walk");
    clq_locomotion *locomotion;
    check(clq_locomotion_create(context, &clips, &locomotion));
    clq_navigation *navigation = room();
    print_ways(navigation);

    clq_crowd *crowd;
    clq_stage *stage;
    check(clq_crowd_create(context, nullptr, &crowd));
    check(clq_stage_create(context, nullptr, &stage));
    const clq_locomotion *const locomotions[] = {locomotion};
    const clq_template *const templates[] = {citizen};
    check(clq_stage_set_navigation(stage, navigation, nullptr, locomotions, 1));
    clq_machine_def machine = clq_machine_def_init();
    machine.source.text = machine_text, machine.source.text_bytes = sizeof machine_text - 1;
    machine.template_count = 1, machine.templates = templates, machine.locomotions = locomotions;
    clq_agent_def agent = clq_agent_def_init();
    check(clq_stage_add_machine(stage, &machine, &agent.machine));
    clq_actor_def actor = clq_actor_def_init();
    actor.tmpl = citizen, agent.tmpl = citizen;
    for (uint32_t i = 0; i < 14; ++i) {
        clq_agent id;
        agent.position[0] = -4 + 0.9 * (i % 7), agent.position[2] = -4 + 1.1 * (i / 7), agent.seed = actor.seed = i;
        check(clq_actor_create(crowd, &actor, &agent.actor));
        check(clq_stage_add_agent(stage, &agent, &id));
    }
    Hash shown;
    for (int tick = 0; tick < 600; ++tick) {
        check(clq_stage_step(stage, 0.05 * tick + 1));
        check(clq_stage_apply(stage, crowd, 0.05 * tick, nullptr));
        check(clq_crowd_update(crowd, 0.05 * tick, nullptr, 0));
        if (tick % 100 == 99) check(clq_navigation_set_door(navigation, 0, tick != 299));
        shown.add(clq_crowd_get_hash(crowd));
    }
    clq_stage_info info = clq_stage_info_init();
    check(clq_stage_get_info(stage, &info));
    Hash decided, saved;
    decided.add(info.hash);
    check(clq_stage_save(stage, Hash::write, &saved));
    print("stage.decided", decided);
    print("stage.shown", shown);
    print("stage.saved", saved);
    clq_stage_destroy(stage), clq_navigation_destroy(navigation);
    check(clq_crowd_destroy(crowd));
    clq_locomotion_destroy(locomotion), clq_template_destroy(citizen);
}

}  // namespace bits
