#include "samples/view/input_queue.h"

namespace view
{
namespace
{

constexpr size_t most_waiting = 4000;  // a window takes some hundred in a second

}  // namespace

void InputQueue::push(const Event &event)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    if (event.kind == Event::Kind::move && !waiting_.empty() && waiting_.back().kind == Event::Kind::move) {
        waiting_.back() = event;
        return;
    }
    if (waiting_.size() == most_waiting) {
        // What is held is let go, so that nothing stays pressed whose end was left out.
        waiting_.clear();
        for (bool &button : now_.buttons) button = false;
        now_.keys.reset();
        now_.shift = now_.control = false;
    }
    waiting_.push_back(event);
}

// Returns false where the event waits.
bool InputQueue::take(const Event &event, Taken &taken)
{
    const auto code = static_cast<size_t>(event.code);
    switch (event.kind) {
        case Event::Kind::move:
            if (taken.button) return false;
            now_.mouse_x = event.x, now_.mouse_y = event.y;
            break;
        case Event::Kind::button:
            if (code >= button_count) break;
            if (taken.buttons[code]) return false;
            taken.button = taken.buttons[code] = true;
            now_.buttons[code] = event.down;
            break;
        case Event::Kind::wheel:
            now_.wheel += event.y;
            break;
        case Event::Kind::key:
            if (code >= key::count) break;
            if (taken.keys[code]) return false;
            taken.keys[code] = true;
            now_.keys[code] = event.down;
            break;
        case Event::Kind::shift:
            now_.shift = event.down;
            break;
        case Event::Kind::control:
            now_.control = event.down;
            break;
        case Event::Kind::text:
            now_.text += event.text;
            break;
        case Event::Kind::drop:
            if (!now_.dropped.empty()) return false;
            now_.dropped = event.text;
    }
    return true;
}

void InputQueue::next(Input &input)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    now_.wheel = 0;
    now_.text.clear();
    now_.dropped.clear();
    Taken taken;
    while (!waiting_.empty() && take(waiting_.front(), taken)) waiting_.pop_front();
    now_.width = input.width, now_.height = input.height;
    now_.elapsed_s = input.elapsed_s;
    input = now_;
}

}  // namespace view
