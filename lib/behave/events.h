// Finds the events of actors' clips in an interval of time. They are a function of time and commands, as poses are, and
// do not depend on visibility or on earlier queries.
#pragma once

#include "lib/behave/behave.h"

namespace claque::behave
{

// In the order of the events of one actor at one time.
enum class EventKind : uint8_t { marker = 0, clip_end = 1, fade_end = 2, layer_end = 3, step = 4, stand = 5 };

struct Event {
    double time_s = 0;
    uint32_t row = 0;
    EventKind kind = EventKind::marker;
    uint32_t clip = model::none;
    uint32_t marker = model::none;  // index of the rig; of a step: 0 left, 1 right
    uint64_t round = 0;
    uint32_t layer = 0;  // the layer's identity
};

constexpr size_t max_events = 1000000;  // in one interval

// The sorted events of all watched actors after from_s, up to and including to_s. `out` is emptied first. Throws
// base::Error (CLQ_LIMIT: more than max_events) or std::bad_alloc.
void find_events(const crowd::Crowd &crowd, double from_s, double to_s, model::Array<Event> &out);

}  // namespace claque::behave
