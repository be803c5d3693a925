// Groups, and the actors that join and leave them.
#include <claque/group.h>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/recorder.h"

using namespace claque;

namespace
{

crowd::Transform group_transform(const clq_transform *transform)
{
    return transform ? api::transform_of(*transform) : crowd::Transform();
}

}  // namespace

extern "C" {

clq_status clq_group_create(clq_crowd *crowd, const clq_transform *transform, clq_group *out)
{
    return api::boundary("clq_group_create", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        const api::Busy busy(crowd);
        const crowd::Id id = crowd::create_group(crowd->crowd, group_transform(transform));
        const record::GroupCreate made{transform != nullptr, api::place_or_none(transform), {id.index1, id.generation}};
        *out = made.made;
        api::changed(crowd, made);
    });
}

clq_status clq_group_destroy(clq_crowd *crowd, clq_group group)
{
    return api::boundary("clq_group_destroy", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::destroy_group(crowd->crowd, api::id_of(group));
        api::changed(crowd, record::GroupDestroy{group});
    });
}

clq_status clq_group_set_transform(clq_crowd *crowd, clq_group group, const clq_transform *transform)
{
    return api::boundary("clq_group_set_transform", [&] {
        api::require(crowd && transform, "crowd or transform is NULL");
        const api::Busy busy(crowd);
        crowd::set_group_transform(crowd->crowd, api::id_of(group), group_transform(transform));
        api::changed(crowd, record::GroupSetTransform{group, *transform});
    });
}

clq_status clq_group_set_enabled(clq_crowd *crowd, clq_group group, bool enabled)
{
    return api::boundary("clq_group_set_enabled", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::enable_group(crowd->crowd, api::id_of(group), enabled);
        api::changed(crowd, record::GroupSetEnabled{group, enabled});
    });
}

clq_status clq_actor_join(clq_crowd *crowd, clq_actor actor, clq_group group, const clq_transform *transform)
{
    return api::boundary("clq_actor_join", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        const crowd::Transform wanted = transform ? api::transform_of(*transform) : crowd::Transform();
        crowd::join(crowd->crowd, api::id_of(actor), api::id_of(group), transform ? &wanted : nullptr);
        api::changed(crowd, record::ActorJoin{actor, group, transform != nullptr, api::place_or_none(transform)});
    });
}

clq_status clq_group_get_info(const clq_crowd *crowd, clq_group group, clq_group_info *out)
{
    return api::boundary("clq_group_get_info", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        api::require_size(*out, "clq_group_info_init");
        const api::Reading reading(crowd);
        const uint32_t row = crowd->crowd.group_row_of(api::id_of(group));
        const crowd::Group &found = crowd->crowd.group(row);
        clq_group_info info = clq_group_info_init();
        info.transform = api::transform_of(found.transform);
        info.member_count = found.members;
        info.enabled = found.enabled;
        info.visible = crowd->frame.group_visible(crowd->crowd, row);
        api::write_out(out, info);
    });
}

}  // extern "C"
