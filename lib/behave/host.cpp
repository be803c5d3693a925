// Calls mechanisms of the host.
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

void run(const crowd::HostMechanism &host, const Call &call, Writer &writer) noexcept
{
    const crowd::Id id = call.crowd.id_of(call.row);
    clq_behaviour_call told{};
    told.actor = {id.index1, id.generation};
    told.level = call.level;
    told.seed = call.crowd.actor(call.row).seed;
    told.time_s = call.context.time_s;
    told.eye_distance_m = call.context.distance_m;
    told.visible = call.context.visible;
    base::HostCalls alone;
    base::HostCalls &calls = call.context.host_calls ? *call.context.host_calls : alone;
    calls.run("the run of a host mechanism", id.index1, [&] { host.run(host.user, &told, &writer); });
}

}  // namespace claque::behave
