// The update: the steps in their order, and what happens when one of them fails (S0 4.2, S1 4).
#include <algorithm>
#include <cassert>
#include <cmath>
#include <new>
#include <stdexcept>

#include "lib/frame/frame.h"
#include "lib/frame/step_times.h"
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

// The clock of the budget in milliseconds; none without one.
HostTimer budget_timer(const Settings &settings)
{
    return {settings.update_budget_ms > 0 ? settings.now : HostClock(), "clq_crowd_def.now_s",
            "the update learned nothing of what a pose costs"};
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

// The steps in their order (S0 4.2). Host callbacks that may make an update fail run in choose(), which the update can
// undo: until show() no pose, vertex or list of the last update is overwritten or freed.
class UpdateRun
{
public:
    UpdateRun(const Given &given, Work &work, base::Span<View *const> views)
        : given_(given),
          work_(work),
          views_{views.data, views.count},
          elapsed_s_(work.has_last_time ? given.time_s - work.last_time_s : 0),
          timer_(budget_timer(given.settings)),
          steps_(work.step_clock)
    {
    }

    // Steps 1 and 2, which write only scratch memory. Returns how many individuals passed phase 1.
    uint32_t find();
    uint32_t unseen() const;  // how many of these have no slot yet
    void choose();
    void show();

private:
    void cull();
    base::Span<const uint32_t> tested() const { return {work_.tested.data(), tested_count_}; }
    base::Span<Candidate> candidates() const { return {work_.candidates.data(), candidate_count_}; }
    base::Span<const Candidate> placed() const { return {work_.candidates.data(), candidate_count_}; }
    Visibilities visibilities() const { return {base::Span<ViewVisibility>(work_.visibilities), candidate_count_}; }
    base::Span<const track::Motion> motions() const { return base::Span<const track::Motion>(work_.motions); }
    base::Span<const Row> found() const { return {work_.rows.data(), static_cast<uint32_t>(work_.rows.size())}; }

    const Given &given_;
    Work &work_;
    base::Span<View *const> views_;
    double elapsed_s_;
    HostTimer timer_;
    StepTimer steps_;
    uint32_t considered_ = 0, tested_count_ = 0, candidate_count_ = 0;
    double begun_s_ = 0;
};

// S0 4.3: groups first. Then coarse bounds, Reference Points, and the first cull phase.
uint32_t UpdateRun::find()
{
    considered_ = checked(CullGroups{given_, work_.blocks, base::Span<uint8_t>(work_.block_seen),
                                     base::Span<uint32_t>(work_.tested)})
                      .run();
    tested_count_ =
        checked(CullBounds{given_, base::Span<uint8_t>(work_.passed), {work_.tested.data(), considered_}}).run();
    checked(FollowTracks{given_, tested(), base::Span<track::Motion>(work_.motions)}).run();
    candidate_count_ = checked(CullRefpoints{given_, tested(), motions(), base::Span<uint8_t>(work_.passed)}).run();
    return candidate_count_;
}

uint32_t UpdateRun::unseen() const
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tested_count_; ++i)
        count += work_.passed[i] && work_.seen.slot_of(work_.tested[i]) == model::none;
    return count;
}

// Writes the results of find() to what updates keep. Then steps 3 and 4: Skeleton Roots, second cull phase.
void UpdateRun::cull()
{
    checked(NoteGroups{given_, work_.blocks, base::Span<const uint8_t>(work_.block_seen),
                       base::Span<GroupRow>(work_.groups), work_.stats})
        .run();
    checked(ListCandidates{given_, tested(), base::Span<const uint8_t>(work_.passed), considered_, work_.seen,
                           candidates(), work_.stats})
        .run();
    checked(PlaceRoots{given_, motions(), candidates(), work_.stats}).run();
    checked(CullRoots{given_, placed(), visibilities(), work_.stats}).run();
}

void UpdateRun::choose()
{
    animcache::Caches &caches = work_.caches;
    const base::Span<Row> rows(work_.rows);
    if (elapsed_s_ < 0) work_.live_since = given_.update - 1;
    cull();
    steps_.done(Step::cull);
    if (!given_.host_calls.ok()) return;
    checked(ChooseLevels{given_, visibilities(), motions(), work_.live_since, candidates(), rows}).run();
    checked(MakeRequests{given_, placed(), found(), caches, base::Span<uint8_t>(work_.passed), work_.layers,
                         caches.pending(), work_.stats})
        .run();

    // S1 4: poses that already show their tick are not evaluated again.
    caches.allocate_poses();
    checked(KeepToBudget{given_, std::max(0.0, elapsed_s_), work_.pose_cost_s, caches, candidates(), rows}).run();

    steps_.done(Step::choose);

    // Step 5: mechanisms write degrees of freedom, from which matrices follow.
    begun_s_ = timer_.now();
    checked(Behave{given_, placed(), found(), work_.seen, work_.dofs_each, base::Span<uint32_t>(work_.behaving),
                   base::Span<float>(work_.dofs), caches, work_.stats})
        .run();
    steps_.done(Step::behave);
}

void UpdateRun::show()
{
    animcache::Caches &caches = work_.caches;
    Stats &stats = work_.stats;
    caches.animate(given_.jobs);
    const double posed_s = timer_.now();
    steps_.done(Step::animate);

    // Step 6: third cull phase, by Internal Bspheres.
    const uint32_t visible_count =
        checked(CullParts{given_, placed(), caches, visibilities(), base::Span<Row>(work_.rows),
                          base::Span<uint32_t>(work_.visible), stats})
            .run();
    const base::Span<const uint32_t> visible(work_.visible.data(), visible_count);
    const double culled_s = timer_.now();
    steps_.done(Step::cull_parts);
    caches.allocate_vertices();
    caches.skin(given_.jobs);
    learn_cost(work_, posed_s - begun_s_ + timer_.now() - culled_s);

    steps_.done(Step::skin);

    // Step 7: lists the visible individuals.
    for (uint32_t v = 0; v < views_.count; ++v)
        checked(ListView{given_, v, placed(), visible, visibilities(), caches, work_.listed, work_.ordered, *views_[v]})
            .run();

    steps_.done(Step::list);
    work_.step_times = steps_.times();

    work_.view_changes.note(given_.crowd, placed(), visible);
    static_cast<animcache::Counters &>(stats) = caches.counters();
    stats.visible = visible_count;
    stats.frame_bytes = work_.bytes();
    checked(CountBands{given_, caches, found(), elapsed_s_, {stats.bands, band_count}}).run();
}

// Runs `reserve`, which allocates memory for an update. Returns a status if there is not enough.
template <class Reserve>
base::Status reserving(const crowd::Crowd &crowd, const Reserve &reserve)
{
    try {
        reserve();
    } catch (const std::bad_alloc &) {
        return base::Status::bad(CLQ_OUT_OF_MEMORY, "no memory for an update of %u actors", crowd.actor_count());
    } catch (const std::length_error &) {
        return base::Status::bad(CLQ_LIMIT, "an update of %u actors is more than can be addressed",
                                 crowd.actor_count());
    }
    return base::Status::good();
}

}  // namespace

base::Status update(const crowd::Crowd &crowd, Frame &frame, base::Span<View *const> views, double time_s,
                    const base::Jobs &jobs) noexcept
{
    if (base::Status status = check(views, time_s); !status.ok()) return status;
    Work &work = frame.work_;
    if (base::Status status = reserving(crowd, [&] { work.reserve(crowd, views); }); !status.ok()) return status;
    base::HostCalls host_calls;
    const Given given{crowd, work.settings, base::Span<const CameraState>(work.eyes), time_s, work.update + 1,
                      jobs,  host_calls};
    UpdateRun run(given, work, views);
    const uint32_t found = run.find();
    if (base::Status status = reserving(crowd, [&] { work.reserve_candidates(crowd, views, found, run.unseen()); });
        !status.ok())
        return status;
    work.begin(crowd);
    run.choose();
    if (!host_calls.ok()) {
        work.undo();
        return host_calls.status();
    }
    run.show();
    work.last_time_s = time_s;
    work.has_last_time = true;
    return base::Status::good();
}

}  // namespace claque::frame
