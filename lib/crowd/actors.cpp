// Makes, copies, moves and destroys actors.
#include "lib/crowd/actors.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/rows.h"

namespace claque::crowd
{

using base::fail;
using model::none;

namespace
{

void reserve_actor(Crowd &crowd)
{
    Tables &tables = crowd.tables;
    if (!tables.actors.all.has_room()) fail(CLQ_LIMIT, "a crowd holds at most %u actors", tables.actors.all.max_size());
    reserve_row(tables);
    for (Changes *reader : crowd.readers) reader->rows.reserve(crowd.row_capacity());
}

// Makes room for a copy of an actor in all tables.
void reserve_copy(Tables &tables, uint32_t row)
{
    tables.behaviours.reserve_copy(row);
    tables.layers.reserve_copy(row);
    tables.follows.reserve_copy(row);
    if (tables.extras.of[row] != none) tables.extras.all.reserve();
    const ActorRow &actor = tables.actors.all[row];
    if (actor.colours != none) tables.colours[actor.tmpl].reserve();
}

void copy_extra(Extras &extras, uint32_t from, uint32_t to) noexcept
{
    if (extras.of[from] == none) return;
    extras.of[to] = extras.all.take();
    Extra &own = extras.all[extras.of[to]];
    own = extras.all[extras.of[from]];
    own.first_attached = none;
}

void copy_looks(Tables &tables, uint32_t from, uint32_t to) noexcept
{
    ActorRow &actor = tables.actors.all[to];
    const ActorRow &other = tables.actors.all[from];
    actor.texture_set = other.texture_set;
    if (other.colours == none) return;
    ColourTable &table = tables.colours[actor.tmpl];
    actor.colours = table.take();
    const uint8_t *rgb = table.row(other.colours);
    std::copy(rgb, rgb + table.stride(), table.row(actor.colours));
}

}  // namespace

Id create(Crowd &crowd, const model::Template &tmpl, const Transform &transform, const Play &play, uint64_t seed)
{
    const Transform placed = checked(transform);
    check_play(play, tmpl);
    const Play playing = play;  // a copy: `play` may point into a column, and columns grow below
    Tables &tables = crowd.tables;
    const auto known = std::find(tables.templates.begin(), tables.templates.end(), &tmpl);
    const uint32_t index = static_cast<uint32_t>(known - tables.templates.begin());
    const bool is_new = known == tables.templates.end();
    reserve_actor(crowd);
    if (is_new) {
        base::reserve_more(tables.templates);
        base::reserve_more(tables.colours);
    }

    // Commit: nothing below can fail.
    if (is_new) {
        tables.templates.push_back(&tmpl);
        tables.colours.emplace_back(crowd.memory(), tmpl.zone_count());
    }
    const uint32_t row = take_row(tables);
    tables.actors.all[row] = ActorRow{index, seed, crowd.next_version++, none, 0};
    tables.actors.transforms[row] = placed;
    tables.actors.plays[row] = playing;
    ++crowd.structure;
    measure(crowd, row);
    return crowd.id_of(row);
}

Id clone(Crowd &crowd, Id id, const Transform *transform, uint64_t seed)
{
    const uint32_t from = crowd.row_of(id);
    const Transform placed = checked(transform ? *transform : crowd.transform_of(from));
    Tables &tables = crowd.tables;
    reserve_actor(crowd);
    reserve_copy(tables, from);

    // Commit: nothing below can fail.
    const Id made = create(crowd, crowd.template_of(from), placed, crowd.play_of(from), seed);
    const uint32_t row = made.index1 - 1;
    tables.behaviours.copy_row(from, row);
    tables.layers.copy_row(from, row);
    tables.follows.copy_row(from, row);
    copy_extra(tables.extras, from, row);
    copy_looks(tables, from, row);
    tables.actors.extents[row].priority = tables.actors.extents[from].priority;
    tables.actors.extents[row].speed = tables.actors.extents[from].speed;
    if (crowd.group_of(from) != none) enter_group(crowd, row, crowd.group_of(from));
    measure(crowd, row);
    return made;
}

void destroy(Crowd &crowd, Id id)
{
    const uint32_t row = crowd.row_of(id);
    leave_group(crowd, row);
    free_row(crowd.tables, row);
    note(crowd, row);
    ++crowd.structure;
}

void set_transforms(Crowd &crowd, const Id *ids, const Transform *transforms, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        crowd.row_of(ids[i]);
        checked(transforms[i]);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = ids[i].index1 - 1;
        crowd.tables.actors.transforms[row] = transforms[i];
        touch_group(crowd, row);
        note(crowd, row);
    }
}

void set_priority(Crowd &crowd, Id id, float priority)
{
    const uint32_t row = crowd.row_of(id);
    if (!(priority >= 0 && priority <= 1))
        fail(CLQ_ARGUMENT, "a priority of %g: 0 to 1 is wanted", static_cast<double>(priority));
    crowd.tables.actors.extents[row].priority = priority;
}

float checked_speed(float speed)
{
    if (!(speed >= 0 && speed <= 1e9f))
        fail(CLQ_ARGUMENT, "a speed of %g: 0 to 1e9 world units a second are wanted", static_cast<double>(speed));
    return speed;
}

void set_speeds(Crowd &crowd, const Id *ids, const float *speeds, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) crowd.row_of(ids[i]), checked_speed(speeds[i]);
    for (uint32_t i = 0; i < count; ++i) crowd.tables.actors.extents[ids[i].index1 - 1].speed = speeds[i];
}

}  // namespace claque::crowd
