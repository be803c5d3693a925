// Steps that edits of an actor and restoring have in common. The noexcept ones cannot fail.
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::crowd
{

inline void new_version(Crowd &crowd, uint32_t row) noexcept  // the actor's picture may have changed
{
    crowd.tables.actors.all[row].play_version = crowd.next_version++;
}

inline void touch_group(Crowd &crowd, uint32_t row) noexcept
{
    const uint32_t group = crowd.group_of(row);
    if (group != model::none) crowd.tables.groups.all[group].version = crowd.next_version++;
}

void bound(Crowd &crowd, uint32_t row) noexcept;  // renews what Actors::bounds says

inline void note(Crowd &crowd, uint32_t row) noexcept  // that the actor was made, moved or changed, or has gone
{
    bound(crowd, row);
    for (Changes *reader : crowd.readers) reader->mark(reader->rows, row);
}

inline void note_group(Crowd &crowd, uint32_t group) noexcept  // that it has moved
{
    for (Changes *reader : crowd.readers) reader->mark(reader->groups, group);
}

void measure(Crowd &crowd, uint32_t row) noexcept;  // its extent, and that of its group
void enter_group(Crowd &crowd, uint32_t row, uint32_t group) noexcept;
void leave_group(Crowd &crowd, uint32_t row) noexcept;  // keeps the numbers of its transform

void check_attached(const model::Template &tmpl, const Attachment &attached);  // throws base::Error (CLQ_ARGUMENT)
void link_attached(Extra &extra, base::SlotMap<Attachment> &all, uint32_t index) noexcept;

}  // namespace claque::crowd
