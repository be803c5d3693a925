#include "samples/view/tiles/task.h"

#include <cstring>
#include <type_traits>

namespace view::tiles
{
namespace
{

// Both processes are of one program, so values travel as they are.
class Writer
{
public:
    template <class Value>
    Writer &operator<<(const Value &value)
    {
        static_assert(std::is_trivially_copyable_v<Value>);
        text.append(reinterpret_cast<const char *>(&value), sizeof value);
        return *this;
    }
    Writer &operator<<(const std::string &words)
    {
        *this << words.size();
        text += words;
        return *this;
    }

    std::string text;
};

class Reader
{
public:
    explicit Reader(const std::string &text) : text_(text) {}

    template <class Value>
    Reader &operator>>(Value &value)
    {
        static_assert(std::is_trivially_copyable_v<Value>);
        std::memcpy(&value, text_.data() + at_, sizeof value);
        at_ += sizeof value;
        return *this;
    }
    Reader &operator>>(std::string &words)
    {
        size_t size = 0;
        *this >> size;
        words = text_.substr(at_, size);
        at_ += size;
        return *this;
    }

private:
    const std::string &text_;
    size_t at_ = 0;
};

// All members, in one order for both directions.
template <class Stream, class AnyTask>
void pass(Stream &&each, AnyTask &task)
{
    each(task.kind), each(task.tile), each(task.of_px), each(task.film);
    auto &input = task.input;
    each(input.width), each(input.height), each(input.elapsed_s), each(input.mouse_x), each(input.mouse_y);
    each(input.buttons), each(input.wheel), each(input.keys), each(input.shift), each(input.control);
    each(input.text), each(input.dropped);
}

}  // namespace

std::string text_of(const Task &task)
{
    Writer out;
    pass([&out](const auto &member) { out << member; }, task);
    return out.text;
}

Task task_of(const std::string &text)
{
    Task task;
    Reader in(text);
    pass([&in](auto &member) { in >> member; }, task);
    return task;
}

std::string text_of(const Done &done)
{
    Writer out;
    out << done;
    return out.text;
}

Done done_of(const std::string &text)
{
    Done done;
    Reader(text) >> done;
    return done;
}

processes::Tile scaled(const Task &task, int width_px)
{
    const auto column = [&](int x) { return static_cast<int>(static_cast<long long>(x) * width_px / task.of_px); };
    return {column(task.tile.x0), column(task.tile.x1)};
}

}  // namespace view::tiles
