#include "samples/scenes/roles/gaze.h"

namespace scenes::roles
{

// An actor in a crowd of its own says where the eyes are.
clq_gaze_def gaze_of(Library &library, clq_template *tmpl, const Faces &faces)
{
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(library.context(), nullptr, &crowd));
    const Own<clq_crowd> held(crowd);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = tmpl;
    clq_actor actor = {};
    check(clq_actor_create(crowd, &def, &actor));
    double sum[3] = {0, 0, 0};
    for (const uint32_t node : faces.eyes) {
        double m[16];
        check(clq_actor_get_node(crowd, actor, node, 0, m));
        for (int k = 0; k < 3; ++k) sum[k] += m[12 + k];
    }
    clq_gaze_def gaze = faces.gaze;
    for (int k = 0; k < 3; ++k) gaze.eyes[k] = static_cast<float>(sum[k] / static_cast<double>(faces.eyes.size()));
    return gaze;
}

}  // namespace scenes::roles
