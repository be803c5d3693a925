// How fast the host moves actors and groups.
#include <claque/speed.h>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/recorder.h"

using namespace claque;

extern "C" {

clq_status clq_crowd_set_speeds(clq_crowd *crowd, const clq_actor *actors, const float *speeds, uint32_t count)
{
    return api::boundary("clq_crowd_set_speeds", [&] {
        api::require(crowd && ((actors && speeds) || count == 0), "crowd, actors or speeds is NULL");
        const api::Busy busy(crowd);
        crowd::set_speeds(crowd->crowd, api::ids_of(crowd, actors, count), speeds, count);
        api::changed_by(crowd, [&](api::Recorder &to) { to.speeds(actors, speeds, count); });
    });
}

clq_status clq_group_set_speed(clq_crowd *crowd, clq_group group, float speed)
{
    return api::boundary("clq_group_set_speed", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::set_group_speed(crowd->crowd, api::id_of(group), speed);
        api::changed(crowd, record::GroupSetSpeed{group, speed});
    });
}

}  // extern "C"
