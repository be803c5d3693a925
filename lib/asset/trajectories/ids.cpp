#include "lib/asset/trajectories/ids.h"

#include <algorithm>
#include <cstring>

namespace claque::asset
{

namespace
{

constexpr size_t block_bytes = 16384;
constexpr uint64_t bytes_of_number = 160;  // its node in the map and its places in the arrays

// Length of the UTF-8 character that begins here; 0: none does.
size_t utf8_length(std::string_view text)
{
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const size_t n = byte(0) < 0x80 ? 1 : byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (n > text.size() || (n > 1 && (byte(0) < 0xc2 || byte(0) > 0xf4))) return 0;
    for (size_t i = 1; i < n; ++i)
        if (byte(i) >> 6 != 2) return 0;
    if (n == 3 && (byte(0) == 0xe0 ? byte(1) < 0xa0 : byte(0) == 0xed && byte(1) > 0x9f)) return 0;
    if (n == 4 && (byte(0) == 0xf0 ? byte(1) < 0x90 : byte(0) == 0xf4 && byte(1) > 0x8f)) return 0;
    return n;
}

// Bytes that are not UTF-8 are taken as Latin-1; control bytes become question marks.
std::string utf8_of(std::string_view text)
{
    std::string out;
    while (!text.empty()) {
        const unsigned char first = static_cast<unsigned char>(text[0]);
        const size_t n = utf8_length(text);
        if (first < 0x20 || first == 0x7f) out += '?';
        else if (n) out.append(text.substr(0, n));
        else out += {static_cast<char>(0xc0 | first >> 6), static_cast<char>(0x80 | (first & 0x3f))};
        text.remove_prefix(std::max<size_t>(n, 1));
    }
    return out;
}

bool is_plain(std::string_view id)
{
    return std::all_of(id.begin(), id.end(), [](char c) { return c >= ' ' && c < 0x7f; });
}

}  // namespace

uint32_t Ids::number_of(std::string_view id)
{
    if (last_ < after_.size() && after_[last_] < known_.size() && known_[after_[last_]] == id)
        return last_ = after_[last_];
    if (id.size() > longest)
        base::fail(CLQ_LIMIT, "the id '%.40s...' has %zu bytes: %zu are allowed", std::string(id).c_str(), id.size(),
                   longest);
    std::string other;
    if (!is_plain(id)) id = other = utf8_of(id);
    const auto found = numbers_.find(id);
    const uint32_t number = found != numbers_.end() ? found->second : add(id);
    if (last_ < after_.size()) after_[last_] = number;
    return last_ = number;
}

uint32_t Ids::add(std::string_view id)
{
    if (known_.size() >= 0x7fffffff) base::fail(CLQ_LIMIT, "more than 2147483647 ids");
    budget_->charge(bytes_of_number, "an id");
    const uint32_t number = count();
    const std::string_view kept(keep(id), id.size());
    numbers_.emplace(kept, number);
    known_.push_back(kept);
    after_.push_back(number);  // the same person again
    return number;
}

void Ids::shorten(uint32_t number, size_t bytes)
{
    const std::string_view rest = known_[number].substr(bytes);
    if (numbers_.count(rest) == 0) known_[number] = rest;
}

const char *Ids::keep(std::string_view text)
{
    budget_->charge(text.size() + 1, "an id");
    if (left_ < text.size() + 1) {
        blocks_.push_back(std::make_unique<char[]>(block_bytes));
        free_ = blocks_.back().get(), left_ = block_bytes;
    }
    char *const begin = free_;
    if (!text.empty()) std::memcpy(begin, text.data(), text.size());
    begin[text.size()] = 0;
    free_ += text.size() + 1, left_ -= text.size() + 1;
    return begin;
}

std::string Ids::shown(uint32_t number) const
{
    const std::string_view id = known_[number];
    size_t end = 0;
    while (end < id.size() && end < 40) end += std::max<size_t>(utf8_length(id.substr(end)), 1);
    return "'" + std::string(id.substr(0, end)) + (end < id.size() ? "...'" : "'");
}

}  // namespace claque::asset
