#include <algorithm>
#include <cassert>
#include <cmath>
#include <new>
#include <stdexcept>

#include "lib/frame/frame.h"
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

double now(const Settings &settings)
{
    return settings.update_budget_ms > 0 ? settings.now.now_s(settings.now.user) : 0;
}

// Averages with the last update: a machine's load changes, but one slow update may be an exception.
void learn_cost(Work &work, double spent_s)
{
    const uint32_t posed = work.caches.counters().animated;
    if (!(work.settings.update_budget_ms > 0) || posed == 0 || !(spent_s > 0)) return;
    const double cost = spent_s / posed;
    work.pose_cost_s = work.pose_cost_s > 0 ? (work.pose_cost_s + cost) / 2 : cost;
}

template <class Step>
const Step &checked(const Step &step)
{
    assert(step.check().ok());
    return step;
}

// The steps in their order (S0 4.2).
void run(const Given &given, Work &work, base::Span<View *const> views)
{
    Stats &stats = work.stats;
    animcache::Caches &caches = work.caches;
    const base::Span<Row> rows(work.rows);
    const double elapsed_s = work.has_last_time ? given.time_s - work.last_time_s : 0;
    if (elapsed_s < 0) work.live_since = given.update - 1;

    // S0 4.3: groups first. Steps 1 and 2: Reference Points, first cull phase.
    const uint32_t tested_count =
        checked(CullGroups{given, work.blocks, base::Span<uint8_t>(work.block_seen), base::Span<GroupRow>(work.groups),
                           base::Span<uint32_t>(work.tested), stats})
            .run();
    const base::Span<const uint32_t> tested(work.tested.data(), tested_count);
    const uint32_t candidate_count = checked(CullRefpoints{given, tested, base::Span<uint8_t>(work.passed),
                                                           base::Span<Candidate>(work.candidates), stats})
                                         .run();
    const base::Span<Candidate> candidates(work.candidates.data(), candidate_count);
    const base::Span<const Candidate> placed(work.candidates.data(), candidate_count);
    const Sights sights{base::Span<ViewVisibility>(work.sights), candidate_count};

    checked(PlaceRoots{given, candidates, stats}).run();     // step 3: Skeleton Roots of the candidates
    checked(CullRoots{given, placed, sights, stats}).run();  // step 4: second cull phase
    checked(ChooseLevels{given, sights, work.live_since, candidates, rows}).run();
    const base::Span<const Row> found(work.rows.data(), rows.count);
    checked(MakeRequests{given, placed, found, caches.key_poses(), work.layers, caches.begin(), stats}).run();

    // S1 4: poses that already show their tick are not evaluated again.
    caches.allocate_poses();
    caches.find_due_poses();
    checked(KeepToBudget{given, std::max(0.0, elapsed_s), work.pose_cost_s, caches, candidates, rows}).run();

    // Step 5: mechanisms write degrees of freedom, from which matrices follow.
    const double begun = now(given.settings);
    checked(Behave{given, placed, found, work.dofs_each, base::Span<uint32_t>(work.behaving),
                   base::Span<float>(work.dofs), caches, stats})
        .run();
    caches.animate(given.jobs);
    const double posed = now(given.settings);

    // Step 6: third cull phase, by Internal Bspheres.
    const uint32_t visible_count =
        checked(CullParts{given, placed, caches, sights, rows, base::Span<uint32_t>(work.visible), stats}).run();
    const base::Span<const uint32_t> visible(work.visible.data(), visible_count);
    const double culled = now(given.settings);
    caches.allocate_vertices();
    caches.find_due_vertices();
    caches.skin(given.jobs);
    learn_cost(work, posed - begun + now(given.settings) - culled);

    // Step 7: lists the visible individuals.
    for (uint32_t v = 0; v < views.count; ++v)
        checked(ListView{given, v, placed, visible, sights, caches, work.listed, work.ordered, *views[v]}).run();

    static_cast<animcache::Counters &>(stats) = caches.counters();
    stats.visible = visible_count;
    stats.frame_bytes = work.bytes();
    checked(CountBands{caches, found, elapsed_s, {stats.bands, band_count}}).run();
}

}  // namespace

base::Status update(const crowd::Crowd &crowd, Frame &frame, base::Span<View *const> views, double time_s,
                    const base::Jobs &jobs) noexcept
{
    if (base::Status status = check(views, time_s); !status.ok()) return status;
    Work &work = frame.work_;
    try {
        work.reserve(crowd, views);
    } catch (const std::bad_alloc &) {
        return base::Status::bad(CLQ_OUT_OF_MEMORY, "no memory for an update of %u actors", crowd.actor_count());
    } catch (const std::length_error &) {
        return base::Status::bad(CLQ_LIMIT, "an update of %u actors is more than can be addressed",
                                 crowd.actor_count());
    }
    const Given given{crowd, work.settings, base::Span<const CameraState>(work.eyes), time_s, ++work.update, jobs};
    run(given, work, views);
    work.last_time_s = time_s;
    work.has_last_time = true;
    return base::Status::good();
}

}  // namespace claque::frame
