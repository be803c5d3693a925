#include "lib/frame/node_matrix.h"

#include "lib/frame/posed_at.h"
#include "lib/math/eye_transform.h"

namespace claque::frame
{

void node_world_matrix(const crowd::Crowd &crowd, const Frame &frame, uint32_t row, uint32_t node, double time_s,
                       double out_matrix[16])
{
    const model::Template &tmpl = crowd.template_of(row);
    const ActorVisibility visibility = frame.visibility(crowd, row);
    const bool shown = time_s != time_s, seen = shown && visibility.visible;
    const double tick_s = !shown ? time_s : visibility.visible ? visibility.shown_s : frame.last_time_s();
    const model::Level &level = tmpl.levels[seen ? visibility.level : 0];
    const behave::MechanismLevels levels =
        seen ? frame.mechanism_levels(crowd, row, level) : behave::mechanism_levels(crowd, row, 0, level);
    PosedAt posed(tmpl, crowd.memory());
    posed.pose(crowd, row, level, levels, tick_s, visibility.distance * frame.settings().caches.metres_per_unit);

    crowd::Transform root;
    if (!shown || !frame.root_of(crowd, row, root)) root = root_at(crowd, row, shown ? frame.last_time_s() : time_s);
    const glm::dmat3 axes = math::rotation_of(root.orientation) * double(root.scale);
    for (int k = 0; k < 4; ++k) {
        const math::F4 &c = posed.node(node).c[k];
        const glm::dvec3 column = axes * glm::dvec3(c[0], c[1], c[2]) + (k == 3 ? root.position : glm::dvec3(0));
        for (int i = 0; i < 3; ++i) out_matrix[4 * k + i] = column[i];
        out_matrix[4 * k + 3] = k == 3 ? 1 : 0;
    }
}

}  // namespace claque::frame
