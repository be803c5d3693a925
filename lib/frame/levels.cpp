// S1 4, S0 5: computes one eyeDistance for each individual, from which its rate and tick follow. The effective distance
// selects the geometric, skeletal and behavioural levels.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include "lib/base/hash.h"
#include "lib/frame/steps.h"

namespace claque::frame
{

namespace
{

constexpr double turning_reach = 0.3;  // of the Sklsroot radius: how far from the axis the feet of a body stand

// The last level whose distance is reached, or the finest.
uint32_t level_at(const model::Template &tmpl, float distance_m)
{
    uint32_t level = 0;
    while (level + 1 < tmpl.levels.size() && tmpl.levels[level + 1].switch_distance_m <= distance_m) ++level;
    return level;
}

}  // namespace

// With hysteresis, an actor returns to a finer level only after a share of the way back.
uint32_t ChooseLevels::level_of(const Row &row, uint32_t crowd_row, float effective_distance_m) const
{
    const model::Template &tmpl = given.crowd.template_of(crowd_row);
    const uint32_t level = level_at(tmpl, effective_distance_m);
    const float hysteresis = given.settings.lod_hysteresis;
    if (hysteresis == 0 || !row.visible_before || level >= row.visibility.level) return level;
    return std::min(row.visibility.level, level_at(tmpl, effective_distance_m / (1 - hysteresis)));
}

// World units a second: an upper bound, the sum of the speeds of the actor, its group, its track and its root path.
double ChooseLevels::speed_of(const Candidate &candidate) const
{
    const crowd::Crowd &crowd = given.crowd;
    const uint32_t row = candidate.row, group = crowd.group_of(row);
    double speed = double(crowd.extent_of(row).speed);
    if (group != model::none) speed += double(crowd.group(group).speed);
    if (crowd.follows().of(row)) speed += motions[crowd.follows().slot_of(row)].limb_speed;
    if (crowd.behaviours().has_root_path_play(row)) {
        const behave::RootSpeed path = behave::root_speed_at(crowd, row, given.time_s);
        const double limbs = turning_reach * double(crowd.extent_of(row).sklsroot);
        speed += (path.speed + path.turn_rad_s * limbs) * std::fabs(double(candidate.root.scale));
    }
    return speed;
}

ChooseLevels::Distances ChooseLevels::distances_of(uint32_t i) const
{
    Distances out;
    // The distances of levels are those at scale 1; twice the scale looks as large at twice the distance.
    const double size = std::max(std::fabs(double(candidates[i].root.scale)), double(FLT_MIN));
    const double wish =
        (1 - double(given.crowd.extent_of(candidates[i].row).priority)) * double(given.settings.lod_scale) / size;
    bool any = false;
    for (uint32_t v = 0; v < given.eyes.count; ++v)
        any = any || visibilities.at(v, i).inside != math::Containment::outside;
    for (uint32_t v = 0; v < given.eyes.count; ++v) {
        const ViewVisibility &visibility = visibilities.at(v, i);
        // Traditional mode also evaluates actors that no view sees, and poses visible ones as actor mode does.
        if (visibility.inside == math::Containment::outside && (any || !given.traditional())) continue;
        const CameraState &eye = given.eyes[v];
        const double scaled = visibility.distance * eye.distance_scale + eye.min_distance;
        const float here = static_cast<float>(std::min(scaled * wish, double(FLT_MAX)));
        if (out.nearest < 0 || visibility.distance < out.nearest) out.nearest = visibility.distance;
        if (out.effective < 0 || here < out.effective) out.effective = here;
        out.shown_from = std::min({out.shown_from, double(visibility.distance), scaled});
    }
    return out;
}

void ChooseLevels::evaluate_candidate(uint32_t i) const
{
    const crowd::Crowd &crowd = given.crowd;
    Candidate &candidate = candidates[i];
    const uint32_t row = candidate.row;
    const crowd::Actor &actor = crowd.actor(row);
    Row &out = rows[candidate.slot];
    const bool was_visible =
        out.visibility.visible && out.generation == actor.generation && out.update + 1 == given.update;
    if (out.generation != actor.generation)
        out.visibility = ActorVisibility(), out.shown_at = 0;  // of an earlier actor in this row
    out.generation = actor.generation;
    out.update = given.update;
    out.candidate = i;

    const Distances distances = distances_of(i);
    out.visibility.visible = distances.nearest >= 0;
    out.visible_before = out.visibility.visible && was_visible;
    if (!out.visibility.visible) return;

    candidate.effective_distance_m = distances.effective * given.settings.caches.metres_per_unit;
    out.visibility.distance = distances.nearest;
    out.visibility.level = level_of(out, row, candidate.effective_distance_m);
    candidate.levels = behave::mechanism_levels(crowd, row, candidate.effective_distance_m,
                                                crowd.template_of(row).levels[out.visibility.level]);
    const animcache::Settings &caches = given.settings.caches;
    const bool each_frame = behave::has_memory(crowd, row) ||
                            caches.key_poses.mode_at(distances.nearest) == animcache::KeyPoseMode::skinned;
    const uint32_t rate_step = each_frame
                                   ? 0
                                   : std::min(animcache::rate_step_of(caches.period, distances.nearest),
                                              animcache::rate_step_of_motion(speed_of(candidate), distances.shown_from,
                                                                             given.settings.motion_tolerance_px));
    const uint64_t id = uint64_t(actor.generation) << 32 | (row + 1);
    const double before_s = out.visibility.shown_s;
    out.visibility.period_s = static_cast<float>(animcache::period_s(rate_step));
    out.visibility.shown_s =
        animcache::tick_s(rate_step, given.time_s, base::hash(crowd.seed(), id, base::Purpose::cache_phase));
    // Clamp the tick to the clip's start: an earlier tick would wrap into a loop that was never played.
    const double begun_s = crowd.play_of(row).start_s;
    if (begun_s <= given.time_s && out.visibility.shown_s < begun_s) out.visibility.shown_s = begun_s;
    const bool bound = given.settings.clock == Clock::live && out.shown_at > live_since;
    if (bound && out.visibility.shown_s < before_s) out.visibility.shown_s = before_s;
    out.shown_at = given.update;
}

bool has_slots(base::Span<const Candidate> candidates, base::Span<const Row> rows)
{
    for (const Candidate &candidate : candidates)
        if (candidate.slot >= rows.count) return false;
    return true;
}

base::Status ChooseLevels::check() const
{
    if (visibilities.candidates != candidates.count ||
        !has_slots({candidates.data, candidates.count}, {rows.data, rows.count}))
        return base::Status::bad(CLQ_ARGUMENT, "no visibility of every candidate, or no room for its results");
    return check_motions(given, motions);
}

void ChooseLevels::run() const
{
    given.for_slices(candidates.count, [this](uint32_t i) { evaluate_candidate(i); });
}

}  // namespace claque::frame
