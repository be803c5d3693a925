// Sets the data that only some actors have: attached objects, callbacks, the ground under them.
#include "lib/crowd/extras.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/rows.h"

namespace claque::crowd
{

using base::fail;
using model::none;

void check_attached(const model::Template &tmpl, const Attachment &attached)
{
    if (attached.node >= tmpl.rig.node_count())
        fail(CLQ_ARGUMENT, "node %u does not exist: there are %u in template '%s'", attached.node,
             tmpl.rig.node_count(), tmpl.name.c_str());
    const glm::vec3 &centre = attached.sphere.centre;
    const float radius = attached.sphere.radius;
    const bool finite = std::isfinite(centre.x) && std::isfinite(centre.y) && std::isfinite(centre.z);
    if (!finite || !(radius >= 0) || !std::isfinite(radius))
        fail(CLQ_ARGUMENT, "an attached object's sphere has radius %g or a centre that is not finite",
             static_cast<double>(radius));
}

// The order is that of the slots, whatever was attached first: a crowd that is restored frees them in the same order,
// so that later objects get the same ids. The latest slot comes first, so most are linked in one step.
void link_attached(Extra &extra, base::SlotMap<Attachment> &all, uint32_t index) noexcept
{
    uint32_t *link = &extra.first_attached;
    while (*link != none && *link > index) link = &all[*link].next;
    all[index].next = *link;
    *link = index;
}

Id attach(Crowd &crowd, Id id, uint32_t node, const model::Sphere &sphere)
{
    const uint32_t row = crowd.row_of(id);
    const Attachment attached{row, none, node, sphere};
    check_attached(crowd.template_of(row), attached);
    base::SlotMap<Attachment> &all = crowd.tables.extras.attached;
    all.reserve();
    Extra &extra = make_extra(crowd.tables, row);
    const uint32_t index = all.take();
    all[index] = attached;
    link_attached(extra, all, index);
    measure(crowd, row);
    return all.id_of(index);
}

void detach(Crowd &crowd, Id id)
{
    Extras &extras = crowd.tables.extras;
    const uint32_t index = extras.attached.find(id);
    if (index == base::no_slot)
        fail(CLQ_STALE_ID, "no attached object has index %u and generation %u", id.index1, id.generation);
    const uint32_t row = extras.attached[index].row;
    uint32_t *link = &extras.all[extras.of[row]].first_attached;
    while (*link != index) link = &extras.attached[*link].next;
    *link = extras.attached[index].next;
    extras.attached.free(index);
    measure(crowd, row);
}

void set_hooks(Crowd &crowd, Id id, const clq_actor_hooks &hooks)
{
    const uint32_t row = crowd.row_of(id);
    if (!hooks.before && !hooks.after && !crowd.extra_of(row)) return;
    make_extra(crowd.tables, row).hooks = hooks;
}

void follow_ground(Crowd &crowd, Id id, float max_up, float max_down)
{
    const uint32_t row = crowd.row_of(id);
    if (!(max_up >= 0) || !(max_down >= 0) || !std::isfinite(max_up) || !std::isfinite(max_down))
        fail(CLQ_ARGUMENT, "an actor follows the ground %g up and %g down: 0 or more is wanted",
             static_cast<double>(max_up), static_cast<double>(max_down));
    Extra &extra = make_extra(crowd.tables, row);
    extra.max_up = max_up, extra.max_down = max_down;
    measure(crowd, row);
}

void set_ground(Crowd &crowd, double (*height)(void *user, const double point[3]), void *user)
{
    crowd.ground_height = height;
    crowd.ground_data = user;
}

}  // namespace claque::crowd
