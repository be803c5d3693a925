#include "lib/crowd/tables.h"

#include <algorithm>

namespace claque::crowd
{

using base::reserve_more;
using model::none;

namespace
{

void push_columns(Tables &tables) noexcept
{
    tables.actors.transforms.emplace_back();
    tables.actors.plays.emplace_back();
    tables.actors.extents.emplace_back();
    tables.actors.bounds.emplace_back();
    tables.groups.of.push_back(none);
    tables.extras.of.push_back(none);
    tables.behaviours.push_row();
    tables.layers.push_row();
    tables.follows.push_row();
}

void free_extra(Extras &extras, uint32_t row) noexcept
{
    if (extras.of[row] == none) return;
    for (uint32_t i = extras.all[extras.of[row]].first_attached; i != none;) {
        const uint32_t next = extras.attached[i].next;
        extras.attached.free(i);
        i = next;
    }
    extras.all.free(extras.of[row]);
    extras.of[row] = none;
}

template <class T>
uint64_t bytes_of_column(const Array<T> &column)
{
    return column.capacity() * sizeof(T);
}

}  // namespace

Tables::Tables(std::pmr::memory_resource *memory, uint64_t crowd_seed)
    : seed(crowd_seed),
      templates(memory),
      colours(memory),
      actors(memory),
      groups(memory),
      extras(memory),
      behaviours(memory),
      layers(memory),
      follows(memory)
{
}

void reserve_row(Tables &tables)
{
    if (tables.actors.all.free_count() > 0) return;
    tables.actors.all.reserve();
    reserve_more(tables.actors.transforms);
    reserve_more(tables.actors.plays);
    reserve_more(tables.actors.extents);
    reserve_more(tables.actors.bounds);
    reserve_more(tables.groups.of);
    reserve_more(tables.extras.of);
    tables.behaviours.reserve_row();
    tables.layers.reserve_row();
    tables.follows.reserve_row();
}

uint32_t take_row(Tables &tables) noexcept
{
    const uint32_t rows = tables.actors.all.size();
    const uint32_t row = tables.actors.all.take();
    if (row == rows) push_columns(tables);
    return row;
}

uint32_t append_row(Tables &tables, uint32_t generation)
{
    reserve_row(tables);
    const uint32_t row = tables.actors.all.append(generation);
    push_columns(tables);
    return row;
}

void free_row(Tables &tables, uint32_t row) noexcept
{
    tables.behaviours.clear_row(row);
    tables.layers.clear_row(row);
    tables.follows.clear_row(row);
    free_extra(tables.extras, row);
    Actors &actors = tables.actors;
    set_watched(actors, row, false);
    const ActorRow &actor = actors.all[row];
    if (actor.colours != none) tables.colours[actor.tmpl].give_back(actor.colours);
    actors.transforms[row] = Transform();
    actors.plays[row] = Play();
    actors.extents[row] = Extent();
    actors.bounds[row] = math::RoughSphere();
    actors.all.free(row);
}

void set_watched(Actors &actors, uint32_t row, bool watched)
{
    const auto at = std::lower_bound(actors.watched.begin(), actors.watched.end(), row);
    const bool there = at != actors.watched.end() && *at == row;
    if (there && !watched) actors.watched.erase(at);
    if (!there && watched) actors.watched.insert(at, row);
}

Extra &make_extra(Tables &tables, uint32_t row)
{
    Extras &extras = tables.extras;
    if (extras.of[row] == none) {
        extras.all.reserve();
        extras.of[row] = extras.all.take();
    }
    return extras.all[extras.of[row]];
}

uint8_t *make_colours(Tables &tables, uint32_t row)
{
    ActorRow &actor = tables.actors.all[row];
    ColourTable &table = tables.colours[actor.tmpl];
    if (actor.colours == none) {
        table.reserve();
        actor.colours = table.take();
    }
    return table.row(actor.colours);
}

uint64_t bytes_of(const Tables &tables)
{
    const Actors &actors = tables.actors;
    uint64_t sum = bytes_of_column(tables.templates) + bytes_of_column(tables.colours) + actors.all.bytes() +
                   bytes_of_column(actors.transforms) + bytes_of_column(actors.plays) +
                   bytes_of_column(actors.extents) + bytes_of_column(actors.bounds) + bytes_of_column(actors.watched) +
                   tables.groups.all.bytes() + bytes_of_column(tables.groups.of) + tables.extras.all.bytes() +
                   tables.extras.attached.bytes() + bytes_of_column(tables.extras.of) + tables.behaviours.bytes() +
                   tables.layers.bytes() + tables.follows.bytes();
    for (const ColourTable &table : tables.colours) sum += table.bytes();
    return sum;
}

}  // namespace claque::crowd
