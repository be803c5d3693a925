// What mouse and keyboard of a viewer say in VNC's words, as events.
#pragma once

#include <cstdint>
#include <set>

#include "samples/view/input_queue.h"

namespace view::serve
{

class Keys
{
public:
    explicit Keys(InputQueue &queue) : queue_(queue) {}

    // `mask`: left, middle and right button, wheel away and towards, from the lowest bit.
    void pointer(int mask, int x, int y);
    // `symbol`: of X11.
    void key(uint32_t symbol, bool down);
    // Lets go what this viewer still holds.
    void release();

private:
    void modifier(Event::Kind kind, bool down);

    InputQueue &queue_;
    int mask_ = 0;
    bool control_ = false, shift_ = false;
    std::set<int> held_;
};

}  // namespace view::serve
