/* Clips and time: markers, events of a watched actor, a fade, a layer that is ended early, a gait, a random choice of a
 * clip, and root motion. The character is a triangle with two clips, built from arrays. */
#include <claque/claque.h>

#include <math.h>

#include "samples/examples/check.h"

/* One triangle that moves by 2 along z in each clip, with a marker in the middle of the clip. */
static clq_template *build(clq_context *context)
{
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const float walk_times[2] = {0, 1}, run_times[2] = {0, 0.5f}, way[6] = {0, 0, 0, 0, 0, 2};
    const clq_zone_def zone = {"all", 0, {1, 1, 1}, {0, 360, 0, 1, 0, 1}};
    clq_node_def node = clq_node_def_init();
    node.name = "hips";
    clq_material_def material = clq_material_def_init();
    material.zone = 0;
    clq_part_def part = clq_part_def_init();
    part.material = 0, part.vertex_count = 3, part.positions = corners;
    clq_channel_def walk = clq_channel_def_init();
    walk.target = CLQ_CHANNEL_TRANSLATION, walk.key_count = 2, walk.times_s = walk_times, walk.values = way;
    clq_channel_def run = walk;
    run.times_s = run_times;
    const clq_clip_def clips[2] = {{"walk", 1, &walk}, {"run", 1, &run}};
    const clq_marker_def markers[2] = {{0, 0.5f, "step"}, {1, 0.25f, "step"}};
    const clq_root_motion_def motion = {0, 0};
    clq_template_def def = clq_template_def_init();
    def.name = "triangle", def.node_count = 1, def.nodes = &node, def.zone_count = 1, def.zones = &zone;
    def.material_count = 1, def.materials = &material, def.part_count = 1, def.parts = &part;
    def.clip_count = 2, def.clips = clips, def.marker_count = 2, def.markers = markers;
    def.root_motion_count = 1, def.root_motions = &motion;
    clq_template *tmpl;
    check(clq_template_build(context, &def, &tmpl));
    return tmpl;
}

static uint32_t count(const clq_event *events, size_t total, clq_event_kind kind)
{
    uint32_t found = 0;
    for (size_t i = 0; i < total; ++i) found += events[i].kind == kind;
    return found;
}

int main(void)
{
    clq_context *context;
    clq_crowd *crowd;
    clq_actor actor;
    check(clq_context_create(NULL, &context));
    clq_template *triangle = build(context);
    check(clq_crowd_create(context, NULL, &crowd));
    clq_actor_def actor_def = clq_actor_def_init();
    actor_def.tmpl = triangle, actor_def.play.clip = 0;
    check(clq_actor_create(crowd, &actor_def, &actor));

    clq_marker_info marker = clq_marker_info_init();
    check(clq_template_get_marker(triangle, 0, &marker));
    expect(marker.clip == 0 && marker.time_s == 0.5f, "marker 0 is in the middle of the walk");

    double moved[3];
    check(clq_template_get_root_motion(triangle, 0, 0.0, 3.0, moved));
    expect(fabs(moved[0]) < 1e-6 && fabs(moved[1] - 6) < 1e-5, "three loops of the walk go 6 along z");

    /* In (0.2, 3.2] the walk passes its marker three times and ends three times. */
    clq_event events[32];
    size_t total;
    const clq_time_range first = {0.2, 3.2};
    check(clq_crowd_get_events(crowd, &first, events, 32, &total));
    expect(total == 0, "an actor that is not watched has no events");
    check(clq_actor_set_watched(crowd, actor, true));
    check(clq_crowd_get_events(crowd, &first, events, 32, &total));
    expect(count(events, total, CLQ_EVENT_MARKER) == 3, "the walk passes its marker three times");
    expect(count(events, total, CLQ_EVENT_CLIP_END) == 3, "and ends three times");
    size_t counted;
    check(clq_crowd_get_events(crowd, &first, NULL, 0, &counted));
    expect(counted == total, "without an array the call only counts");

    /* A gait between the two clips, to which the actor fades at 4 s; the common markers keep the clips in step. */
    clq_gait_def gait_def = clq_gait_def_init();
    gait_def.tmpl = triangle, gait_def.clip_b = 1, gait_def.sync_marker = "step";
    clq_fade_def fade = clq_fade_def_init();
    check(clq_crowd_add_gait(crowd, &gait_def, &fade.gait));
    fade.at_s = 4.0, fade.play.start_s = 4.0;
    check(clq_actor_fade_to(crowd, actor, &fade));
    check(clq_actor_set_gait_share(crowd, actor, 0.5f, 5.0, 1.0f));

    /* A layer that would loop for ever is faded out from 6 s on. */
    clq_layer_def layer_def = clq_layer_def_init();
    layer_def.play.clip = 1, layer_def.play.start_s = 5.0, layer_def.weight = 0.5f;
    clq_layer layer;
    check(clq_actor_add_layer(crowd, actor, &layer_def, &layer));
    check(clq_actor_end_layer(crowd, actor, layer, 6.0, 0.5f));
    const clq_time_range second = {3.2, 8.0};
    check(clq_crowd_get_events(crowd, &second, events, 32, &total));
    expect(count(events, total, CLQ_EVENT_FADE_END) == 1, "the fade ends once");
    expect(count(events, total, CLQ_EVENT_LAYER_END) == 1, "the layer ends once");
    clq_active_clip active[CLQ_ACTIVE_CLIP_MAX];
    uint32_t shown;
    check(clq_actor_get_active_clips(crowd, actor, 5.5, active, &shown));
    expect(shown == 3, "the gait's two clips and the layer are shown");

    const uint32_t choice[2] = {0, 1};
    clq_random_play_def random = clq_random_play_def_init();
    random.clip_count = 2, random.clips = choice, random.speed_spread = 0.1f, random.start_s = 10.0;
    clq_play a, b;
    check(clq_actor_sample_play(crowd, actor, &random, &a));
    check(clq_actor_sample_play(crowd, actor, &random, &b));
    expect(a.clip == b.clip && a.speed == b.speed && a.start_s == 10.0, "equal sample indices give equal plays");
    expect(fabsf(a.speed - 1) <= 0.1f, "the speed is within its spread");
    check(clq_actor_play(crowd, actor, &a));

    clq_crowd_destroy(crowd);
    clq_template_destroy(triangle);
    check(clq_context_destroy(context));
    return printf("%u events, then %u; %s at %.2f times its speed\n", (unsigned)counted, (unsigned)total,
                  a.clip ? "run" : "walk", (double)a.speed) < 0;
}
