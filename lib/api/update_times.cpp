// Times of the steps of an update.
#include <claque/update_times.h>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"

using namespace claque;

extern "C" {

clq_status clq_crowd_set_step_clock(clq_crowd *crowd, double (*now_s)(void *user), void *user)
{
    return api::boundary("clq_crowd_set_step_clock", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd->frame.set_step_clock({now_s, user, crowd->context->log});
    });
}

clq_status clq_crowd_get_update_times(const clq_crowd *crowd, clq_update_times *out)
{
    return api::boundary("clq_crowd_get_update_times", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        api::require_size(*out, "clq_update_times_init");
        const api::Reading reading(crowd);
        const frame::StepTimes &times = crowd->frame.step_times();
        clq_update_times result = clq_update_times_init();
        result.measured = times.measured;
        double *const places[frame::step_count] = {&result.cull_s,    &result.choose_s,     &result.behave_s,
                                                   &result.animate_s, &result.cull_parts_s, &result.skin_s,
                                                   &result.list_s};
        for (size_t step = 0; step < frame::step_count; ++step) *places[step] = times.seconds[step];
        api::write_out(out, result);
    });
}

}  // extern "C"
