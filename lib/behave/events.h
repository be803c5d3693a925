// What happens in actors' clips between two moments: a function of time and commands, as poses are, and so independent of who
// is seen and of what was asked before.
#pragma once

#include "lib/behave/behave.h"

namespace claque::behave
{

// In the order in which those of one moment and one actor stand.
enum class EventKind : uint8_t { marker = 0, clip_end = 1, fade_end = 2, layer_end = 3 };

struct Event {
    double time_s = 0;
    uint32_t row = 0;
    EventKind kind = EventKind::marker;
    uint32_t clip = model::none;
    uint32_t marker = model::none;  // of the rig
    uint64_t round = 0;
    uint32_t layer = 0;  // a gesture's serial
};

constexpr size_t max_events = 1000000;  // in one interval

// Those after from_s, up to and with to_s, of all who are watched, in their order; `out` is emptied first. Throws base::Error
// (CLQ_LIMIT: more than most_events) or std::bad_alloc.
void find_events(const crowd::Crowd &crowd, double from_s, double to_s, model::Array<Event> &out);

}  // namespace claque::behave
