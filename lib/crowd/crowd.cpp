#include "lib/crowd/crowd.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/reserve.h"

namespace claque::crowd
{

using base::fail;

namespace
{

constexpr uint32_t max_rows = 1u << 28;

Play checked(const Play &play, const model::Template &tmpl)
{
    if (play.clip != model::none && play.clip >= tmpl.rig.clips.size())
        fail(CLQ_ARGUMENT, "clip %u of %zu of template '%s'", play.clip, tmpl.rig.clips.size(), tmpl.name.c_str());
    if (!std::isfinite(play.start_s) || !std::isfinite(play.speed) || !std::isfinite(play.phase_s))
        fail(CLQ_ARGUMENT, "start, speed and phase of a clip are %g, %g and %g: they must be finite", play.start_s,
             double(play.speed), double(play.phase_s));
    return play;
}

}  // namespace

Crowd::Crowd(std::pmr::memory_resource *memory, uint64_t seed)
    : seed_(seed),
      templates_(memory),
      colours_(memory),
      actors_(memory),
      places_(memory),
      groups_of_(memory),
      groups_(memory),
      plays_(memory)
{
}

Crowd::~Crowd() = default;

uint32_t Crowd::row_of(Id id) const
{
    const uint32_t row = id.index1 - 1;
    if (id.index1 == 0 || row >= actors_.size() || actors_[row].generation != id.generation || !alive(row))
        fail(CLQ_STALE_ID, "no actor has index %u and generation %u", id.index1, id.generation);
    return row;
}

bool Crowd::has_template(const model::Template &tmpl) const
{
    return std::find(templates_.begin(), templates_.end(), &tmpl) != templates_.end();
}

Id Crowd::create(const model::Template &tmpl, const Place &place, const Play &play, uint64_t seed)
{
    const Place placed = checked(place);
    const Play playing = checked(play, tmpl);
    const uint32_t index =
        static_cast<uint32_t>(std::find(templates_.begin(), templates_.end(), &tmpl) - templates_.begin());
    if (first_free_ == model::none) {
        if (actors_.size() >= max_rows) fail(CLQ_LIMIT, "a crowd holds at most %u actors", max_rows);
        reserve_one(actors_);
        reserve_one(places_);
        reserve_one(groups_of_);
        reserve_one(plays_);
    }
    if (index == templates_.size()) {
        reserve_one(templates_);
        reserve_one(colours_);
    }

    // Committed from here on: nothing below can fail.
    if (index == templates_.size()) {
        templates_.push_back(&tmpl);
        colours_.emplace_back(templates_.get_allocator().resource(), tmpl.zone_count());
    }
    uint32_t row = first_free_;
    if (row == model::none) {
        row = static_cast<uint32_t>(actors_.size());
        actors_.emplace_back();
        places_.emplace_back();
        groups_of_.push_back(model::none);
        plays_.emplace_back();
    } else {
        first_free_ = actors_[row].tmpl;
    }
    Actor &actor = actors_[row];
    actor = Actor{index, actor.generation + 1, seed, next_version_++, model::none};
    places_[row] = placed;
    plays_[row] = playing;
    ++alive_;
    ++structure_version_;
    return id_of(row);
}

void Crowd::destroy(Id id)
{
    const uint32_t row = row_of(id);
    leave(row);
    Actor &actor = actors_[row];
    if (actor.colours != model::none) colours_[actor.tmpl].give_back(actor.colours);
    actor = Actor{first_free_, actor.generation + 1, 0, 0, model::none};
    places_[row] = Place();
    plays_[row] = Play();
    // A row whose generations are used up stays empty, so that no old id comes to life again.
    if (actor.generation != 0xfffffffeu) first_free_ = row;
    --alive_;
    ++structure_version_;
}

void Crowd::play(Id id, const Play &play)
{
    const uint32_t row = row_of(id);
    plays_[row] = checked(play, template_of(row));
    actors_[row].play_version = next_version_++;
}

void Crowd::place(const Id *ids, const Place *places, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        row_of(ids[i]);
        checked(places[i]);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = ids[i].index1 - 1;
        places_[row] = places[i];
        if (groups_of_[row] != model::none) groups_[groups_of_[row]].version = next_version_++;
    }
}

const uint8_t *Crowd::zone_rgb(uint32_t row) const
{
    const Actor &actor = actors_[row];
    return actor.colours == model::none ? nullptr : colours_[actor.tmpl].row(actor.colours);
}

size_t Crowd::colour_bytes() const
{
    size_t bytes = 0;
    for (const ColourTable &table : colours_) bytes += table.colour_bytes();
    return bytes;
}

uint64_t Crowd::bytes() const
{
    uint64_t sum = actors_.capacity() * sizeof(Actor) + places_.capacity() * sizeof(Place) +
                   plays_.capacity() * sizeof(Play) + groups_of_.capacity() * sizeof(uint32_t) +
                   groups_.capacity() * sizeof(Group) + templates_.capacity() * sizeof(void *) +
                   colours_.capacity() * sizeof(ColourTable);
    for (const ColourTable &table : colours_) sum += table.bytes();
    return sum;
}

}  // namespace claque::crowd
