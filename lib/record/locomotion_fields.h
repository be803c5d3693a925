// The clips and nodes of a locomotion in a record: one list of fields for writing and reading.
#pragma once

#include "lib/track/locomotion.h"

namespace claque::record
{

template <class Archive, class Clips>
void walk_clips(Archive &a, Clips &clips)
{
    a.value(clips.walk), a.value(clips.run), a.value(clips.slow), a.value(clips.turn), a.value(clips.idle_count);
    for (auto &idle : clips.idles) a.value(idle);
    for (auto &leg : clips.legs)
        for (auto &node : leg) a.value(node);
    a.value(clips.torso), a.value(clips.neck), a.value(clips.head);
}

}  // namespace claque::record
