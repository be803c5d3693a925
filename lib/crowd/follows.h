// Which actors follow which tracks (lib/track). Only actors that follow one have a row here.
#pragma once

#include <unordered_map>
#include <unordered_set>

#include "lib/base/slot_map.h"
#include "lib/crowd/layers.h"
#include "lib/crowd/transform.h"
#include "lib/track/track.h"

namespace claque::crowd
{

constexpr uint32_t max_earlier_pieces = 3;

struct Follow {
    const track::Track *track = nullptr;  // the newest piece, or the whole track
    // The pieces before it, from the newest to the oldest; null: no more.
    const track::Track *earlier[max_earlier_pieces] = {};
    double start_s = 0;  // the track's own time 0 on the clock of updates
    bool walks = true;   // it plays the track's gait; false: clips of its own while it is moved along the track
    float offset_s = 0;  // of the clips that it stands with
};

class Follows
{
public:
    explicit Follows(std::pmr::memory_resource *memory) : known_(memory), slots_(memory), of_(memory) {}

    // Tracks that actors of this crowd may follow after it was restored; their owner keeps them.
    void add(const track::Track &track);
    // The tracks that no actor follows are known no longer; those that one follows, in `used`. May throw before it
    // changes anything.
    void forget_unused(std::pmr::unordered_set<const track::Track *> &used);
    const track::Track *find(uint64_t hash, const model::Template &tmpl) const;  // null: there is none

    // Rows.
    void reserve_row() { base::reserve_more(of_); }
    void push_row() noexcept { of_.push_back(model::none); }
    void clear_row(uint32_t row) noexcept;
    void reserve_copy(uint32_t from);                    // before copy_row
    void copy_row(uint32_t from, uint32_t to) noexcept;  // `to` is clear
    Follow &make(uint32_t row);                          // the present one, or a new one; may throw
    Follow *of(uint32_t row) { return of_[row] == model::none ? nullptr : &slots_[of_[row]]; }
    uint32_t slot_of(uint32_t row) const { return of_[row]; }  // none: it follows no track
    const Follow *of(uint32_t row) const { return of_[row] == model::none ? nullptr : &slots_[of_[row]]; }

    uint32_t count() const { return slots_.used_count(); }
    uint32_t slot_count() const { return slots_.size(); }
    uint64_t bytes() const;

private:
    std::pmr::unordered_multimap<uint64_t, const track::Track *> known_;  // by hash
    base::SlotMap<Follow> slots_;
    Array<uint32_t> of_;  // by row, of slots_
};

// An actor where its track has it; its scale is its own.
Transform placed_on_track(const track::Motion &motion, float scale) noexcept;

// The piece that shows a time of the track.
inline const track::Track &piece_at(const Follow &follow, double track_time_s) noexcept
{
    const track::Track *piece = follow.track;
    for (const track::Track *earlier : follow.earlier) {
        if (track_time_s >= piece->start_s || !earlier) break;
        piece = earlier;
    }
    return *piece;
}

// How far from where its clips have it a track may move what an actor shows: its feet and, on stairs, its hips.
inline float room_of(const Follow &follow) noexcept
{
    bool climbs = follow.track->climbs;
    for (const track::Track *earlier : follow.earlier) climbs = climbs || (earlier && earlier->climbs);
    return (climbs ? 2 : 1) * follow.track->locomotion->legs[0].max_shift;
}

inline double track_time(const Follow &follow, double time_s) { return time_s - follow.start_s; }

}  // namespace claque::crowd
