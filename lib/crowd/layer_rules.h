// The rules of plays, fades and layers, for commands and for restored states. Each throws base::Error.
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::crowd
{

void check_length(const char *what, float length_s);
void check_moment(double at_s);
void check_share(float share);
void check_source(const Crowd &crowd, uint32_t row, const Source &source);  // of any content
void check_layer(const Crowd &crowd, uint32_t row, const Layer &layer);
void check_inertial(const LayerState &layer_state, const Source &to);  // inertial fades need one clip on both sides
void check_layering(const Crowd &crowd, uint32_t row, const LayerState &layer_state);  // of any content

// Whether at most max_active_clips clips can run together.
inline bool fits(const LayerState &layer_state) { return layer_state.max_clip_count() <= max_active_clips; }
[[noreturn]] void refuse_layers(double at_s);

// Removes the fades and layers that are over at a time.
void forget_before(LayerState &layer_state, double at_s);

// The state after `add`, which returns false if there is no room. Finished fades and layers are kept until their room
// is needed, because the host may ask for earlier times.
template <class Add>
LayerState with_room(const LayerState &before, double at_s, const Add &add)
{
    LayerState wanted = before;
    if (add(wanted) && fits(wanted)) return wanted;
    wanted = before;
    forget_before(wanted, at_s);
    if (add(wanted) && fits(wanted)) return wanted;
    refuse_layers(at_s);
}

// How an actor's layer state is read and replaced.
LayerState layer_state_of(const Crowd &crowd, uint32_t row);
void change(Crowd &crowd, uint32_t row,
            const LayerState &wanted);  // may throw std::bad_alloc and changes nothing then

}  // namespace claque::crowd
