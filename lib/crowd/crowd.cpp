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

}  // namespace

void check_play(const Play &play, const model::Template &tmpl)
{
    if (play.clip != model::none && play.clip >= tmpl.rig.clips.size())
        fail(CLQ_ARGUMENT, "clip %u of %zu of template '%s'", play.clip, tmpl.rig.clips.size(), tmpl.name.c_str());
    if (!std::isfinite(play.start_s) || !std::isfinite(play.speed) || !std::isfinite(play.phase_s))
        fail(CLQ_ARGUMENT, "start, speed and phase of a clip are %g, %g and %g: they must be finite", play.start_s,
             double(play.speed), double(play.phase_s));
}

Crowd::Crowd(std::pmr::memory_resource *memory, uint64_t seed)
    : seed_(seed),
      templates_(memory),
      colours_(memory),
      actors_(memory),
      transforms_(memory),
      groups_of_(memory),
      groups_(memory),
      plays_(memory),
      extents_(memory),
      extras_of_(memory),
      extras_(memory),
      attached_(memory),
      behaviours_(memory),
      layers_(memory),
      watched_(memory)
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

void Crowd::reserve_row()
{
    if (first_free_ != model::none) return;
    if (actors_.size() >= max_rows) fail(CLQ_LIMIT, "a crowd holds at most %u actors", max_rows);
    reserve_one(actors_);
    reserve_one(transforms_);
    reserve_one(groups_of_);
    reserve_one(plays_);
    reserve_one(extents_);
    reserve_one(extras_of_);
    behaviours_.reserve_row();
    layers_.reserve_row();
}

uint32_t Crowd::take_row()
{
    ++alive_;
    ++structure_version_;
    if (first_free_ != model::none) {
        const uint32_t row = first_free_;
        first_free_ = actors_[row].tmpl;
        return row;
    }
    actors_.emplace_back();
    transforms_.emplace_back();
    groups_of_.push_back(model::none);
    plays_.emplace_back();
    extents_.emplace_back();
    extras_of_.push_back(model::none);
    behaviours_.push_row();
    layers_.push_row();
    return static_cast<uint32_t>(actors_.size() - 1);
}

Id Crowd::create(const model::Template &tmpl, const Transform &transform, const Play &play, uint64_t seed)
{
    const Transform placed = checked(transform);
    check_play(play, tmpl);
    const Play playing = play;  // which may be a column's, and columns grow below
    const uint32_t index =
        static_cast<uint32_t>(std::find(templates_.begin(), templates_.end(), &tmpl) - templates_.begin());
    reserve_row();
    if (index == templates_.size()) {
        reserve_one(templates_);
        reserve_one(colours_);
    }

    // Committed from here on: nothing below can fail.
    if (index == templates_.size()) {
        templates_.push_back(&tmpl);
        colours_.emplace_back(templates_.get_allocator().resource(), tmpl.zone_count());
    }
    const uint32_t row = take_row();
    actors_[row] = Actor{index, actors_[row].generation + 1, seed, next_version_++, model::none, 0};
    transforms_[row] = placed;
    plays_[row] = playing;
    extents_[row].priority = 0;
    measure(row);
    return id_of(row);
}

Id Crowd::clone(Id id, const Transform *transform, uint64_t seed)
{
    const uint32_t from = row_of(id);
    const Transform placed = checked(transform ? *transform : transforms_[from]);
    const uint32_t rows = row_count();
    const Id made = create(template_of(from), placed, plays_[from], seed);
    const uint32_t row = made.index1 - 1;
    try {
        behaviours_.copy_row(from, row);
        layers_.copy_row(from, row);
        if (const Extra *extra = extra_of(from)) {
            const Extra original = *extra;
            Extra &own = extras_[extra_slot(row)];
            own.hooks = original.hooks;
            own.max_up = original.max_up, own.max_down = original.max_down;
        }
        if (const uint8_t *rgb = zone_rgb(from)) {
            const uint32_t slot = colour_slot(row);
            ColourTable &table = colours_[actors_[row].tmpl];
            std::copy(rgb, rgb + table.stride(), table.row(slot));
        }
    } catch (...) {
        take_back(row, rows);
        throw;
    }
    extents_[row].priority = extents_[from].priority;
    actors_[row].texture_set = actors_[from].texture_set;
    if (groups_of_[from] != model::none) {
        groups_of_[row] = groups_of_[from];
        ++groups_[groups_of_[row]].members;
        ++structure_version_;
    }
    measure(row);
    return made;
}

void Crowd::take_back(uint32_t row, uint32_t rows_before)
{
    const uint32_t generation = actors_[row].generation - 1;
    destroy(id_of(row));
    actors_[row].generation = generation;
    first_free_ = row < rows_before ? row : actors_[row].tmpl;
    if (row < rows_before) return;
    actors_.pop_back(), transforms_.pop_back(), groups_of_.pop_back(), plays_.pop_back();
    extents_.pop_back(), extras_of_.pop_back(), behaviours_.pop_row(), layers_.pop_row();
}

void Crowd::destroy(Id id)
{
    const uint32_t row = row_of(id);
    leave(row);
    behaviours_.clear_row(row);
    layers_.clear_row(row);
    watch(id, false);
    clear_extra(row);
    Actor &actor = actors_[row];
    if (actor.colours != model::none) colours_[actor.tmpl].give_back(actor.colours);
    actor = Actor{first_free_, actor.generation + 1, 0, 0, model::none, 0};
    transforms_[row] = Transform();
    plays_[row] = Play();
    extents_[row] = Extent();
    // A row whose generations are used up stays empty, so that no old id comes to life again.
    if (actor.generation != 0xfffffffeu) first_free_ = row;
    --alive_;
    ++structure_version_;
}

void Crowd::attach_mechanism(Id id, const MechanismAttachment &attachment)
{
    const uint32_t row = row_of(id);
    if (attachment.mechanism >= behaviours_.mechanism_count())
        fail(CLQ_ARGUMENT, "mechanism %u of %u", attachment.mechanism + 1, behaviours_.mechanism_count());
    const model::Template *tmpl = behaviours_.mechanism(attachment.mechanism).tmpl;
    if (tmpl != &template_of(row))
        fail(CLQ_ARGUMENT, "mechanism %u is of template '%s', the actor of '%s'", attachment.mechanism + 1,
             tmpl ? tmpl->name.c_str() : "(none)", template_of(row).name.c_str());
    if (!std::isfinite(attachment.priority) || !std::isfinite(attachment.phase_s) || !std::isfinite(attachment.start_s))
        fail(CLQ_ARGUMENT, "priority, phase and start of a mechanism's use are %g, %g and %g: they must be finite",
             double(attachment.priority), double(attachment.phase_s), attachment.start_s);
    behaviours_.attach_mechanism(row, attachment);
    new_version(row);
    measure(row);
}

void Crowd::detach_mechanism(Id id, uint32_t mechanism)
{
    const uint32_t row = row_of(id);
    behaviours_.detach_mechanism(row, mechanism);
    new_version(row);
    measure(row);
}

CommandHistory &Crowd::command_history(Id id, uint32_t mechanism)
{
    const uint32_t row = row_of(id);
    CommandHistory &command_history = behaviours_.command_history(row, mechanism);
    new_version(row);
    return command_history;
}

void Crowd::play(Id id, const Play &play)
{
    const uint32_t row = row_of(id);
    const Source playing = source(row, play, model::none, 0);
    if (layers_.of(row)) return this->play(id, playing);
    plays_[row] = play;
    new_version(row);
}

void Crowd::set_transforms(const Id *ids, const Transform *transforms, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        row_of(ids[i]);
        checked(transforms[i]);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = ids[i].index1 - 1;
        transforms_[row] = transforms[i];
        touch_group(row);
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
    uint64_t sum = actors_.capacity() * sizeof(Actor) + transforms_.capacity() * sizeof(Transform) +
                   plays_.capacity() * sizeof(Play) + groups_of_.capacity() * sizeof(uint32_t) +
                   groups_.capacity() * sizeof(Group) + templates_.capacity() * sizeof(void *) +
                   colours_.capacity() * sizeof(ColourTable) + extents_.capacity() * sizeof(Extent) +
                   extras_of_.capacity() * sizeof(uint32_t) + extras_.capacity() * sizeof(Extra) +
                   attached_.capacity() * sizeof(Attachment) + behaviours_.bytes() + layers_.bytes() +
                   watched_.capacity() * sizeof(uint32_t);
    for (const ColourTable &table : colours_) sum += table.bytes();
    return sum;
}

}  // namespace claque::crowd
