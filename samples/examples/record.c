/* Recording a run and playing it back: people who come, walk and nod are recorded while the host runs. The record then
 * shows the same in another crowd, from any moment on. */
#include <claque/assets.h>

#include <math.h>

#include "samples/examples/check.h"

enum { STEPS = 50 };

typedef struct buffer {
    unsigned char bytes[1 << 20];
    size_t size;
} buffer;

static int append(void *user, const void *bytes, size_t size_bytes)
{
    buffer *out = user;
    if (size_bytes > sizeof out->bytes - out->size) return 1;
    memcpy(out->bytes + out->size, bytes, size_bytes);
    out->size += size_bytes;
    return 0;
}

/* Code of the host: a record holds its number, but not what it does. */
static void nod(void *user, const clq_behaviour_call *call, clq_dof_writer *writer)
{
    clq_dof_write(writer, *(const uint32_t *)user, 0.2f * (float)sin(3 * call->time_s), 1);
}

static clq_view *eye_on(clq_crowd *crowd)
{
    clq_view *view;
    clq_camera camera;
    clq_look_at_def look = clq_look_at_def_init();
    look.eye[1] = 2, look.eye[2] = 8, look.target[1] = 1;
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_create(crowd, &view));
    check(clq_view_set_camera(view, &camera));
    return view;
}

int main(void)
{
    static buffer file;
    static uint64_t shown[STEPS];
    clq_context *context;
    clq_template *citizen;
    clq_crowd *crowd, *again;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "citizen", &citizen));
    uint32_t neck = clq_template_find_dof(citizen, "neck_pitch");
    clq_crowd_def crowd_def = clq_crowd_def_init();
    crowd_def.seed = 7;
    check(clq_crowd_create(context, &crowd_def, &crowd));

    /* The host's run: two lines more than without a record, one at each end. */
    clq_recording_def recording = clq_recording_def_init();
    recording.write = append, recording.user = &file;
    check(clq_crowd_begin_recording(crowd, &recording));
    clq_actor actor = {0, 0};
    clq_mechanism nodding = {0};
    clq_view *view = eye_on(crowd);
    for (int step = 0; step < STEPS; ++step) {
        if (step % 10 == 0) {
            clq_actor_def def = clq_actor_def_init();
            def.tmpl = citizen, def.seed = (uint64_t)step;
            def.transform.position[0] = step * 0.1 - 2;
            def.play.clip = clq_template_find_clip(citizen, "walk");
            check(clq_actor_create(crowd, &def, &actor));
            check(clq_actor_randomise_colours(crowd, actor, NULL, 0));
        }
        if (step == 25) {
            clq_mechanism_def def = clq_mechanism_def_init();
            def.kind = CLQ_MECHANISM_HOST, def.tmpl = citizen, def.host.run = nod, def.host.user = &neck;
            check(clq_crowd_add_mechanism(crowd, &def, &nodding));
            clq_mechanism_attachment use = clq_mechanism_attachment_init();
            use.mechanism = nodding;
            check(clq_actor_attach_mechanism(crowd, actor, &use));
        }
        check(clq_crowd_update(crowd, step * 0.04, &view, 1));
        shown[step] = clq_view_get_hash(view);
    }
    clq_recording_info written = clq_recording_info_init();
    check(clq_crowd_get_recording(crowd, &written));
    expect(written.status == CLQ_OK && written.steps == STEPS, "every update is a step of the record");
    check(clq_crowd_end_recording(crowd, &written));
    expect(written.bytes == file.size, "the writer took all of it");

    /* Another host, later: it makes a crowd like the recorded one, and supplies templates and code. */
    clq_record *record;
    check(clq_record_load(context, file.bytes, file.size, &record));
    clq_record_info info = clq_record_info_init();
    check(clq_record_get_info(record, &info));
    expect(info.template_count == 1 && strcmp(clq_record_get_template_name(record, 0), "citizen") == 0,
           "the record says which templates it needs");
    check(clq_record_set_templates(record, &citizen, 1));
    const clq_host_mechanism_def lent = {nod, &neck, false};
    check(clq_record_lend_mechanism(record, nodding, &lent));
    check(clq_record_get_crowd_def(record, &crowd_def));
    check(clq_crowd_create(context, &crowd_def, &again));
    view = eye_on(again);
    for (int k = 0; k < STEPS; ++k) {
        const uint64_t step = (uint64_t)(k * 37 % STEPS); /* in any order */
        double time_s;
        check(clq_record_get_time(record, step, &time_s));
        check(clq_record_play_step(record, again, step));
        check(clq_crowd_update(again, time_s, &view, 1));
        expect(clq_view_get_hash(view) == shown[step], "each step shows what was shown");
    }
    check(clq_record_play(record, again, 1.0));
    expect(clq_crowd_get_actor_count(again) == 3, "after one second three people had come");

    clq_record_destroy(record);
    check(clq_crowd_destroy(again));
    check(clq_crowd_destroy(crowd));
    clq_template_destroy(citizen);
    check(clq_context_destroy(context));
    return printf("%d steps in %u bytes, played back in another order\n", STEPS, (unsigned)file.size) < 0;
}
