/* Control mechanisms: a winged herald looks at a point, smiles, blinks, says a phrase, and its wing is moved by the
 * host. Each effect is read off the matrix of a node. At the end the mechanisms are detached again. */
#include <claque/assets.h>

#include <math.h>

#include "samples/examples/check.h"

static clq_crowd *crowd;
static clq_template *herald;
static clq_actor actor;

static uint32_t dof(const char *name)
{
    const uint32_t found = clq_template_find_dof(herald, name);
    expect(found != CLQ_NONE, "the herald has this degree of freedom");
    return found;
}

static clq_mechanism add(const clq_mechanism_def *def, float priority)
{
    clq_mechanism_attachment attachment = clq_mechanism_attachment_init();
    attachment.priority = priority;
    check(clq_crowd_add_mechanism(crowd, def, &attachment.mechanism));
    check(clq_actor_attach_mechanism(crowd, actor, &attachment));
    return attachment.mechanism;
}

/* How far a node differs between two times, as the largest difference of an element of its matrices. */
static double change(const char *node, double before_s, double after_s)
{
    double a[16], b[16], most = 0;
    check(clq_actor_get_node(crowd, actor, clq_template_find_node(herald, node), before_s, a));
    check(clq_actor_get_node(crowd, actor, clq_template_find_node(herald, node), after_s, b));
    for (int i = 0; i < 16; ++i) most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

static uint32_t wing_dof, calls;

static void flap(void *user, const clq_behaviour_call *call, clq_dof_writer *writer)
{
    (void)user, ++calls;
    clq_dof_write(writer, wing_dof, (float)sin(call->time_s), 1.0f);
}

int main(void)
{
    clq_context *context;
    clq_view *view;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "herald", &herald));
    check(clq_crowd_create(context, NULL, &crowd));
    clq_actor_def actor_def = clq_actor_def_init();
    actor_def.tmpl = herald; /* it plays no clip: only mechanisms move it */
    check(clq_actor_create(crowd, &actor_def, &actor));

    clq_mechanism_def def = clq_mechanism_def_init();
    def.tmpl = herald, def.kind = CLQ_MECHANISM_GAZE;
    def.gaze.neck_yaw = dof("neck_yaw"), def.gaze.neck_pitch = dof("neck_pitch");
    const clq_mechanism gaze = add(&def, 0);
    const double left[3] = {10, 1, 10};
    check(clq_actor_gaze(crowd, actor, gaze, left, 1.0));
    expect(change("neck", 0, 1) < 1e-6, "before the command the herald looks straight ahead");
    expect(change("neck", 1, 3) > 0.1, "after the command its neck has turned");

    const clq_dof_value raised[] = {{dof("brow"), 0.012f}};
    const clq_dof_pose faces[] = {{0, NULL}, {1, raised}};
    def.kind = CLQ_MECHANISM_EXPRESSION;
    def.expression.pose_count = 2, def.expression.poses = faces;
    const clq_mechanism expression = add(&def, 0);
    check(clq_actor_express(crowd, actor, expression, 0, 0.0));
    check(clq_actor_express(crowd, actor, expression, 1, 4.0));
    const double brow = change("brow", 3.9, 6);
    expect(brow > 0.011 && brow < 0.0125, "the brow rises by 12 mm");

    const clq_dof_value shut[] = {{dof("lids"), 1}}, open_mouth[] = {{dof("jaw"), 0.3f}};
    def.kind = CLQ_MECHANISM_BLINK, def.blink.closed.count = 1, def.blink.closed.values = shut;
    add(&def, 0);
    int blinks = 0;
    for (int i = 0; i < 800; ++i) blinks += change("lids", 4 + 0.01 * i, 4.01 + 0.01 * i) > 0.01;
    expect(blinks > 0, "the herald blinks every four seconds");

    const clq_dof_pose ah = {1, open_mouth};
    const clq_phrase_key keys[] = {{0, 0}, {0.5f, CLQ_NONE}};
    def.kind = CLQ_MECHANISM_PHRASE, def.phrase.pose_count = 1, def.phrase.poses = &ah;
    def.phrase.key_count = 2, def.phrase.keys = keys, def.phrase.length_s = 0.6f, def.phrase.pause_s = -1;
    const clq_mechanism phrase = add(&def, 1);
    check(clq_actor_say(crowd, actor, phrase, 8.0));
    expect(change("jaw", 3, 7.9) < 1e-6, "the mouth rests until the command");
    expect(change("jaw", 7.9, 8.3) > 0.2, "then it opens");
    expect(change("jaw", 7.9, 9.5) < 1e-6, "and closes after the phrase");

    wing_dof = dof("wing_left_flap");
    def.kind = CLQ_MECHANISM_HOST, def.host.run = flap;
    const clq_mechanism wing = add(&def, 2);
    clq_camera camera;
    clq_look_at_def look = clq_look_at_def_init();
    look.eye[2] = 200;
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_create(crowd, &view));
    check(clq_view_set_camera(view, &camera));
    clq_actor_info far_info = clq_actor_info_init(), near_info = clq_actor_info_init();
    check(clq_crowd_update(crowd, 10.0, &view, 1));
    check(clq_actor_get_info(crowd, actor, &far_info));
    check(clq_actor_set_priority(crowd, actor, 1.0f)); /* the finest level at any distance */
    check(clq_crowd_update(crowd, 11.0, &view, 1));
    check(clq_actor_get_info(crowd, actor, &near_info));
    expect(far_info.level > 0 && near_info.level == 0, "priority 1 brings the finest level");
    expect(calls == 2, "the host's mechanism was called in both updates");
    check(clq_actor_detach_mechanism(crowd, actor, wing));
    check(clq_actor_detach_mechanism(crowd, actor, gaze));
    check(clq_crowd_update(crowd, 12.0, &view, 1));
    expect(calls == 2, "a mechanism that is detached is not called");
    expect(change("neck", 0, 3) < 1e-6, "without the gaze mechanism the neck stays at rest");

    clq_template_destroy(herald);
    clq_crowd_destroy(crowd);
    check(clq_context_destroy(context));
    return puts("gaze, face, lids, mouth and wing moved") < 0;
}
