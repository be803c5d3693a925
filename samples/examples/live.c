/* A live clock with a budget: an update renews at most so many poses, the others wait. Then the instruction sets: all
 * but FMA give the same bits. */
#include <claque/assets.h>

#include "samples/examples/check.h"

enum { ACTORS = 60, BUDGET = 10 };

int main(void)
{
    clq_context *context;
    clq_template *citizen;
    clq_crowd *crowd;
    clq_view *view;
    expect(clq_version() / 100 == CLQ_VERSION / 100, "headers and library are of one version");
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "citizen", &citizen));

    clq_crowd_def crowd_def = clq_crowd_def_init();
    crowd_def.clock = CLQ_CLOCK_LIVE, crowd_def.update_budget = BUDGET;
    crowd_def.period_near_s = crowd_def.period_far_s = 0.1f;
    check(clq_crowd_create(context, &crowd_def, &crowd));
    for (int i = 0; i < ACTORS; ++i) {
        clq_actor actor;
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = citizen, def.seed = (uint64_t)i;
        def.transform.position[0] = i % 10 - 4.5, def.transform.position[2] = -(i / 10);
        def.play.clip = clq_template_find_clip(citizen, "walk");
        check(clq_actor_create(crowd, &def, &actor));
    }
    check(clq_view_create(crowd, &view));
    clq_look_at_def look = clq_look_at_def_init();
    clq_camera camera;
    look.eye[1] = 4, look.eye[2] = 12;
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_set_camera(view, &camera));

    /* The first update has nothing to show, so it poses all, beyond the budget. */
    clq_crowd_stats stats = clq_crowd_stats_init();
    check(clq_crowd_update(crowd, 0.0, &view, 1));
    check(clq_crowd_get_stats(crowd, &stats));
    expect(stats.visible == ACTORS && stats.animated == ACTORS, "everyone is in view and has a pose");
    expect(stats.over_budget == ACTORS - BUDGET, "poses beyond the budget are counted");
    check(clq_crowd_reset_bands(crowd));
    uint32_t deferred = 0, frames = 0;
    uint64_t animated = 0;
    for (; frames < 25; ++frames) {
        check(clq_crowd_update(crowd, 0.04 * (frames + 1), &view, 1));
        check(clq_crowd_get_stats(crowd, &stats));
        expect(stats.animated <= BUDGET, "an update renews no more poses than its budget");
        expect(stats.due == stats.animated + stats.deferred, "the poses that are due are renewed or wait");
        deferred += stats.deferred, animated += stats.animated;
    }
    expect(deferred > 0, "at 600 poses a second in demand and 250 in the budget some wait");
    uint64_t seen = 0, posed = 0;
    for (int band = 0; band < CLQ_DISTANCE_BAND_COUNT; ++band)
        seen += stats.bands[band].actor_frames, posed += stats.bands[band].animated;
    expect(seen == (uint64_t)ACTORS * frames && posed == animated, "the bands add up to the updates");

    const clq_simd widest = clq_simd_get();
    const clq_simd sets[4] = {CLQ_SIMD_SCALAR, CLQ_SIMD_128, CLQ_SIMD_256, CLQ_SIMD_WIDEST};
    uint64_t hashes[4] = {0};
    uint32_t tried = 0;
    for (int i = 0; i < 4; ++i) {
        const clq_status status = clq_simd_set(sets[i]);
        if (status == CLQ_UNSUPPORTED) continue; /* this processor lacks the set */
        check(status);
        expect(clq_simd_get() != CLQ_SIMD_WIDEST, "the set in use has a name of its own");
        clq_crowd *fresh;
        clq_view *fresh_view;
        clq_actor actor;
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = citizen, def.play.clip = clq_template_find_clip(citizen, "cheer");
        check(clq_crowd_create(context, NULL, &fresh));
        check(clq_actor_create(fresh, &def, &actor));
        check(clq_view_create(fresh, &fresh_view));
        check(clq_view_set_camera(fresh_view, &camera));
        check(clq_crowd_update(fresh, 0.7, &fresh_view, 1));
        hashes[tried++] = clq_view_get_hash(fresh_view);
        expect(hashes[tried - 1] == hashes[0] && hashes[0] != 0, "all sets give the same bits");
        clq_crowd_destroy(fresh);
    }
    check(clq_simd_set(widest));
    expect(clq_simd_get() == widest, "the set is as before");

    clq_crowd_destroy(crowd);
    clq_template_destroy(citizen);
    check(clq_context_destroy(context));
    return printf("%u poses waited for a later update; %u instruction sets agree\n", deferred, tried) < 0;
}
