// The index of a record: what a player must know of all of it, so that it reads the rest only where it plays.
#pragma once

#include <cmath>

#include "lib/model/template.h"
#include "lib/record/format.h"

namespace claque::record
{

using model::Array;

// A state, and what begins with its block.
struct IndexedState {
    uint64_t at = 0, block_at = 0;  // of the entry, and of the header of its block
    uint32_t block = 0;
    uint64_t steps_before = 0;         // steps in the blocks before its own
    double earliest_s = HUGE_VAL;      // the earliest time of the steps from its block on
    uint32_t first_run = 0, runs = 0;  // of the tracks that it follows
};

// Numbers of tracks that follow each other.
struct TrackRun {
    uint32_t first = 0, count = 0;
};

struct Index {
    explicit Index(std::pmr::memory_resource *memory) : tracks(memory), states(memory), runs(memory) {}
    uint64_t bytes() const  // held
    {
        return tracks.capacity() * sizeof(uint64_t) + states.capacity() * sizeof(IndexedState) +
               runs.capacity() * sizeof(TrackRun);
    }
    uint64_t step_count = 0, call_count = 0;
    double end_s = 0;        // the latest time of a step
    Array<uint64_t> tracks;  // the places of their entries
    Array<IndexedState> states;
    Array<TrackRun> runs;
    // Behind these come the entries of the crowd's definition, the templates and the locomotions, once more.
};

template <class A, class T>
void walk_index(A &a, T &index)
{
    a.value(index.step_count), a.value(index.call_count), a.value(index.end_s);
    a.array(index.tracks, 8, [&](auto &at) { a.value(at); });
    a.array(index.states, 44, [&](auto &s) {
        a.value(s.at), a.value(s.block_at), a.value(s.block), a.value(s.steps_before), a.value(s.earliest_s);
        a.value(s.first_run), a.value(s.runs);
    });
    a.array(index.runs, 8, [&](auto &run) { a.value(run.first), a.value(run.count); });
}

// Throws base::Error (CLQ_FORMAT): the index of a record `otherwise`.
void require_index(bool good, const char *otherwise);

// What the end holds.
constexpr uint32_t end_bytes = 12;

}  // namespace claque::record
