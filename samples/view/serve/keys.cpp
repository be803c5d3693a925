#include "samples/view/serve/keys.h"

namespace view::serve
{
namespace
{

constexpr uint32_t unicode = 0x01000000;  // added to a code point by X11

int code_of(uint32_t symbol)
{
    static const std::pair<uint32_t, int> named[] = {
        {0xff08, key::backspace}, {0xff09, key::tab},  {0xff0d, key::enter},   {0xff8d, key::enter},
        {0xff1b, key::escape},    {0xff50, key::home}, {0xff51, key::left},    {0xff52, key::up},
        {0xff53, key::right},     {0xff54, key::down}, {0xff55, key::page_up}, {0xff56, key::page_down},
        {0xff57, key::end},       {0xffff, key::del}};
    for (const auto &[known, ours] : named)
        if (symbol == known) return ours;
    if (symbol >= 'a' && symbol <= 'z') return static_cast<int>(symbol) - 'a' + 'A';
    return symbol >= ' ' && symbol < 127 ? static_cast<int>(symbol) : 0;
}

// UTF-8 of a printable symbol; empty for others.
std::string text_of(uint32_t symbol)
{
    const bool latin = (symbol >= 0x20 && symbol <= 0x7e) || (symbol >= 0xa0 && symbol <= 0xff);
    const uint32_t point = latin ? symbol : symbol - unicode;
    if (!latin && (symbol < unicode + 0x100 || point > 0x10ffff || (point >= 0xd800 && point <= 0xdfff))) return "";
    if (point < 0x80) return {static_cast<char>(point)};
    std::string text;
    const int more = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
    const unsigned first[] = {0, 0xc0, 0xe0, 0xf0};
    text += static_cast<char>(first[more] | (point >> (6 * more)));
    for (int k = more - 1; k >= 0; --k) text += static_cast<char>(0x80 | ((point >> (6 * k)) & 0x3f));
    return text;
}

}  // namespace

void Keys::pointer(int mask, int x, int y)
{
    queue_.push({Event::Kind::move, static_cast<float>(x), static_cast<float>(y)});
    const Button buttons[] = {left_button, middle_button, right_button};
    for (int bit = 0; bit < 5; ++bit) {
        const bool down = (mask >> bit & 1) != 0;
        if (down == ((mask_ >> bit & 1) != 0)) continue;
        if (bit < 3) queue_.push({Event::Kind::button, 0, 0, buttons[bit], down});
        else if (down) queue_.push({Event::Kind::wheel, 0, bit == 3 ? 1.0f : -1.0f});
    }
    mask_ = mask;
}

void Keys::modifier(Event::Kind kind, bool down)
{
    (kind == Event::Kind::shift ? shift_ : control_) = down;
    queue_.push({kind, 0, 0, 0, down});
}

void Keys::key(uint32_t symbol, bool down)
{
    if (symbol == 0xffe1 || symbol == 0xffe2) return modifier(Event::Kind::shift, down);
    if (symbol == 0xffe3 || symbol == 0xffe4) return modifier(Event::Kind::control, down);
    const int code = code_of(symbol);
    if (code != 0) {
        // A viewer repeats a key that is held.
        const bool held = held_.count(code) != 0;
        if (down != held) queue_.push({Event::Kind::key, 0, 0, code, down});
        if (down) held_.insert(code);
        else held_.erase(code);
    }
    if (const std::string text = text_of(symbol); down && !control_ && !text.empty())
        queue_.push({Event::Kind::text, 0, 0, 0, false, text});
}

void Keys::release()
{
    for (const int code : held_) queue_.push({Event::Kind::key, 0, 0, code, false});
    held_.clear();
    const Button buttons[] = {left_button, middle_button, right_button};
    for (int bit = 0; bit < 3; ++bit)
        if ((mask_ >> bit & 1) != 0) queue_.push({Event::Kind::button, 0, 0, buttons[bit], false});
    mask_ = 0;
    if (shift_) modifier(Event::Kind::shift, false);
    if (control_) modifier(Event::Kind::control, false);
}

}  // namespace view::serve
