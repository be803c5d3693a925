#include "samples/labels/rest_pose.h"

namespace labels
{

using scenes::check;

RestPose::RestPose(scenes::Library &library, const clq_template *tmpl)
{
    clq_crowd_def crowd_def = clq_crowd_def_init();
    crowd_def.period_near_s = crowd_def.period_far_s = crowd_def.lod_scale = 0;
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(library.context(), &crowd_def, &crowd));
    crowd_.reset(crowd);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = const_cast<clq_template *>(tmpl);
    def.play.clip = CLQ_NONE;
    check(clq_actor_create(crowd, &def, &actor_));
}

std::array<double, 16> RestPose::node(uint32_t node) const
{
    std::array<double, 16> m;
    check(clq_actor_get_node(crowd_.get(), actor_, node, 0, m.data()));
    return m;
}

std::vector<float> RestPose::vertices() const
{
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(crowd_.get(), actor_, &info));
    const double away = 4 * static_cast<double>(info.refpoint_radius);  // a sphere round the origin
    clq_look_at_def look = clq_look_at_def_init();
    look.target[2] = 0, look.eye[2] = away;
    look.z_near = static_cast<float>(away / 100), look.z_far = static_cast<float>(4 * away);
    clq_camera camera = {};
    check(clq_camera_look_at(&look, &camera));
    clq_view *view = nullptr;
    check(clq_view_create(crowd_.get(), &view));
    check(clq_view_set_camera(view, &camera));
    check(clq_crowd_update(crowd_.get(), 0, &view, 1));
    clq_drawn_actor drawn = clq_drawn_actor_init();
    check(clq_view_get_drawn_actor(view, 0, &drawn));
    std::vector<float> xyz(3 * static_cast<size_t>(drawn.vertex_count));
    check(clq_view_get_vertices(view, 0, xyz.data(), nullptr, drawn.vertex_count));
    return xyz;
}

}  // namespace labels
