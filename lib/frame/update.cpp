#include <cmath>
#include <new>
#include <stdexcept>

#include "lib/frame/steps.h"

namespace claque::frame
{

namespace
{

base::Status check(base::Span<View *const> views, double time_s)
{
    using base::Status;
    if (!std::isfinite(time_s)) return Status::bad(CLQ_ARGUMENT, "the time of an update is not finite");
    for (uint32_t v = 0; v < views.count; ++v) {
        const Camera &camera = views[v]->camera;
        bool good = true;
        float length = 0;
        for (int k = 0; k < 3; ++k) good = good && std::isfinite(camera.eye[k]);
        for (int k = 0; k < 4; ++k) length += camera.rotation[k] * camera.rotation[k];
        for (const float x : camera.projection) good = good && std::isfinite(x);
        if (!good || !std::isfinite(length) || !(length > 0))
            return Status::bad(CLQ_ARGUMENT, "the camera of view %u is not finite or has no rotation", v);
    }
    return Status::good();
}

}  // namespace

base::Status update(const crowd::Crowd &crowd, Frame &frame, base::Span<View *const> views, double time_s,
                    const base::Jobs &jobs) noexcept
{
    if (base::Status status = check(views, time_s); !status.ok()) return status;
    Update update{crowd, frame, views, time_s, jobs};
    try {
        update.reserve();
    } catch (const std::bad_alloc &) {
        return base::Status::bad(CLQ_OUT_OF_MEMORY, "no memory for an update of %u actors", crowd.actor_count());
    } catch (const std::length_error &) {
        return base::Status::bad(CLQ_LIMIT, "an update of %u actors is more than can be addressed",
                                 crowd.actor_count());
    }
    update.cull_groups();     // S0 4.3: groups first
    update.cull_refpoints();  // S0 4.2, steps 1 and 2: Reference Points, first cull phase
    update.place_roots();     // step 3: Skeleton Roots of who is left
    update.cull_roots();      // step 4: second cull phase
    update.choose_levels_and_periods();
    update.find_due();  // S1 4: whose pose is that of its tick already is not asked again
    const double begun = update.now();
    update.behave();   // step 5: behaviour of who is left gives degrees of freedom,
    update.animate();  //         and these give matrices
    const double posed = update.now();
    update.cull_parts();  // step 6: third cull phase, by Internal Bspheres
    const double culled = update.now();
    update.skin();
    update.learn_cost(posed - begun + update.now() - culled);
    update.list();  // step 7: what is inside, and nothing else
    update.count();
    return base::Status::good();
}

}  // namespace claque::frame
