#include <claque/group.h>

#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"

using namespace claque;

namespace
{

// Scales of a group and its members multiply: both being sane keeps the product a number.
crowd::Place group_place(const clq_place *place)
{
    if (!place) return crowd::Place();
    const double size = std::fabs(static_cast<double>(place->scale));
    if (place->scale != 0 && !(size >= 1e-6 && size <= 1e6))
        base::fail(CLQ_ARGUMENT, "the scale of a group is %g: 1e-6 to 1e6, or its negative, is wanted",
                   static_cast<double>(place->scale));
    return api::place_of(*place);
}

}  // namespace

extern "C" {

clq_status clq_group_create(clq_crowd *crowd, const clq_place *place, clq_group *out)
{
    return api::boundary("clq_group_create", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        const api::Busy busy(crowd);
        const crowd::Id id = crowd->crowd.create_group(group_place(place));
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

clq_status clq_group_place(clq_crowd *crowd, clq_group group, const clq_place *place)
{
    return api::boundary("clq_group_place", [&] {
        api::require(crowd && place, "crowd or place is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.place_group(api::id_of(group), group_place(place));
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

clq_status clq_actor_join(clq_crowd *crowd, clq_actor actor, clq_group group, const clq_place *place)
{
    return api::boundary("clq_actor_join", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        const crowd::Place wanted = place ? api::place_of(*place) : crowd::Place();
        crowd->crowd.join(api::id_of(actor), api::id_of(group), place ? &wanted : nullptr);
    });
}

clq_status clq_group_get_info(const clq_crowd *crowd, clq_group group, clq_group_info *out)
{
    return api::boundary("clq_group_get_info", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        const uint32_t row = crowd->crowd.group_row_of(api::id_of(group));
        const crowd::Group &found = crowd->crowd.group(row);
        clq_group_info info{};
        info.place = api::place_of(found.place);
        info.member_count = found.members;
        info.enabled = found.enabled;
        info.visible = crowd->frame.group_seen(crowd->crowd, row);
        *out = info;
    });
}

}  // extern "C"
