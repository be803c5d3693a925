/* Ground and root paths: a herald flies round its Reference Point on a closed curve, another one walks over a hill, and
 * both carry an object of the host. */
#include <claque/assets.h>

#include <math.h>

#include "samples/examples/check.h"

static double hill(void *user, const double point[3])
{
    *(uint32_t *)user += 1;
    return point[0] > 1000 ? NAN : 0.25 * point[0]; /* no ground beyond x = 1000 */
}

int main(void)
{
    clq_context *context;
    clq_template *herald;
    clq_crowd *crowd;
    clq_view *view;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "herald", &herald));
    check(clq_crowd_create(context, NULL, &crowd));
    check(clq_view_create(crowd, &view));
    clq_look_at_def look = clq_look_at_def_init();
    clq_camera camera;
    look.eye[2] = 30, look.eye[1] = 2;
    check(clq_camera_look_at(&look, &camera));
    check(clq_view_set_camera(view, &camera));

    clq_actor walker, flyer;
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = herald, def.transform.position[0] = 4;
    check(clq_actor_create(crowd, &def, &walker));
    def.transform.position[0] = -4;
    def.play.clip = clq_template_find_clip(herald, "fly");
    check(clq_actor_create(crowd, &def, &flyer));

    /* The hill is 1 high at x = 4. */
    uint32_t asked = 0;
    clq_actor_info info = clq_actor_info_init();
    check(clq_crowd_set_ground(crowd, hill, &asked));
    check(clq_actor_follow_ground(crowd, walker, 5.0f, 5.0f));
    check(clq_crowd_update(crowd, 0.0, &view, 1));
    check(clq_actor_get_info(crowd, walker, &info));
    expect(asked == 1, "the height is asked for the one actor that follows the ground");
    expect(info.visible && fabs(info.root.position[1] - 1) < 1e-5, "its Skeleton Root is on the hill");
    check(clq_actor_follow_ground(crowd, walker, 0.5f, 0.5f));
    check(clq_crowd_update(crowd, 0.1, &view, 1));
    check(clq_actor_get_info(crowd, walker, &info));
    expect(fabs(info.root.position[1] - 0.5) < 1e-5, "it climbs by max_up at most");
    check(clq_crowd_set_ground(crowd, NULL, NULL));
    check(clq_crowd_update(crowd, 0.2, &view, 1));
    check(clq_actor_get_info(crowd, walker, &info));
    expect(fabs(info.root.position[1]) < 1e-6, "without a ground it is at its Reference Point");

    /* A flight through four points, 3 from the Reference Point, one lap in 8 s. */
    check(clq_actor_get_info(crowd, flyer, &info));
    const float before = info.refpoint_radius;
    const float points[12] = {3, 1, 0, 0, 1, 3, -3, 1, 0, 0, 1, -3};
    clq_root_path_def path = clq_root_path_def_init();
    clq_root_path_play lap = clq_root_path_play_init();
    path.count = 4, path.positions = points, path.duration_s = 8;
    check(clq_crowd_add_root_path(crowd, &path, &lap.path));
    check(clq_actor_play_root_path(crowd, flyer, &lap));
    check(clq_crowd_update(crowd, 2.0, &view, 1)); /* a quarter of the lap: the second point */
    check(clq_actor_get_info(crowd, flyer, &info));
    expect(fabs(info.root.position[0] + 4) < 1e-3 && fabs(info.root.position[2] - 3) < 1e-3, "it is at (-4, 1, 3)");
    expect(info.refpoint_radius > before + 2, "its Refpoint Bsphere holds the path");

    /* A staff of 4 m in its hand: the spheres grow to hold it, and shrink when it is dropped. */
    clq_attachment_def staff_def = clq_attachment_def_init();
    staff_def.node = clq_template_find_node(herald, "arm_right");
    expect(staff_def.node != CLQ_NONE, "the herald has a right arm");
    staff_def.radius = 2;
    clq_attachment staff;
    const float empty = info.sklsroot_radius;
    check(clq_actor_attach(crowd, flyer, &staff_def, &staff));
    check(clq_actor_get_info(crowd, flyer, &info));
    expect(info.sklsroot_radius >= 2 && info.sklsroot_radius > empty, "the Sklsroot Bsphere holds the staff");
    double shown[16], later[16];
    check(clq_actor_get_node(crowd, flyer, staff_def.node, NAN, shown));
    check(clq_actor_get_node(crowd, flyer, staff_def.node, 6.0, later));
    expect(fabs(shown[14] - 3) < 1 && fabs(later[14] + 3) < 1, "half a lap later the staff is on the other side");
    check(clq_actor_detach(crowd, staff));
    expect(clq_actor_detach(crowd, staff) == CLQ_STALE_ID, "an attachment ends once");
    check(clq_actor_get_info(crowd, flyer, &info));
    expect(info.sklsroot_radius == empty, "the sphere is as before");

    clq_crowd_destroy(crowd);
    clq_template_destroy(herald);
    check(clq_context_destroy(context));
    return printf("the staff was at z = %.2f, then at z = %.2f\n", shown[14], later[14]) < 0;
}
