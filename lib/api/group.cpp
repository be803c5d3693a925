#include <claque/group.h>

#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"

using namespace claque;

namespace
{

// Scales of a group and its members multiply: both being sane keeps the product a number.
crowd::Transform group_transform(const clq_transform *transform)
{
    if (!transform) return crowd::Transform();
    const double size = std::fabs(static_cast<double>(transform->scale));
    if (transform->scale != 0 && !(size >= 1e-6 && size <= 1e6))
        base::fail(CLQ_ARGUMENT, "the scale of a group is %g: 1e-6 to 1e6, or its negative, is wanted",
                   static_cast<double>(transform->scale));
    return api::transform_of(*transform);
}

}  // namespace

extern "C" {

clq_status clq_group_create(clq_crowd *crowd, const clq_transform *transform, clq_group *out)
{
    return api::boundary("clq_group_create", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        const api::Busy busy(crowd);
        const crowd::Id id = crowd->crowd.create_group(group_transform(transform));
        *out = {id.index1, id.generation};
    });
}

clq_status clq_group_destroy(clq_crowd *crowd, clq_group group)
{
    return api::boundary("clq_group_destroy", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.destroy_group(api::id_of(group));
    });
}

clq_status clq_group_set_transform(clq_crowd *crowd, clq_group group, const clq_transform *transform)
{
    return api::boundary("clq_group_set_transform", [&] {
        api::require(crowd && transform, "crowd or transform is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.set_group_transform(api::id_of(group), group_transform(transform));
    });
}

clq_status clq_group_enable(clq_crowd *crowd, clq_group group, int32_t enabled)
{
    return api::boundary("clq_group_enable", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.enable_group(api::id_of(group), enabled != 0);
    });
}

clq_status clq_actor_join(clq_crowd *crowd, clq_actor actor, clq_group group, const clq_transform *transform)
{
    return api::boundary("clq_actor_join", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        const crowd::Transform wanted = transform ? api::transform_of(*transform) : crowd::Transform();
        crowd->crowd.join(api::id_of(actor), api::id_of(group), transform ? &wanted : nullptr);
    });
}

clq_status clq_group_get_info(const clq_crowd *crowd, clq_group group, clq_group_info *out)
{
    return api::boundary("clq_group_get_info", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        const uint32_t row = crowd->crowd.group_row_of(api::id_of(group));
        const crowd::Group &found = crowd->crowd.group(row);
        clq_group_info info{};
        info.transform = api::transform_of(found.transform);
        info.member_count = found.members;
        info.enabled = found.enabled;
        info.visible = crowd->frame.group_visible(crowd->crowd, row);
        *out = info;
    });
}

}  // extern "C"
