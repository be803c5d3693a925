#include "lib/asset/bvh_text.h"

#include <charconv>
#include <cmath>

#include "lib/base/error.h"

namespace claque::asset
{

namespace
{

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same(std::string_view a, std::string_view b)
{
    if (a.size() != b.size()) return false;
    for (size_t i = 0; i < a.size(); ++i)
        if (lower(a[i]) != lower(b[i])) return false;
    return true;
}

// Quotes a word for a message: short, and without control bytes that a terminal would interpret.
std::string quoted_word(std::string_view word)
{
    std::string text = "'";
    for (const char c : word.substr(0, 30)) text += c >= ' ' && c < 127 ? c : '?';
    return text + (word.size() > 30 ? "...'" : "'");
}

}  // namespace

BvhText::BvhText(const uint8_t *bytes, size_t size) : at_(reinterpret_cast<const char *>(bytes)), end_(at_ + size)
{
    if (size >= 3 && bytes[0] == 0xef && bytes[1] == 0xbb && bytes[2] == 0xbf) at_ += 3;  // byte order mark
}

void BvhText::refuse(const std::string &what) const { base::fail(CLQ_FORMAT, "line %u: %s", line_, what.c_str()); }

void BvhText::skip_blanks()
{
    for (; at_ < end_ && is_blank(*at_); ++at_)
        if (*at_ == '\n') ++line_;
}

bool BvhText::at_end()
{
    skip_blanks();
    return at_ == end_;
}

std::string_view BvhText::peek()
{
    skip_blanks();
    if (at_ == end_) return {};
    const char *last = at_ + 1;
    if (*at_ != '{' && *at_ != '}')
        while (last < end_ && !is_blank(*last) && *last != '{' && *last != '}') ++last;
    return std::string_view(at_, static_cast<size_t>(last - at_));
}

std::string_view BvhText::word()
{
    const std::string_view next = peek();
    at_ += next.size();
    return next;
}

bool BvhText::take(std::string_view wanted)
{
    if (!same(peek(), wanted)) return false;
    word();
    return true;
}

void BvhText::expect(std::string_view wanted)
{
    if (take(wanted)) return;
    const std::string_view found = peek();
    refuse(std::string(wanted) + " is wanted instead of " + (found.empty() ? "the file's end" : quoted_word(found)));
}

void BvhText::expect_label(std::string_view first, std::string_view second)
{
    if (!second.empty()) expect(first);
    const std::string last(second.empty() ? first : second);
    if (take(last + ":")) return;
    expect(last);
    expect(":");
}

std::string BvhText::name()
{
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\t')) ++at_;
    const char *first = at_;
    while (at_ < end_ && *at_ != '\n' && *at_ != '\r' && *at_ != '{' && *at_ != '}') ++at_;
    const char *last = at_;
    while (last > first && is_blank(last[-1])) --last;
    if (last == first) refuse("a joint has no name");
    if (last - first > 200) refuse("a joint's name is longer than 200 bytes");
    return std::string(first, last);
}

double BvhText::number(const char *what)
{
    std::string_view text = peek();
    if (text.empty()) refuse(std::string("the file ends where a number is wanted: ") + what);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || rest != text.data() + text.size() || !std::isfinite(value))
        refuse(std::string(what) + " is " + quoted_word(peek()) + " instead of a number");
    if (error != std::errc()) refuse(std::string(what) + " is " + quoted_word(peek()) + ", which is out of range");
    word();
    return value;
}

uint32_t BvhText::count(const char *what, uint32_t maximum)
{
    const double value = number(what);
    if (!(value >= 0) || value > maximum || value != std::floor(value))
        refuse(base::text_of("%s is %g: a whole number from 0 to %u is wanted", what, value, maximum));
    return static_cast<uint32_t>(value);
}

}  // namespace claque::asset
