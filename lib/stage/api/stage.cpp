// clq_stage: making, stepping, applying.
#include <claque/stage.h>

#include <cmath>
#include <memory>

#include "lib/stage/api/boundary.h"
#include "lib/stage/api/stage_handle.h"

using namespace claque;
using stage::fail;

namespace claque::stage
{

void require_finite(double number, const char *what)
{
    if (!std::isfinite(number)) fail(CLQ_ARGUMENT, "%s is not finite", what);
}

void require_place(const double position[3])
{
    for (int k = 0; k < 3; ++k)
        if (!(std::fabs(position[k]) <= 1e12)) fail(CLQ_ARGUMENT, "position[%d] is %g", k, position[k]);
}

uint32_t index_of(const Director &director, clq_agent agent)
{
    if (agent.index1 == 0 || agent.index1 > director.agents.size() || director.agents[agent.index1 - 1].is_removed)
        fail(CLQ_STALE_ID, "there is no agent %u", agent.index1);
    return agent.index1 - 1;
}

}  // namespace claque::stage

namespace
{

void check_stage_def(const clq_stage_def &def)
{
    unsigned mode;
    std::memcpy(&mode, &def.mode, sizeof mode);
    if (mode > CLQ_STAGE_LIVE) fail(CLQ_ARGUMENT, "mode is %u: 0 and 1 are known", mode);
    if (!(std::fabs(def.start_s) <= 1e9)) fail(CLQ_ARGUMENT, "start_s is %g: -1e9 to 1e9 is wanted", def.start_s);
    if (!(def.tick_s >= 0.001 && def.tick_s <= 10))
        fail(CLQ_ARGUMENT, "tick_s is %g: 0.001 to 10 is wanted", def.tick_s);
    if (!(def.budget_us >= 0 && std::isfinite(def.budget_us)))
        fail(CLQ_ARGUMENT, "budget_us is %g: 0 or more is wanted", double(def.budget_us));
    if (mode == CLQ_STAGE_LIVE && def.budget_us > 0 && !def.now_s)
        fail(CLQ_ARGUMENT, "a live budget of %g microseconds needs the clock now_s", double(def.budget_us));
    double total = 0;
    for (int c = 0; c < CLQ_STAGE_CLASS_COUNT; ++c) {
        if (!(def.shares[c] > 0)) fail(CLQ_ARGUMENT, "shares[%d] is %g: above 0 is wanted", c, double(def.shares[c]));
        total += double(def.shares[c]);
    }
    if (!(std::fabs(total - 1) <= 0.001)) fail(CLQ_ARGUMENT, "the shares add up to %g, not to 1", total);
    if (!(def.metres_per_unit > 0 && std::isfinite(def.metres_per_unit)))
        fail(CLQ_ARGUMENT, "metres_per_unit is %g: above 0 is wanted", double(def.metres_per_unit));
}

}  // namespace

void clq_stage_set_movement(clq_stage *stage, std::unique_ptr<stage::Movement> movement)
{
    stage->director.movement = std::move(movement);
}

extern "C" {

clq_status clq_stage_create(clq_context *context, const clq_stage_def *def, clq_stage **out)
{
    return stage::boundary("clq_stage_create", [&] {
        stage::require(context && out, "context or out is NULL");
        clq_stage_def wanted = clq_stage_def_init();
        if (def) {
            stage::require_size(*def, "clq_stage_def_init");
            wanted = *def;
        }
        check_stage_def(wanted);
        *out = new clq_stage(context, wanted);
    });
}

void clq_stage_destroy(clq_stage *stage) { delete stage; }

clq_status clq_stage_step(clq_stage *stage, double until_s)
{
    return stage::boundary("clq_stage_step", [&] {
        stage::require(stage != nullptr, "stage is NULL");
        stage::require_finite(until_s, "until_s");
        const stage::Deciding deciding(stage);
        stage->director.step(until_s);
    });
}

double clq_stage_get_decided_s(const clq_stage *stage) { return stage ? stage->director.handover.decided_s() : 0; }

clq_status clq_stage_apply(clq_stage *stage, clq_crowd *crowd, double time_s, clq_stage_applied *out)
{
    return stage::boundary("clq_stage_apply", [&] {
        stage::require(stage && crowd, "stage or crowd is NULL");
        stage::require_finite(time_s, "time_s");
        if (out) stage::require_size(*out, "clq_stage_applied_init");
        const stage::Only only(stage->is_applying, "drawing flow");
        const double decided_s = stage->director.handover.decided_s();
        if (stage->director.def.mode == CLQ_STAGE_REPRODUCIBLE && time_s > decided_s)
            fail(CLQ_ARGUMENT, "time_s is %.6g, and only what happens up to %.6g is decided", time_s, decided_s);
        clq_stage_applied applied = clq_stage_applied_init();
        applied.behind_s = time_s > decided_s ? time_s - decided_s : 0;
        stage->shown.apply(stage->director.handover, crowd, time_s, applied);
        if (out) *out = applied;
    });
}

clq_status clq_stage_get_info(const clq_stage *stage, clq_stage_info *out)
{
    return stage::boundary("clq_stage_get_info", [&] {
        stage::require(stage && out, "stage or out is NULL");
        stage::require_size(*out, "clq_stage_info_init");
        const std::lock_guard<std::mutex> lock(stage->info_mutex);
        *out = stage->info;
    });
}

}  // extern "C"
