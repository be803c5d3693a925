// What happens at a window, told from any thread, as the input of one frame after another.
#pragma once

#include <deque>
#include <mutex>
#include <string>

#include "samples/view/input.h"

namespace view
{

struct Event {
    enum class Kind { move, button, wheel, key, shift, control, text, drop };
    Kind kind = Kind::move;
    float x = 0, y = 0;     // of a move, in pixels; y of a wheel, in notches
    int code = 0;           // of a button or a key
    bool down = false;      // of a button, a key, shift or control
    std::string text = {};  // typed, or the path of a dropped file
};

class InputQueue
{
public:
    void push(const Event &event);
    // Replaces all of `input` but its size and its time by what happened since the last call. What would hide a part of
    // it waits for the next call: a second change of a button or key, a move after a button, a second dropped file.
    void next(Input &input);

private:
    struct Taken {
        std::bitset<key::count> keys;
        bool buttons[button_count] = {};
        bool button = false;
    };
    bool take(const Event &event, Taken &taken);

    std::mutex mutex_;
    std::deque<Event> waiting_;
    Input now_;
};

}  // namespace view
