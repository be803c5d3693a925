#include "lib/asset/trajectories/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace claque::asset
{

namespace
{

constexpr size_t most_fields = 256;

bool is_gap(char c) { return c == ' ' || c == '\t'; }

}  // namespace

Lines::Lines(std::string_view text) : text_(text)
{
    if (starts_with(text_, "\xef\xbb\xbf")) at_ = begin_ = 3;
}

bool Lines::next(std::string_view &line)
{
    if (at_ >= text_.size()) return false;
    begin_ = at_;
    const size_t end = text_.find('\n', at_);
    unfinished_ = end == std::string_view::npos;
    line = text_.substr(at_, unfinished_ ? end : end - at_);
    at_ = unfinished_ ? text_.size() : end + 1;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number_;
    return true;
}

char separator_of(std::string_view line)
{
    if (line.find(';') != std::string_view::npos) return ';';
    return line.find(',') != std::string_view::npos ? ',' : blanks;
}

void Fields::split(std::string_view line, char separator)
{
    at_.clear();
    size_t at = 0;
    const auto ends = [&](char c) { return separator == blanks ? is_gap(c) : c == separator; };
    while (at_.size() < most_fields) {
        while (at < line.size() && is_gap(line[at])) ++at;
        if (separator == blanks && at >= line.size()) return;
        size_t end = at;
        if (at < line.size() && line[at] == '"') {
            end = std::min(line.find('"', at + 1), line.size() - 1);
            at_.push_back(line.substr(at + 1, end > at ? end - at - 1 : 0));
            while (end < line.size() && !ends(line[end])) ++end;
        } else {
            while (end < line.size() && !ends(line[end])) ++end;
            at_.push_back(trimmed(line.substr(at, end - at)));
        }
        if (end >= line.size()) return;
        at = end + 1;
    }
}

int Fields::find(std::string_view name) const
{
    const auto found = std::find(at_.begin(), at_.end(), name);
    return found == at_.end() ? -1 : static_cast<int>(found - at_.begin());
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && is_gap(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_gap(text.back())) text.remove_suffix(1);
    return text;
}

bool starts_with(std::string_view text, std::string_view begin) { return text.substr(0, begin.size()) == begin; }

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

std::string lower_case(std::string_view text)
{
    std::string out(text);
    for (char &c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

std::string in_quotes(std::string_view text)
{
    std::string out = "'";
    for (const char c : text.substr(0, 40)) out += c >= ' ' && c < 127 ? c : '?';
    return out + (text.size() > 40 ? "...'" : "'");
}

bool read_number(std::string_view text, double &out)
{
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) return false;
    if (error == std::errc()) return true;
    // 1e-400 or 1e400: the sign of the exponent decides.
    out = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos ? 0 : HUGE_VAL;
    return true;
}

std::string_view plain_id(std::string_view text, char (&buffer)[32])
{
    if (text.find_first_of(".eE") == std::string_view::npos) return text;
    double value = 0;
    if (!read_number(text, value) || !(std::fabs(value) < 9e15) || value != std::floor(value)) return text;
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, static_cast<int64_t>(value));
    return std::string_view(buffer, static_cast<size_t>(end - buffer));
}

}  // namespace claque::asset
