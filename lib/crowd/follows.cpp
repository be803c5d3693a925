#include "lib/crowd/follows.h"

#include "lib/base/error.h"
#include "lib/base/hash.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/layer_rules.h"
#include "lib/crowd/rows.h"
#include "lib/math/trig.h"

namespace claque::crowd
{

using base::fail;
using model::none;

void Follows::add(const track::Track &track)
{
    if (!find(track.hash, *track.locomotion->tmpl)) known_.emplace(track.hash, &track);
}

const track::Track *Follows::find(uint64_t hash, const model::Template &tmpl) const
{
    const auto range = known_.equal_range(hash);
    for (auto at = range.first; at != range.second; ++at)
        if (at->second->locomotion->tmpl == &tmpl) return at->second;
    return nullptr;
}

void Follows::forget_unused(std::pmr::unordered_set<const track::Track *> &used)
{
    for (const uint32_t slot : of_) {
        if (slot == none) continue;
        used.insert(slots_[slot].track);
        for (const track::Track *earlier : slots_[slot].earlier)
            if (earlier) used.insert(earlier);
    }
    for (auto at = known_.begin(); at != known_.end();) at = used.count(at->second) ? std::next(at) : known_.erase(at);
}

void Follows::clear_row(uint32_t row) noexcept
{
    if (of_[row] != none) slots_.free(of_[row]);
    of_[row] = none;
}

void Follows::reserve_copy(uint32_t from)
{
    if (of_[from] != none) slots_.reserve();
}

void Follows::copy_row(uint32_t from, uint32_t to) noexcept
{
    if (of_[from] == none) return;
    of_[to] = slots_.take();
    slots_[of_[to]] = slots_[of_[from]];
}

Follow &Follows::make(uint32_t row)
{
    if (of_[row] == none) {
        slots_.reserve();
        of_[row] = slots_.take();
    }
    return slots_[of_[row]];
}

uint64_t Follows::bytes() const
{
    return known_.size() * (sizeof(*known_.begin()) + sizeof(void *)) + known_.bucket_count() * sizeof(void *) +
           slots_.bytes() + of_.capacity() * sizeof(uint32_t);
}

Transform placed_on_track(const track::Motion &motion, float scale) noexcept
{
    Transform out;
    out.position = motion.position;
    const float half = static_cast<float>(motion.heading_rad * 0.5);
    out.orientation = glm::quat(math::cos(half), 0, math::sin(half), 0);
    out.scale = scale;
    return out;
}

Transform reference_of(const Crowd &crowd, uint32_t row, double time_s)
{
    const Follow *follow = crowd.follows().of(row);
    if (!follow) return crowd.world_transform_of(row);
    const double track_time_s = track_time(*follow, time_s);
    const track::Motion motion = track::motion_at(piece_at(*follow, track_time_s), track_time_s);
    return placed_on_track(motion, crowd.transform_of(row).scale);
}

glm::dvec3 reference_position_of(const Crowd &crowd, uint32_t row, double time_s)
{
    if (const Follow *follow = crowd.follows().of(row)) {
        const double track_time_s = track_time(*follow, time_s);
        return track::position_at(piece_at(*follow, track_time_s), track_time_s);
    }
    const Transform &inner = crowd.transform_of(row);
    const uint32_t group = crowd.group_of(row);
    return group == none ? inner.position : composed_position(crowd.group(group).transform, inner.position);
}

namespace
{

// Whether a track goes on where the followed one ends, on the same clock.
bool continues(const Follow *follow, const track::Track &track, double start_s)
{
    return follow && track.previous_hash != 0 && follow->track->hash == track.previous_hash &&
           follow->start_s == start_s;
}

void push_piece(Follow &follow, const track::Track &track)
{
    for (uint32_t i = max_earlier_pieces; i-- > 1;) follow.earlier[i] = follow.earlier[i - 1];
    follow.earlier[0] = follow.track;
    follow.track = &track;
}

}  // namespace

void follow_track(Crowd &crowd, Id id, const track::Track &track, double start_s)
{
    const uint32_t row = crowd.row_of(id);
    const model::Template &tmpl = crowd.template_of(row);
    check_moment(start_s);
    if (track.locomotion->tmpl != &tmpl)
        fail(CLQ_ARGUMENT, "the track is of template '%s', the actor of '%s'", track.locomotion->tmpl->name.c_str(),
             tmpl.name.c_str());
    if (crowd.group_of(row) != none)
        fail(CLQ_ARGUMENT, "a member of a group cannot follow a track: it must leave its group first");
    Follows &follows = crowd.tables.follows;
    follows.add(track);
    if (continues(follows.of(row), track, start_s)) {
        push_piece(*follows.of(row), track);
        new_version(crowd, row);
        return measure(crowd, row);
    }
    Follow &follow = follows.make(row);
    const uint64_t seed = crowd.actor(row).seed;
    follow = Follow();
    follow.track = &track, follow.start_s = start_s;
    follow.offset_s = 30 * base::unit(base::hash(crowd.seed(), seed, base::Purpose::phase));
    crowd.tables.layers.clear_row(row);
    new_version(crowd, row);
    measure(crowd, row);
}

void leave_track(Crowd &crowd, Id id, double at_s)
{
    const uint32_t row = crowd.row_of(id);
    check_moment(at_s);
    const Follow *follow = crowd.follows().of(row);
    if (!follow) fail(CLQ_ARGUMENT, "the actor follows no track");
    crowd.tables.actors.transforms[row] = reference_of(crowd, row, at_s);
    const track::LocomotionClips &clips = follow->track->locomotion->clips;
    if (follow->walks)
        crowd.tables.actors.plays[row] = {clips.idle_count > 0 ? clips.idles[0] : none, at_s, 1, follow->offset_s};
    crowd.tables.follows.clear_row(row);
    crowd.tables.layers.clear_row(row);
    new_version(crowd, row);
    measure(crowd, row);
}

void fade_to_track(Crowd &crowd, Id id, double at_s, float length_s, Curve curve)
{
    const uint32_t row = crowd.row_of(id);
    if (!crowd.follows().of(row)) fail(CLQ_ARGUMENT, "the actor follows no track");
    Source source;
    source.play = crowd.play_of(row);
    source.gait = track_gait;
    fade_to(crowd, id, source, at_s, length_s, curve);
}

}  // namespace claque::crowd
