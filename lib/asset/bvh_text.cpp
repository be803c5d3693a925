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

void append_utf8(uint32_t c, std::string &out)
{
    const auto put = [&](uint32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (c < 0x80) return put(c);
    if (c >= 0x10000) put(0xf0 | c >> 18), put(0x80 | (c >> 12 & 0x3f));
    else if (c >= 0x800) put(0xe0 | c >> 12);
    if (c >= 0x800) put(0x80 | (c >> 6 & 0x3f));
    else put(0xc0 | c >> 6);
    put(0x80 | (c & 0x3f));
}

// Half a pair becomes the replacement character, as in other readers.
std::string utf8_of(const uint8_t *bytes, size_t size)
{
    const size_t high = bytes[0] == 0xfe ? 0 : 1, units = size / 2;
    const auto unit = [&](size_t i) { return uint32_t(bytes[2 * i + high]) << 8 | bytes[2 * i + 1 - high]; };
    std::string out;
    out.reserve(units);
    for (size_t i = 1; i < units; ++i) {
        const uint32_t c = unit(i), low = i + 1 < units ? unit(i + 1) : 0;
        if (c >= 0xd800 && c < 0xdc00 && low >= 0xdc00 && low < 0xe000)
            append_utf8(0x10000 + ((c - 0xd800) << 10 | (low - 0xdc00)), out), ++i;
        else append_utf8(c >= 0xd800 && c < 0xe000 ? 0xfffd : c, out);
    }
    return out;
}

}  // namespace

bool is_utf16(const uint8_t *bytes, size_t size)
{
    return size >= 2 && ((bytes[0] == 0xff && bytes[1] == 0xfe) || (bytes[0] == 0xfe && bytes[1] == 0xff));
}

BvhText::BvhText(const uint8_t *bytes, size_t size)
    : begin_(reinterpret_cast<const char *>(bytes)), at_(begin_), end_(begin_ + size)
{
    if (is_utf16(bytes, size)) {
        decoded_ = utf8_of(bytes, size);
        begin_ = at_ = decoded_.data(), end_ = at_ + decoded_.size();
    } else if (size >= 3 && bytes[0] == 0xef && bytes[1] == 0xbb && bytes[2] == 0xbf) begin_ = at_ += 3;  // its mark
}

void BvhText::refuse(const std::string &what) const { base::fail(CLQ_FORMAT, "line %u: %s", line_, what.c_str()); }

// The format has no comments; some exporters write lines that begin with #.
bool BvhText::at_comment() const
{
    if (at_ == end_ || *at_ != '#') return false;
    const char *before = at_;
    while (before > begin_ && (before[-1] == ' ' || before[-1] == '\t')) --before;
    return before == begin_ || before[-1] == '\n' || before[-1] == '\r';
}

void BvhText::skip_blanks()
{
    for (;;) {
        for (; at_ < end_ && is_blank(*at_); ++at_)
            if (*at_ == '\n') ++line_;
        if (!at_comment()) return;
        while (at_ < end_ && *at_ != '\n') ++at_;
    }
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
